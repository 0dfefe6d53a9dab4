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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_VORONOI_REGIONS_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_VORONOI_REGIONS_H

#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Tree.h>

#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

using Graph_kernel::Shortest_paths;

// For each vertex its nearest center, by one search from all centers. O(m log n)
class Voronoi_regions
{
  const Csr_graph& m_graph;
  Shortest_paths m_paths;
  std::vector<int> m_centers; // by their positions; -1: none can be reached

public:
  Voronoi_regions(const Csr_graph& graph, const std::vector<int>& centers)
    : m_graph(graph), m_paths(graph), m_centers(graph.number_of_vertices(), -1)
  {
    for(std::size_t i = 0; i < centers.size(); ++i) {
      m_centers[centers[i]] = int(i);
      m_paths.add_source(centers[i]);
    }
    m_paths.run([this](int v) {
      if(m_paths.last_edge(v) >= 0)
        m_centers[v] = m_centers[m_paths.predecessor(v)];
      return true;
    });
  }

  // the position of the nearest center
  int center(int v) const { return m_centers[v]; }

  // does the edge join two regions, and then: how long is the connection of the centers through it?
  bool is_bridge(int e) const { return center(m_graph.edges[e].source) != center(m_graph.edges[e].target); }
  double bridge_length(int e) const
  {
    const Edge& edge = m_graph.edges[e];
    return m_paths.distance(edge.source) + edge.weight + m_paths.distance(edge.target);
  }

  // appends the edges of the shortest path from the center
  void add_path(int v, std::vector<int>& path) const { m_paths.path(v, std::back_inserter(path)); }
};

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_VORONOI_REGIONS_H
