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

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/internal/Graph_kernel/graph_traits_Csr_graph.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Tree.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Voronoi_regions.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

using Graph_kernel::Csr_edge_descriptor;

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

// Writes the edges of the tree of Kou, Markowsky and Berman (1981; paper, Section 3.2): a minimum spanning tree of the
// metric closure of the terminals, as the union of its shortest paths. Mehlhorn (1988) reads one such tree off a single
// search from all terminals: the shortest connections among the edges that join the regions of two terminals. As
// these regions are spanned by trees, the union has no cycle and only terminals as leaves.
// For any undirected model of Boost's concepts `VertexListGraph`, `IncidenceGraph`, and `EdgeListGraph` (or a directed
// one with each edge in both directions), different terminals, and indices 0..n-1. If the terminals are not
// connected, it is a forest.
template <typename Graph, typename WeightMap, typename VertexIndexMap, typename OutputIterator>
OutputIterator metric_closure_tree(const Graph& graph,
                                   const std::vector<typename boost::graph_traits<Graph>::vertex_descriptor>& terminals,
                                   WeightMap weight, VertexIndexMap index, OutputIterator tree_edges)
{
  typedef typename boost::graph_traits<Graph>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Graph>::edge_descriptor edge_descriptor;
  const Voronoi_regions<Graph, WeightMap, VertexIndexMap> regions(graph, terminals, weight, index);
  std::vector<Edge> connections;
  std::vector<edge_descriptor> bridges;
  for(const edge_descriptor& e : CGAL::make_range(edges(graph)))
    if(regions.is_bridge(e)) {
      connections.push_back(Edge{regions.center(source(e, graph)), regions.center(target(e, graph)),
                                 regions.bridge_length(e)});
      bridges.push_back(e);
    }

  std::vector<char> is_in_tree(num_vertices(graph), 0);
  for(vertex_descriptor t : terminals)
    is_in_tree[get(index, t)] = 1;
  const auto add_path = [&](vertex_descriptor v) {
    while(!is_in_tree[get(index, v)]) {
      is_in_tree[get(index, v)] = 1;
      *tree_edges++ = regions.last_edge(v);
      v = source(regions.last_edge(v), graph);
    }
  };
  const Csr_graph closure(int(terminals.size()), std::move(connections));
  for(int connection : minimum_spanning_forest(closure, shortest_parallel_edges(closure))) {
    const edge_descriptor& bridge = bridges[connection];
    *tree_edges++ = bridge;
    add_path(source(bridge, graph));
    add_path(target(bridge, graph));
  }
  return tree_edges;
}

inline Tree metric_closure_tree(const Csr_graph& graph, const std::vector<int>& terminals)
{
  Tree tree;
  metric_closure_tree(graph, terminals, get(boost::edge_weight, graph), get(boost::vertex_index, graph),
                      boost::make_function_output_iterator(
                        [&](const Csr_edge_descriptor& e) { tree.edges.push_back(e.edge); }));
  std::sort(tree.edges.begin(), tree.edges.end());
  tree.length = total_weight(graph, tree.edges);
  return tree;
}

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_METRIC_CLOSURE_H
