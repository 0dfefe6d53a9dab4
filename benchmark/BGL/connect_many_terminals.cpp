// Time of the greedy method, local search, and the exact method on one mesh, with many random terminals.
//
//   connect_many_terminals MESH NUMBER_OF_TERMINALS [NUMBER_OF_SETS]

#include "edge_graph.h"

#include <CGAL/Real_timer.h>
#include <CGAL/boost/graph/internal/Steiner_tree/solve.h>

#include <cstdlib>
#include <exception>
#include <iostream>

namespace Core = CGAL::internal::Steiner_tree;

const Core::Execution execution = CGAL::internal::Graph_kernel::execution_of<CGAL::Parallel_if_available_tag>();

const char* name(Core::Method method)
{
  return method == Core::Method::exact ? "exact" : method == Core::Method::local_search ? "local" : "greedy";
}

int main(int argc, char** argv)
{
  if(argc < 3) {
    std::cerr << "usage: " << argv[0] << " MESH NUMBER_OF_TERMINALS [NUMBER_OF_SETS]\n";
    return EXIT_FAILURE;
  }
  try {
    const Edge_graph mesh = read_edge_graph(argv[1]);
    const int k = std::atoi(argv[2]), number_of_sets = argc > 3 ? std::atoi(argv[3]) : 3;
    std::cout << "seed,method,length,lower_bound,optimal,seconds,cpu_seconds\n";
    for(int seed = 0; seed < number_of_sets; ++seed) {
      CGAL::Random random(static_cast<unsigned int>(seed));
      const std::vector<int> terminals = random_terminals(mesh.graph, k, random);
      for(Core::Method method : {Core::Method::greedy_auxiliary_points, Core::Method::local_search, Core::Method::exact}) {
        Core::Options options;
        options.method = method;
        options.minimum_length_decrease = 0.01 * mesh.diagonal;
        CGAL::Real_timer timer;
        timer.start();
        const double start = cpu_seconds();
        const Core::Solution solution =
          Core::solve(mesh.graph, terminals, options, execution, [] { return true; });
        std::cout << seed << "," << name(method) << ","
                  << solution.tree.length << "," << solution.lower_bound << "," << solution.is_optimal << ","
                  << timer.time() << "," << cpu_seconds() - start << std::endl;
      }
    }
  }
  catch(const std::exception& error) {
    std::cerr << error.what() << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
