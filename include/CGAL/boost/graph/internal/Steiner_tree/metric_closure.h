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

#include <CGAL/boost/graph/internal/Steiner_tree/Region_graph.h>

#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

// of parallel edges the shortest ones (the first of equals)
inline std::vector<int> shortest_parallel_edges(const Csr_graph& graph)
{
  std::vector<int> best(graph.number_of_vertices(), -1), result;
  for(int v = 0; v < graph.number_of_vertices(); ++v) {
    for(int i = graph.offsets[v]; i < graph.offsets[v + 1]; ++i) {
      int& e = best[graph.arcs[i].target];
      if(e < 0 || graph.arcs[i].weight < graph.edges[e].weight)
        e = graph.arcs[i].edge;
    }
    for(int i = graph.offsets[v]; i < graph.offsets[v + 1]; ++i) {
      int& e = best[graph.arcs[i].target];
      if(e >= 0 && v < graph.arcs[i].target)
        result.push_back(e);
      e = -1;
    }
  }
  return result;
}

// the edges of a minimum spanning forest, by Boost
inline std::vector<int> minimum_spanning_forest(const Csr_graph& graph)
{
  return minimum_spanning_forest(graph, shortest_parallel_edges(graph));
}

// The tree of Kou, Markowsky and Berman (1981; paper, Section 3.2): a minimum spanning tree of the metric closure of the
// terminals, as the union of its shortest paths. Mehlhorn (1988) reads one such tree off a single search from all
// terminals: the shortest connections among the edges that join the regions of two terminals. These regions are spanned
// by trees: the union has no cycle and only terminals as leaves. If the terminals are not connected, it is a forest.
inline Tree metric_closure_tree(const Csr_graph& graph, const std::vector<int>& terminals)
{
  const Region_graph regions(graph, terminals);
  Tree tree;
  tree.edges = regions.original_edges(minimum_spanning_forest(regions.graph()));
  tree.length = total_weight(graph, tree.edges);
  return tree;
}

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_METRIC_CLOSURE_H
