// Reads a graph in the format of the PACE 2018 Steiner tree challenge from standard input, and prints the length of a
// Steiner tree and its edges.

#include "pace_format.h"

#include <CGAL/boost/graph/steiner_tree.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <exception>
#include <functional>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace ST = CGAL::Steiner_tree;

namespace {

const int exit_done = 0, exit_usage = 2, exit_unreadable = 3, exit_stopped = 6;

class Time_limit
{
  std::chrono::steady_clock::time_point m_end;
  bool m_is_set;

public:
  explicit Time_limit(double seconds) : m_is_set(seconds > 0.)
  {
    if(m_is_set)
      m_end = std::chrono::steady_clock::now() +
              std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                std::chrono::duration<double>((std::min)(seconds, 1e8)));
  }

  bool go_further() const { return !m_is_set || std::chrono::steady_clock::now() < m_end; }
};

typedef boost::graph_traits<Graph>::edge_descriptor Edge;

ST::Result connect(const Problem& problem, const std::string& method, const Time_limit& limit, std::vector<Edge>& tree)
{
  // whoever asks for a proof gets more memory for it, up to some gigabytes
  const std::size_t maximum_number_of_states = method == "exact" ? 100000000 : 20000000;
  const auto run = [&](auto tag) {
    return CGAL::steiner_tree(problem.graph, problem.terminals, std::back_inserter(tree),
                              CGAL::parameters::algorithm(tag)
                                .visitor(std::ref(limit))
                                .maximum_number_of_states(maximum_number_of_states));
  };
  if(method == "mst")
    return run(ST::Metric_closure_tag());
  if(method == "sph")
    return run(ST::Shortest_path_heuristic_tag());
  if(method == "greedy")
    return run(ST::Local_search_tag());
  if(method == "exact")
    return run(ST::Exact_tag());
  return run(ST::Best_tag());
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Steiner trees of graphs in the format of the PACE 2018 challenge, read from standard input");
  std::string method = "best";
  double time_limit = 0.;
  app.add_option("--method", method, "mst, sph, greedy, exact or best")
    ->check(CLI::IsMember({"mst", "sph", "greedy", "exact", "best"}))
    ->capture_default_str();
  app.add_option("--time-limit", time_limit, "seconds after which to stop")->check(CLI::PositiveNumber);
  try {
    app.parse(argc, argv);
  }
  catch(const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_done : exit_usage;
  }

  const Time_limit limit(time_limit);
  try {
    std::ios::sync_with_stdio(false);
    const Problem problem = read_problem(std::cin);
    std::vector<Edge> tree;
    const ST::Result result = connect(problem, method, limit, tree);
    switch(result.status) {
    case ST::Result_status::OK:
      break;
    case ST::Result_status::TERMINALS_NOT_CONNECTED:
      std::cerr << "steiner_pace: the terminals are not connected\n";
      return exit_unreadable;
    case ST::Result_status::INVALID_WEIGHT:
      std::cerr << "steiner_pace: invalid weight\n";
      return exit_unreadable;
    case ST::Result_status::BUDGET_EXCEEDED:
    case ST::Result_status::CANCELLED:
      if(method != "exact")
        break;
      std::cerr << "steiner_pace: stopped without proof\n";
      return exit_stopped;
    }
    std::cout << std::setprecision(std::numeric_limits<double>::max_digits10) << "VALUE " << result.length << "\n";
    for(Edge e : tree)
      std::cout << problem.names[source(e, problem.graph)] << " " << problem.names[target(e, problem.graph)] << "\n";
    return std::cout.flush() ? exit_done : exit_unreadable;
  }
  catch(const std::exception& error) {
    std::cerr << "steiner_pace: " << error.what() << "\n";
    return exit_unreadable;
  }
}
