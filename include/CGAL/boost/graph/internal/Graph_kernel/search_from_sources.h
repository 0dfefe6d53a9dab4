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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SEARCH_FROM_SOURCES_H
#define CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SEARCH_FROM_SOURCES_H

#include <CGAL/boost/graph/internal/Graph_kernel/Distance_heap.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>

#include <functional>
#include <limits>
#include <vector>

namespace CGAL {
namespace internal {
namespace Graph_kernel {

// the distance at the end of an edge. Its index is larger than any, so that only a shorter path replaces another one.
struct Distance_along_edge
{
  template <typename Weight>
  Indexed_distance operator()(const Indexed_distance& distance, const Weight& weight) const
  {
    return Indexed_distance{distance.distance + double(weight), (std::numeric_limits<int>::max)()};
  }
};

// Boost's search from several sources: for each vertex the distance from the nearest one. Calls `relaxed(e)` for each
// edge that makes the path to its target shorter; the last one is on the shortest path. Vertices at the same
// distance are settled by index.
template <typename Graph, typename SourceRange, typename WeightMap, typename VertexIndexMap, typename Relaxed>
void search_from_sources(const Graph& graph, const SourceRange& sources, WeightMap weight, VertexIndexMap index,
                         std::vector<double>& distances, Relaxed relaxed)
{
  struct Visitor : public boost::default_dijkstra_visitor
  {
    Relaxed relaxed;

    explicit Visitor(Relaxed relaxed) : relaxed(relaxed) {}

    void edge_relaxed(const typename boost::graph_traits<Graph>::edge_descriptor& e, const Graph&) { relaxed(e); }
  };
  const double infinity = (std::numeric_limits<double>::infinity)();
  distances.assign(num_vertices(graph), infinity);
  // faster than Boost's default of two bits for each vertex
  std::vector<boost::default_color_type> colors(distances.size());
  boost::dijkstra_shortest_paths(graph, sources.begin(), sources.end(), boost::dummy_property_map(),
                                 Distance_map<VertexIndexMap>(distances, index), weight, index,
                                 std::less<Indexed_distance>(), Distance_along_edge(),
                                 Indexed_distance{infinity, 0}, Indexed_distance{0., 0}, Visitor(relaxed),
                                 boost::make_iterator_property_map(colors.begin(), index));
}

} // namespace Graph_kernel
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SEARCH_FROM_SOURCES_H
