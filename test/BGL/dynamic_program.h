#ifndef DYNAMIC_PROGRAM_H
#define DYNAMIC_PROGRAM_H

#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

// The length of a shortest tree by the program of Dreyfus and Wagner (1971) in the form of Erickson, Monma and Veinott
// (1987): for all sets of terminals but the last, in an order in which subsets come first, and all vertices v, the
// shortest tree that connects v and the set is one of two trees merged at v or ends with an edge to v.
inline double shortest_tree_length(const CGAL::internal::Graph_kernel::Csr_graph& graph,
                                   const std::vector<int>& terminals)
{
  const std::size_t number_of_sets = std::size_t(1) << (terminals.size() - 1);
  std::vector<std::vector<double>> lengths(
    number_of_sets, std::vector<double>(graph.number_of_vertices(), (std::numeric_limits<double>::infinity)()));
  for(std::size_t set = 1; set < number_of_sets; ++set) {
    std::vector<double>& length = lengths[set];
    for(std::size_t i = 0; i + 1 < terminals.size(); ++i)
      if(set == std::size_t(1) << i)
        length[terminals[i]] = 0.;
    for(std::size_t part = (set - 1) & set; part > set - part; part = (part - 1) & set)
      for(std::size_t v = 0; v < length.size(); ++v)
        length[v] = (std::min)(length[v], lengths[part][v] + lengths[set - part][v]);
    for(bool is_shorter = true; is_shorter;) {
      is_shorter = false;
      for(const auto& e : graph.edges)
        if(length[e.source] + e.weight < length[e.target] || length[e.target] + e.weight < length[e.source]) {
          length[e.target] = (std::min)(length[e.target], length[e.source] + e.weight);
          length[e.source] = (std::min)(length[e.source], length[e.target] + e.weight);
          is_shorter = true;
        }
    }
  }
  return terminals.size() < 2 ? 0. : lengths.back()[terminals.back()];
}

#endif // DYNAMIC_PROGRAM_H
