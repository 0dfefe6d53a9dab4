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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_SHORTEST_PATH_HEURISTIC_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_SHORTEST_PATH_HEURISTIC_H

#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Patience.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Tree.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Voronoi_regions.h>
#include <CGAL/boost/graph/internal/Steiner_tree/metric_closure.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

// The shortest path heuristic of Takahashi and Matsuyama (1980): grows a tree from `start`, always by a shortest
// path to the nearest terminal outside. One search serves all steps: the vertices of a new path become sources
// and lower the distances around them. The tree has infinite length if a terminal cannot be reached or it is stopped.
// `weight(i)` is the weight of arc i.
template <typename Weight>
Tree grow_tree(const Csr_graph& graph, const std::vector<int>& terminals, int start, Weight weight,
               const Go_further& go_further)
{
  std::vector<char> is_terminal = mark(graph.number_of_vertices(), terminals);
  std::size_t remaining = terminals.size();
  std::vector<int> tree_edges;
  Shortest_paths paths(graph);
  paths.add_source(start);
  Patience patience(go_further);
  paths.run([&](int v) {
    if(!patience.lasts())
      return false;
    if(is_terminal[v] != 1)
      return true;
    is_terminal[v] = 2; // reached
    for(int u = v; paths.last_edge(u) >= 0;) {
      const int e = paths.last_edge(u), next = paths.predecessor(u);
      tree_edges.push_back(e);
      paths.make_source(u);
      u = next;
    }
    return --remaining > 0;
  }, weight);
  return remaining == 0 ? make_tree(graph, terminals, tree_edges) : Tree();
}

// a terminal that has another terminal nearest to it: from there the heuristic grows as in the paper (Section 4.1),
// which begins with the nearest pair
inline int terminal_of_nearest_pair(const Csr_graph& graph, const std::vector<int>& terminals)
{
  const Voronoi_regions regions(graph, terminals);
  int result = terminals.front();
  double shortest = Shortest_paths::infinity();
  for(int e = 0; e < graph.number_of_edges(); ++e)
    if(regions.is_bridge(e) && regions.bridge_length(e) < shortest) {
      shortest = regions.bridge_length(e);
      result = (std::min)(terminals[regions.center(graph.edges[e].source)],
                          terminals[regions.center(graph.edges[e].target)]);
    }
  return result;
}

// the same from there; if it is stopped, the tree of the metric closure, which is found at once
inline Tree shortest_path_heuristic(const Csr_graph& graph, const std::vector<int>& terminals,
                                    const Go_further& go_further)
{
  const Tree tree = grow_tree(graph, terminals, terminal_of_nearest_pair(graph, terminals),
                              [&](int i) { return graph.arcs[i].weight; }, go_further);
  return tree.edges.empty() ? metric_closure_tree(graph, terminals) : tree;
}

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_SHORTEST_PATH_HEURISTIC_H
