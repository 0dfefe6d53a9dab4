// All methods on graphs like those of triangle meshes, against a dynamic program; then the exact solver with many
// terminals, where only its own proof and the bounds can be checked.

#include "dynamic_program.h"
#include "mesh_graphs.h"
#include "steiner_tree_checks.h"

int main()
{
  const unsigned int seed = 20260102;
  std::cout << "seed " << seed << std::endl;
  CGAL::Random random(seed);
  for(int i = 0; i < 300; ++i) {
    const double noise = i % 3 == 0 ? 0. : 0.9; // without noise, ties everywhere
    const Core::Csr_graph graph = grid_graph(random.get_int(2, 16), random.get_int(2, 16), noise, random);
    const int k = random.get_int(2, (std::min)(graph.number_of_vertices(), 8) + 1);
    const std::vector<int> terminals = random_terminals(graph.number_of_vertices(), k, random);
    check_all_methods(graph, terminals, shortest_tree_length(graph, terminals));
  }

  // so large that good trees are looked for in corridors first
  for(double noise : {0., 0.5, 0.9}) {
    const Core::Csr_graph graph = grid_graph(150, 130, noise, random);
    const std::vector<int> terminals = random_terminals(graph.number_of_vertices(), 6, random);
    const Core::Solution exact = solve(graph, terminals, Core::Method::exact);
    CHECK(exact.is_optimal);
    check_tree(graph, terminals, exact.tree);
    CHECK(are_equal(exact.tree.length, shortest_tree_length(graph, terminals)));
  }

  for(int k : {12, 20, 30}) {
    const Core::Csr_graph graph = grid_graph(30, 20, 0.9, random);
    const std::vector<int> terminals = random_terminals(graph.number_of_vertices(), k, random);
    const Core::Solution exact = solve(graph, terminals, Core::Method::exact);
    CHECK(exact.outcome == Core::Outcome::done && exact.is_optimal);
    check_tree(graph, terminals, exact.tree);
    for(Core::Method method : heuristics)
      CHECK(solve(graph, terminals, method).tree.length >= exact.tree.length * (1. - 1e-9));

    // the order of the terminals does not matter
    std::vector<int> reversed(terminals.rbegin(), terminals.rend());
    CHECK(are_equal(solve(graph, reversed, Core::Method::exact).tree.length, exact.tree.length));

    // a terminal in the tree more changes nothing
    std::vector<int> more(terminals);
    const Core::Edge& edge = graph.edges[exact.tree.edges.front()];
    for(int v : {edge.source, edge.target})
      if(std::find(more.begin(), more.end(), v) == more.end())
        more.push_back(v);
    CHECK(are_equal(solve(graph, more, Core::Method::exact).tree.length, exact.tree.length));
  }

  // all vertices are terminals: a minimum spanning tree
  const Core::Csr_graph graph = grid_graph(30, 30, 0.9, random);
  std::vector<int> all;
  for(int v = 0; v < graph.number_of_vertices(); ++v)
    all.push_back(v);
  const double optimum = solve(graph, all, Core::Method::metric_closure).tree.length;
  for(Core::Method method : heuristics)
    CHECK(are_equal(solve(graph, all, method).tree.length, optimum));
  const Core::Solution exact = solve(graph, all, Core::Method::exact);
  CHECK(exact.is_optimal && are_equal(exact.tree.length, optimum));
  return test::exit_status();
}
