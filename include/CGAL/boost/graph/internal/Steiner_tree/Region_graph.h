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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_REGION_GRAPH_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_REGION_GRAPH_H

#include <CGAL/boost/graph/internal/Graph_kernel/sort_unique.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Voronoi_regions.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

// A coarser graph: some of the vertices as centers, joined where their regions touch by the shortest path from center
// to center through an edge between the regions. Its paths are paths of the graph, a few percent longer than the
// shortest ones; with terminals alone as centers, its minimum spanning trees are those of their metric closure
// (Mehlhorn 1988).
class Region_graph
{
  const Csr_graph& m_graph;
  Voronoi_regions m_regions;
  std::vector<int> m_bridges; // of the edges
  Csr_graph m_coarse;

public:
  Region_graph(const Csr_graph& graph, const std::vector<int>& centers)
    : m_graph(graph), m_regions(graph, centers)
  {
    std::vector<Edge> coarse_edges;
    for(int e = 0; e < graph.number_of_edges(); ++e)
      if(m_regions.is_bridge(e)) {
        coarse_edges.push_back(Edge{m_regions.center(graph.edges[e].source), m_regions.center(graph.edges[e].target),
                                    m_regions.bridge_length(e)});
        m_bridges.push_back(e);
      }
    m_coarse = Csr_graph(int(centers.size()), std::move(coarse_edges));
  }

  // The first centers are the terminals, the others are evenly spread over the indices.
  Region_graph(const Csr_graph& graph, const std::vector<int>& terminals, int number_of_centers)
    : Region_graph(graph, choose_centers(graph, terminals, number_of_centers))
  {}

  const Csr_graph& graph() const { return m_coarse; }

  // the edges of the paths that these edges stand for
  std::vector<int> original_edges(const std::vector<int>& coarse_edges) const
  {
    std::vector<int> result;
    for(int e : coarse_edges) {
      const int bridge = m_bridges[e];
      result.push_back(bridge);
      m_regions.add_path(m_graph.edges[bridge].source, result);
      m_regions.add_path(m_graph.edges[bridge].target, result);
    }
    Graph_kernel::sort_unique(result);
    return result;
  }

private:
  static std::vector<int> choose_centers(const Csr_graph& graph, const std::vector<int>& terminals, int number)
  {
    std::vector<int> result(terminals);
    const std::vector<char> is_terminal = mark(graph.number_of_vertices(), terminals);
    for(int v = 0; v < graph.number_of_vertices(); v += (std::max)(1, graph.number_of_vertices() / number))
      if(!is_terminal[v])
        result.push_back(v);
    return result;
  }
};

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_REGION_GRAPH_H
