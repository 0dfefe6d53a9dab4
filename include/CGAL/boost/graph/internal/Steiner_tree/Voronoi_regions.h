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

#include <CGAL/boost/graph/internal/Steiner_tree/Shortest_paths.h>

#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

// For each vertex its nearest center, by one search from all centers.
class Voronoi_regions
{
  Shortest_paths m_paths;
  std::vector<int> m_centers; // -1: no center can be reached

public:
  Voronoi_regions(const Csr_graph& graph, const std::vector<int>& centers)
    : m_paths(graph), m_centers(graph.number_of_vertices(), -1)
  {
    for(int c : centers)
      m_paths.add_source(c);
    m_paths.run([this](int v) {
      m_centers[v] = m_paths.last_edge(v) < 0 ? v : m_centers[m_paths.predecessor(v)];
      return true;
    });
  }

  int center(int v) const { return m_centers[v]; }
  double distance(int v) const { return m_paths.distance(v); }

  // does the edge join two regions, and then: how long is the connection of the centers through it?
  bool is_bridge(const Edge& edge) const { return m_centers[edge.source] != m_centers[edge.target]; }
  double bridge_length(const Edge& edge) const
  {
    return distance(edge.source) + edge.weight + distance(edge.target);
  }

  // appends the edges of the shortest path from the center to `v`
  template <typename OutputIterator>
  OutputIterator path(int v, OutputIterator out) const
  {
    return m_paths.path(v, out);
  }
};

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_VORONOI_REGIONS_H
