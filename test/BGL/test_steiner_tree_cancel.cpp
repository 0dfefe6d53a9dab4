// All methods ask often whether to go on, and leave a tree when told not to.

#include "mesh_graphs.h"
#include "steiner_tree_checks.h"

#include <CGAL/boost/graph/internal/Steiner_tree/metric_closure.h>

namespace steiner_tree_cancel_test {

// the solution when the answer is no from some question on, which has to come
Core::Solution solve_until(int question, const Core::Csr_graph& graph, const std::vector<int>& terminals,
                           Core::Method method)
{
  Core::Options options;
  options.method = method;
  int number_of_questions = 0;
  const Core::Solution solution = Core::solve(graph, terminals, options, Core::Execution::SEQUENTIAL, [&] {
    return ++number_of_questions < question;
  });
  CHECK(number_of_questions >= question);
  CHECK(solution.outcome == Core::Outcome::cancelled);
  check_tree(graph, terminals, solution.tree);
  return solution;
}

} // namespace steiner_tree_cancel_test

int main()
{
  using namespace steiner_tree_cancel_test;
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

  // A path between two vertices is a shortest one, unless it is known from elsewhere.
  const std::vector<int> ends = {0, graph.number_of_vertices() - 1};
  const std::vector<int> detour = solve(graph, {ends[0], graph.number_of_vertices() / 2, ends[1]}, Core::Method::exact).tree.edges;
  const double shortest = solve(graph, ends, Core::Method::exact).tree.length;
  CHECK(Core::total_weight(graph, detour) > 1.01 * shortest);
  const auto stopped = [](const Core::Csr_graph& g, const std::vector<int>& t, const std::vector<int>& known_edges) {
    return Core::solve(g, t, Core::Options(), Core::Execution::SEQUENTIAL, [] { return false; }, known_edges);
  };
  const Core::Solution path = stopped(graph, ends, {});
  CHECK(path.outcome == Core::Outcome::done && path.is_optimal && are_equal(path.tree.length, shortest));
  const Core::Solution known_path = stopped(graph, ends, detour);
  CHECK(known_path.outcome == Core::Outcome::cancelled && !known_path.is_optimal);
  CHECK(known_path.lower_bound <= shortest * (1. + 1e-9));
  return test::exit_status();
}
