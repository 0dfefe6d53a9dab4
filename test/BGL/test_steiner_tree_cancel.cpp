// All methods ask often whether to go on, and leave a tree when told not to.

#include "mesh_graphs.h"
#include "steiner_tree_checks.h"

// the solution when the answer is no from some question on, which has to come
Core::Solution solve_until(int question, const Core::Csr_graph& graph, const std::vector<int>& terminals,
                           Core::Method method)
{
  Core::Options options;
  options.method = method;
  int number_of_questions = 0;
  const Core::Solution solution = Core::solve<CGAL::Sequential_tag>(graph, terminals, options, [&] {
    return ++number_of_questions < question;
  });
  CHECK(number_of_questions >= question);
  CHECK(solution.outcome == Core::Outcome::cancelled);
  check_tree(graph, terminals, solution.tree);
  return solution;
}

int main()
{
  const unsigned int seed = 20260105;
  std::cout << "seed " << seed << std::endl;
  CGAL::Random random(seed);
  const Core::Csr_graph graph = grid_graph(150, 100, 0.9, random);
  const std::vector<int> terminals = random_terminals(graph.number_of_vertices(), 40, random);

  // while the tree grows, and between the searches from the terminals, nothing but the metric closure's tree is known
  const std::vector<int> known = Core::metric_closure_tree(graph, terminals).edges;
  for(int question : {1, 2, 5, 10})
    CHECK(solve_until(question, graph, terminals, Core::Method::shortest_path_heuristic).tree.edges == known);
  for(Core::Method method :
      {Core::Method::greedy_auxiliary_points, Core::Method::greedy_auxiliary_points_and_shortest_paths})
    for(int question : {1, 2, 3})
      CHECK(solve_until(question, graph, terminals, method).tree.edges == known);
  for(int question : {1, 10, 20, 30, 100})
    solve_until(question, graph, terminals, Core::Method::local_search);

  // a dual ascent that was stopped gives a bound, too
  const double length = solve(graph, terminals, Core::Method::local_search).tree.length;
  double bound = 0.;
  for(int question : {1, 10, 30, 50, 70, 100, 150}) {
    const Core::Solution solution = solve_until(question, graph, terminals, Core::Method::exact);
    CHECK(solution.lower_bound >= bound && solution.lower_bound < 0.97 * length);
    bound = solution.lower_bound;
  }
  CHECK(bound > 0.);
  return EXIT_SUCCESS;
}
