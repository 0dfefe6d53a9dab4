// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_TEXTBOOK_DYNAMIC_PROGRAMME_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_TEXTBOOK_DYNAMIC_PROGRAMME_H

#include <CGAL/boost/graph/internal/Steiner_tree/Shortest_paths.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Tree.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

// The program of Dreyfus and Wagner (1971) in the form of Erickson, Monma and Veinott (1987), as the paper uses it
// for comparison: for all sets I of terminals but the last, in an order in which subsets come first, and all vertices
// v, the length of the shortest tree that connects v and I is the shortest over merges of two trees at v and
// paths to other vertices. O(3^k n + 2^k (m + n log n)) time, O(2^k n) memory: a reference for small k.
inline Tree textbook_dynamic_programme(const Csr_graph& graph, const std::vector<int>& terminals)
{
  if(terminals.size() < 2)
    return make_tree(graph, terminals, {});
  const int n = graph.number_of_vertices();
  const std::size_t number_of_sets = std::size_t(1) << (terminals.size() - 1);
  struct State
  {
    double length = Shortest_paths::infinity();
    int last_edge = -1;       // of a path from the vertex where the trees below merge,
    std::size_t part = 0;     // one of which connects this part of the set
  };
  std::vector<std::vector<State>> states(number_of_sets);
  for(std::size_t set = 1; set < number_of_sets; ++set) {
    std::vector<State>& table = states[set];
    table.resize(n);
    if((set & (set - 1)) == 0)
      for(std::size_t i = 0; i + 1 < terminals.size(); ++i)
        if(set == std::size_t(1) << i)
          table[terminals[i]].length = 0.;
    for(std::size_t part = (set - 1) & set; part > set - part; part = (part - 1) & set)
      for(int v = 0; v < n; ++v) {
        const double length = states[part][v].length + states[set - part][v].length;
        if(length < table[v].length) {
          table[v].length = length;
          table[v].part = part;
        }
      }
    Shortest_paths paths(graph);
    for(int v = 0; v < n; ++v)
      paths.add_source(v, table[v].length);
    paths.run();
    for(int v = 0; v < n; ++v) {
      table[v].length = paths.distance(v);
      table[v].last_edge = paths.last_edge(v);
    }
  }

  if(states.back()[terminals.back()].length == Shortest_paths::infinity())
    return Tree();
  std::vector<int> edges;
  std::vector<std::pair<std::size_t, int>> stack(1, std::make_pair(number_of_sets - 1, terminals.back()));
  while(!stack.empty()) {
    const std::size_t set = stack.back().first;
    int v = stack.back().second;
    stack.pop_back();
    for(; states[set][v].last_edge >= 0; v = graph.opposite(states[set][v].last_edge, v))
      edges.push_back(states[set][v].last_edge);
    if(const std::size_t part = states[set][v].part) {
      stack.push_back(std::make_pair(part, v));
      stack.push_back(std::make_pair(set - part, v));
    }
  }
  return make_tree(graph, terminals, edges);
}

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_TEXTBOOK_DYNAMIC_PROGRAMME_H
