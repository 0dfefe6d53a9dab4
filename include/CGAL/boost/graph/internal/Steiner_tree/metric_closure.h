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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_METRIC_CLOSURE_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_METRIC_CLOSURE_H

#include <CGAL/boost/graph/internal/Steiner_tree/Tree.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Voronoi_regions.h>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

// The tree of Kou, Markowsky and Berman (1981; paper, Section 3.2): a minimum spanning tree of the metric closure
// of the terminals, as the union of its shortest paths. Mehlhorn (1988) reads one such tree off a single Dijkstra
// search from all terminals: among the edges that join the regions of two terminals, the shortest connections.
inline Tree metric_closure_tree(const Csr_graph& graph, const std::vector<int>& terminals)
{
  const Voronoi_regions regions(graph, terminals);
  std::vector<Edge> connections;
  std::vector<int> bridges;
  for(int e = 0; e < graph.number_of_edges(); ++e) {
    const Edge& edge = graph.edges[e];
    if(!regions.is_bridge(edge))
      continue;
    connections.push_back(Edge{regions.center(edge.source), regions.center(edge.target), regions.bridge_length(edge)});
    bridges.push_back(e);
  }
  std::vector<int> order(connections.size());
  for(std::size_t i = 0; i < order.size(); ++i)
    order[i] = int(i);
  const Csr_graph closure(graph.number_of_vertices(), std::move(connections));

  std::vector<int> tree_edges;
  for(int i : minimum_spanning_forest(closure, order)) {
    const Edge& bridge = graph.edges[bridges[i]];
    tree_edges.push_back(bridges[i]);
    regions.path(bridge.source, std::back_inserter(tree_edges));
    regions.path(bridge.target, std::back_inserter(tree_edges));
  }
  return make_tree(graph, terminals, tree_edges);
}

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_METRIC_CLOSURE_H
