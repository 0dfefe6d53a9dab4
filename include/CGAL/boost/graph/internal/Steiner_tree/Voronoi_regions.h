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

#include <CGAL/boost/graph/internal/Graph_kernel/search_from_sources.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

using Graph_kernel::search_from_sources;

// For each vertex its nearest center, by one search from all centers. For any undirected model of Boost's concepts
// `VertexListGraph` and `IncidenceGraph` (or a directed one with each edge in both directions).
template <typename Graph, typename WeightMap, typename VertexIndexMap>
class Voronoi_regions
{
  typedef typename boost::graph_traits<Graph>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Graph>::edge_descriptor edge_descriptor;

  const Graph& m_graph;
  WeightMap m_weight;
  VertexIndexMap m_index;
  std::vector<double> m_distances;
  std::vector<int> m_centers; // by their positions; -1: none can be reached
  std::vector<edge_descriptor> m_last_edges;

public:
  Voronoi_regions(const Graph& graph, const std::vector<vertex_descriptor>& centers, WeightMap weight,
                  VertexIndexMap index)
    : m_graph(graph)
    , m_weight(weight)
    , m_index(index)
    , m_centers(num_vertices(graph), -1)
    , m_last_edges(num_vertices(graph))
  {
    for(std::size_t i = 0; i < centers.size(); ++i)
      m_centers[get(index, centers[i])] = int(i);
    search_from_sources(graph, centers, weight, index, m_distances, [this](const edge_descriptor& e) {
      const std::size_t v = get(m_index, target(e, m_graph));
      m_centers[v] = center(source(e, m_graph));
      m_last_edges[v] = e;
    });
  }

  // the position of the nearest center
  int center(vertex_descriptor v) const { return m_centers[get(m_index, v)]; }

  // does the edge join two regions, and then: how long is the connection of the centers through it?
  bool is_bridge(const edge_descriptor& e) const { return center(source(e, m_graph)) != center(target(e, m_graph)); }
  double bridge_length(const edge_descriptor& e) const
  {
    return distance(source(e, m_graph)) + double(get(m_weight, e)) + distance(target(e, m_graph));
  }

  // the last edge of the shortest path to `v`, which is not a center
  const edge_descriptor& last_edge(vertex_descriptor v) const { return m_last_edges[get(m_index, v)]; }

private:
  double distance(vertex_descriptor v) const { return m_distances[get(m_index, v)]; }
};

template <typename Graph, typename WeightMap, typename VertexIndexMap>
Voronoi_regions<Graph, WeightMap, VertexIndexMap>
voronoi_regions(const Graph& graph, const std::vector<typename boost::graph_traits<Graph>::vertex_descriptor>& centers,
                WeightMap weight, VertexIndexMap index)
{
  return Voronoi_regions<Graph, WeightMap, VertexIndexMap>(graph, centers, weight, index);
}

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_VORONOI_REGIONS_H
