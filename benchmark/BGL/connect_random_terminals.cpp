// The paper's comparison of methods (Section 4.3): on each mesh, ten sets of random terminals of each size from four to
// ten. Prints CSV, one line per set, and a summary on standard error.
//
//   connect_random_terminals [--decrease EPSILON] FOLDER MESH... > ratios.csv
//
// EPSILON is the least decrease, in diagonals of the bounding box, for which the greedy method adds a point; default: 0.01,
// the value of the paper's Table 1.

#include "edge_graph.h"

#include <CGAL/boost/graph/internal/Steiner_tree/solve.h>

#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace Core = CGAL::internal::Steiner_tree;

struct Statistics
{
  std::vector<double> values;

  double mean() const
  {
    double sum = 0.;
    for(double v : values)
      sum += v;
    return sum / double(values.size());
  }

  double quantile(double q)
  {
    std::sort(values.begin(), values.end());
    return values[std::size_t(q * double(values.size() - 1))];
  }
};

int main(int argc, char** argv)
{
  std::vector<std::string> words(argv + 1, argv + argc);
  double decrease = 0.01;
  if(words.size() > 2 && words[0] == "--decrease") {
    decrease = std::atof(words[1].c_str());
    words.erase(words.begin(), words.begin() + 2);
  }
  if(words.size() < 2) {
    std::cerr << "usage: " << argv[0] << " [--decrease EPSILON] FOLDER MESH...\n";
    return EXIT_FAILURE;
  }
  const int best = 4, count = 5;
  const Core::Method methods[count] = {Core::Method::metric_closure, Core::Method::shortest_path_heuristic,
                                  Core::Method::greedy_auxiliary_points, Core::Method::local_search,
                                  Core::Method::exact};
  const char* names[count] = {"mst", "sph", "greedy", "local", "best"};
  std::cout << "mesh,vertices,terminals,seed,optimal,lower_bound";
  for(const char* name : names)
    std::cout << ",length_" << name << ",seconds_" << name;
  std::cout << "\n" << std::setprecision(12);

  Statistics ratios[count], seconds[count];
  int number_of_optimal[count] = {}, number_of_proofs = 0, number_of_sets = 0;
  try {
    for(std::size_t i = 1; i < words.size(); ++i) {
      const Edge_graph mesh = read_edge_graph(words[0] + "/" + words[i]);
      for(unsigned int seed = 0; seed < 70; ++seed) {
        CGAL::Random random(seed);
        const std::vector<int> terminals = random_terminals(mesh.graph, 4 + int(seed) % 7, random);
        double lengths[count], times[count];
        Core::Solution solution;
        for(int m = 0; m < count; ++m) {
          Core::Options options;
          options.method = methods[m];
          options.minimum_length_decrease = decrease * mesh.diagonal;
          const double start = cpu_seconds();
          solution = Core::solve(mesh.graph, terminals, options, Core::Execution::SEQUENTIAL, [] { return true; });
          times[m] = cpu_seconds() - start;
          lengths[m] = solution.tree.length;
          seconds[m].values.push_back(times[m]);
        }
        std::cout << words[i] << "," << mesh.graph.number_of_vertices() << "," << terminals.size() << "," << seed << ","
                  << solution.is_optimal << "," << solution.lower_bound;
        for(int m = 0; m < count; ++m) {
          const double ratio = lengths[m] / lengths[best];
          ratios[m].values.push_back(ratio);
          number_of_optimal[m] += ratio <= 1. + 1e-9;
          std::cout << "," << lengths[m] << "," << times[m];
        }
        std::cout << "\n";
        number_of_proofs += solution.is_optimal;
        ++number_of_sets;
      }
    }
  }
  catch(const std::exception& error) {
    std::cerr << error.what() << "\n";
    return EXIT_FAILURE;
  }
  std::cerr << number_of_sets << " sets, " << number_of_proofs << " proven optimal\n";
  for(int m = 0; m < count; ++m)
    std::cerr << names[m] << ": optimal " << 100. * number_of_optimal[m] / number_of_sets << " %, mean ratio "
              << std::setprecision(6) << ratios[m].mean() << ", maximum " << ratios[m].quantile(1.) << "; seconds: median "
              << seconds[m].quantile(0.5) << ", mean " << seconds[m].mean() << ", maximum " << seconds[m].quantile(1.)
              << "\n";
  return EXIT_SUCCESS;
}
