// The same trees, edge by edge, for any number of threads and on every run.

#include "mesh_graphs.h"
#include "steiner_tree_checks.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

namespace steiner_tree_parallel_test {

std::vector<std::vector<int>> trees(const Core::Csr_graph& graph, const std::vector<int>& terminals,
                                    Core::Execution execution)
{
  std::vector<std::vector<int>> result;
  for(Core::Method method : {Core::Method::greedy_auxiliary_points, Core::Method::local_search, Core::Method::exact}) {
    Core::Options options;
    options.method = method;
    result.push_back(Core::solve(graph, terminals, options, execution, [] { return true; }).tree.edges);
  }
  return result;
}

void check(const Core::Csr_graph& graph, const std::vector<int>& terminals)
{
  const std::vector<std::vector<int>> expected = trees(graph, terminals, Core::Execution::SEQUENTIAL);
  CHECK(trees(graph, terminals, Core::Execution::SEQUENTIAL) == expected);
#ifdef CGAL_LINKED_WITH_TBB
  for(std::size_t number_of_threads : {1, 2, 3, 8}) {
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, number_of_threads);
    CHECK(trees(graph, terminals, Core::Execution::PARALLEL) == expected);
  }
#endif
}

} // namespace steiner_tree_parallel_test

int main()
{
  using namespace steiner_tree_parallel_test;
  CGAL::Random random(3);
  for(double noise : {0., 0.9}) {
    const Core::Csr_graph graph = grid_graph(60, 50, noise, random);
    check(graph, random_terminals(graph.number_of_vertices(), 12, random));
  }
  // so large that trees are looked for in corridors
  const Core::Csr_graph graph = grid_graph(150, 120, 0.9, random);
  check(graph, random_terminals(graph.number_of_vertices(), 5, random));
  return test::exit_status();
}
