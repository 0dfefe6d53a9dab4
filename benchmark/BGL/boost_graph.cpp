// What running on Boost.Graph costs: the metric closure's tree (Boost's searches and spanning trees) and our own search
// (with Boost's heap) against the same without Boost, in the same run. The results have to be equal. Prints CSV, one
// line per mesh; the seconds are those of the fastest of some repetitions.
//
//   boost_graph MESH...

#include "edge_graph.h"
#include "plain_metric_closure.h"

#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>
#include <CGAL/boost/graph/internal/Steiner_tree/metric_closure.h>

#include <cstdlib>
#include <exception>
#include <iostream>

namespace Core = CGAL::internal::Steiner_tree;

const int number_of_repetitions = 7, number_of_sets = 10, number_of_terminals = 20;

// runs both in turn and prints their least times
template <typename First, typename Second>
void compare(First first, Second second)
{
  double seconds[2] = {(std::numeric_limits<double>::max)(), (std::numeric_limits<double>::max)()};
  for(int i = 0; i < number_of_repetitions; ++i) {
    double start = cpu_seconds();
    const auto expected = first();
    seconds[0] = (std::min)(seconds[0], cpu_seconds() - start);
    start = cpu_seconds();
    const auto found = second();
    seconds[1] = (std::min)(seconds[1], cpu_seconds() - start);
    if(found != expected)
      throw std::runtime_error("the results differ");
  }
  std::cout << "," << seconds[0] << "," << seconds[1] << "," << seconds[1] / seconds[0];
}

int main(int argc, char** argv)
{
  try {
    std::cout << "mesh,vertices,plain_tree,boost_tree,ratio,plain_search,boost_search,ratio,plain_search,own_search,ratio\n";
    for(int i = 1; i < argc; ++i) {
      const Edge_graph mesh = read_edge_graph(argv[i]);
      CGAL::Random random(0);
      std::vector<std::vector<int>> sets;
      for(int j = 0; j < number_of_sets; ++j)
        sets.push_back(random_terminals(mesh.graph, number_of_terminals, random));
      const auto for_each_set = [&](auto f) {
        return [&, f] {
          std::vector<decltype(f(sets.front()))> results;
          for(const std::vector<int>& terminals : sets)
            results.push_back(f(terminals));
          return results;
        };
      };
      std::cout << argv[i] << "," << mesh.graph.number_of_vertices();
      compare(for_each_set([&](const std::vector<int>& t) { return plain::metric_closure_tree(mesh.graph, t); }),
              for_each_set([&](const std::vector<int>& t) { return Core::metric_closure_tree(mesh.graph, t).edges; }));
      const auto plain_search = [&](const std::vector<int>& t) {
        return plain::Shortest_paths(mesh.graph, t).last_edges;
      };
      compare(for_each_set(plain_search), for_each_set([&](const std::vector<int>& t) {
        std::vector<double> distances;
        std::vector<int> last_edges(mesh.graph.number_of_vertices(), -1);
        Core::search_from_sources(mesh.graph, t, get(boost::edge_weight, mesh.graph),
                                  get(boost::vertex_index, mesh.graph), distances,
                                  [&](const Core::Csr_edge_descriptor& e) { last_edges[e.target] = e.edge; });
        return last_edges;
      }));
      compare(for_each_set(plain_search), for_each_set([&](const std::vector<int>& t) {
        CGAL::internal::Graph_kernel::Shortest_paths paths(mesh.graph);
        for(int v : t)
          paths.add_source(v);
        paths.run();
        return paths.last_edges();
      }));
      std::cout << std::endl;
    }
  }
  catch(const std::exception& error) {
    std::cerr << error.what() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
