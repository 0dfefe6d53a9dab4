// A graph in the format of the PACE 2018 challenge through all methods, whose answers have to be trees in the right order.

#include "pace_format.h"

#include <CGAL/boost/graph/steiner_tree.h>

#include <boost/pending/disjoint_sets.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace ST = CGAL::Steiner_tree;

namespace {

typedef boost::graph_traits<Graph>::edge_descriptor Edge;

constexpr std::size_t largest = 300; // vertices: larger ones only take longer

void require(bool condition)
{
  if(!condition)
    std::abort();
}

// Whether the edges are a tree that connects the terminals, of the length that was told.
bool is_valid(const Problem& problem, const std::vector<Edge>& edges, double length)
{
  boost::disjoint_sets_with_storage<> parts(num_vertices(problem.graph));
  double sum = 0;
  for(const Edge e : edges)
  {
    if(parts.find_set(source(e, problem.graph)) == parts.find_set(target(e, problem.graph)))
      return false;
    parts.union_set(source(e, problem.graph), target(e, problem.graph));
    sum += get(boost::edge_weight, problem.graph, e);
  }
  for(const std::size_t t : problem.terminals)
    if(parts.find_set(t) != parts.find_set(problem.terminals.front()))
      return false;
  return sum <= length * (1 + 1e-9) && length <= sum * (1 + 1e-9);
}

template <typename Method>
ST::Result connect(const Problem& problem, Method method)
{
  std::vector<Edge> edges;
  const ST::Result result = CGAL::steiner_tree(problem.graph, problem.terminals, std::back_inserter(edges),
                                               CGAL::parameters::algorithm(method).maximum_number_of_states(20000));
  if(result.status == ST::Result_status::OK)
    require(is_valid(problem, edges, result.length));
  return result;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  try
  {
    std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
    const Problem problem = read_problem(in);
    if(num_vertices(problem.graph) > largest)
      return 0;
    const ST::Result results[] = {connect(problem, ST::Metric_closure_tag()),
                                  connect(problem, ST::Shortest_path_heuristic_tag()),
                                  connect(problem, ST::Local_search_tag()), connect(problem, ST::Best_tag())};
    const ST::Result exact = connect(problem, ST::Exact_tag());
    for(const ST::Result& result : results)
      if(exact.status == ST::Result_status::OK && result.status == ST::Result_status::OK)
      {
        require(exact.length <= result.length * (1 + 1e-9));
        require(result.lower_bound <= exact.length * (1 + 1e-9));
      }
  }
  catch(const std::runtime_error&)
  {
    // refused with a reason
  }
  return 0;
}
