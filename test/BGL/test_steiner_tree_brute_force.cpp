// All methods on small random graphs of several kinds, against the enumeration of all sets of Steiner vertices.

#include "steiner_tree_checks.h"

#include <CGAL/Random.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Dual_ascent.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Pruned_dynamic_program.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Set_search.h>
#include <CGAL/boost/graph/steiner_tree.h>

#include <boost/graph/adjacency_list.hpp>

#include <iterator>
#include <limits>

namespace steiner_tree_brute_force_test {

double brute_force(const Core::Csr_graph& graph, const std::vector<int>& terminals)
{
  std::vector<int> order;
  for(int e = 0; e < graph.number_of_edges(); ++e)
    order.push_back(e);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return graph.edges[a].weight < graph.edges[b].weight; });
  unsigned int terminal_set = 0;
  for(int t : terminals)
    terminal_set |= 1u << t;
  double best = (std::numeric_limits<double>::infinity)();
  for(unsigned int set = 0; set < (1u << graph.number_of_vertices()); ++set) {
    if((set & terminal_set) != terminal_set)
      continue;
    int missing = -1;
    for(int v = 0; v < graph.number_of_vertices(); ++v)
      missing += int((set >> v) & 1);
    double length = 0.;
    CGAL::internal::Graph_kernel::Disjoint_sets components(graph.number_of_vertices());
    for(int e : order) {
      const Core::Edge& edge = graph.edges[e];
      if(((set >> edge.source) & 1) && ((set >> edge.target) & 1) && components.unite(edge.source, edge.target)) {
        length += edge.weight;
        --missing;
      }
    }
    if(missing == 0)
      best = (std::min)(best, length);
  }
  return best;
}

// the public call; optimal methods have to find the optimum
template <typename Method_tag>
void check_call(const Core::Csr_graph& edges, const std::vector<int>& terminals, double optimum, bool is_exact)
{
  typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                boost::property<boost::edge_weight_t, double>> Graph;
  Graph graph(std::size_t(edges.number_of_vertices()));
  for(const Core::Edge& e : edges.edges)
    add_edge(std::size_t(e.source), std::size_t(e.target), e.weight, graph);
  std::vector<boost::graph_traits<Graph>::edge_descriptor> tree;
  const CGAL::Steiner_tree::Result result = CGAL::steiner_tree(graph, terminals, std::back_inserter(tree),
                                                               CGAL::parameters::algorithm(Method_tag()));
  CHECK(result && (result.is_optimal || !is_exact));
  double length = 0.;
  for(const auto& e : tree)
    length += get(boost::edge_weight, graph, e);
  CHECK(are_equal(length, result.length));
  CHECK(result.length >= optimum * (1. - 1e-9) && result.length <= 2. * optimum * (1. + 1e-9));
  CHECK(!result.is_optimal || are_equal(result.length, optimum));
}

void check_all_calls(const Core::Csr_graph& graph, const std::vector<int>& terminals, double optimum)
{
  using namespace CGAL::Steiner_tree;
  check_call<Metric_closure_tag>(graph, terminals, optimum, false);
  check_call<Shortest_path_heuristic_tag>(graph, terminals, optimum, false);
  check_call<Greedy_auxiliary_points_tag<>>(graph, terminals, optimum, false);
  check_call<Greedy_auxiliary_points_tag<Shortest_path_heuristic_tag>>(graph, terminals, optimum, false);
  check_call<Local_search_tag>(graph, terminals, optimum, false);
  check_call<Exact_tag>(graph, terminals, optimum, true);
  check_call<Best_tag>(graph, terminals, optimum, true);
}

// the dynamic program with the sets that serve 65 to 256 terminals
void check_wide_sets(const Core::Csr_graph& graph, const std::vector<int>& terminals, double optimum)
{
  if(terminals.size() < 2)
    return;
  const Core::Go_further go_further = [] { return true; };
  const Core::Dual_ascent dual(graph, terminals, 0, Core::Execution::SEQUENTIAL, go_further,
                               [](const Core::Dual_ascent&) {});
  const Core::Completion_bound<4> bound(dual);
  Core::Pruned_dynamic_program<4> program(graph, terminals, bound, optimum * (1. + 1e-9) + 1e-9, 1000000);
  CHECK(program.run(Core::Execution::SEQUENTIAL, go_further));
  CHECK(program.has_found_tree());
  check_tree(graph, terminals, program.tree());
  CHECK(are_equal(program.tree().length, optimum));
}

double random_weight(CGAL::Random& random, int kind)
{
  switch(kind) {
  case 0: return random.get_int(1, 4);                             // many ties
  case 1: return random.get_int(0, 3);                             // zeros
  case 2: return random.get_double(0.5, 1.);                       // metric: the triangle inequality holds
  case 3: return std::pow(10., random.get_double(-6., 6.));        // many orders of magnitude
  default: return random.get_double(0., 1.);
  }
}

} // namespace steiner_tree_brute_force_test

int main()
{
  using namespace steiner_tree_brute_force_test;
  const unsigned int seed = 20260101;
  const int number_of_graphs = 12000;
  std::cout << number_of_graphs << " random graphs, seed " << seed << std::endl;
  CGAL::Random random(seed);
  int number_connected = 0;
  for(int i = 0; i < number_of_graphs; ++i) {
    const int n = random.get_int(1, 10);
    const int m = random.get_int(0, 3 * n + 1);
    const int kind = random.get_int(0, 5);
    std::vector<Core::Edge> edges; // loops, parallel edges and several components included
    if(random.get_int(0, 4) != 0)
      for(int v = 1; v < n; ++v)
        edges.push_back(Core::Edge{random.get_int(0, v), v, random_weight(random, kind)});
    for(int j = 0; j < m; ++j)
      edges.push_back(Core::Edge{random.get_int(0, n), random.get_int(0, n), random_weight(random, kind)});
    const Core::Csr_graph graph(n, edges);
    std::vector<int> terminals;
    const int density = random.get_int(1, 5);
    for(int v = 0; v < n; ++v)
      if(random.get_int(0, 4) < density)
        terminals.push_back(v);
    const double optimum = brute_force(graph, terminals);
    if(terminals.empty() || optimum < (std::numeric_limits<double>::infinity)()) {
      ++number_connected;
      check_all_methods(graph, terminals, terminals.empty() ? 0. : optimum);
      check_all_calls(graph, terminals, terminals.empty() ? 0. : optimum);
      check_wide_sets(graph, terminals, optimum);
    }
    else
      CHECK(solve(graph, terminals, Core::Method::exact).outcome == Core::Outcome::terminals_not_connected);
  }
  std::cout << number_connected << " with connected terminals" << std::endl;
  CHECK(number_connected >= 10000);
  return test::exit_status();
}
