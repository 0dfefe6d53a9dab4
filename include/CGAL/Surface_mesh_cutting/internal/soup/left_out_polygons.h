// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_LEFT_OUT_POLYGONS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_LEFT_OUT_POLYGONS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/soup/Polygons.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Buckets.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using CGAL::internal::Graph_kernel::Buckets;

// Per vertex, the first one that polygons use at exactly the same point. O(n).
inline std::vector<int> first_vertices_at_points(const std::vector<Point>& points, const Polygons& polygons)
{
  using Coordinates = std::array<double, 3>;
  std::vector<char> is_used(points.size(), 0);
  for(int v : polygons.vertices)
    is_used[v] = 1;
  std::unordered_map<Coordinates, int, boost::hash<Coordinates> > first;
  std::vector<int> result(points.size());
  for(int v = 0; v < int(points.size()); ++v)
  {
    const Point p = points[v] + Point::Zero(); // -0 becomes 0
    result[v] = is_used[v] ? first.emplace(Coordinates{{p.x(), p.y(), p.z()}}, v).first->second : v;
  }
  return result;
}

// For each polygon that has the vertices of a former one in the same cyclic order, the first such; -1 for the others.
// Those that are not `is_simple` are passed over. O(n) unless many polygons share their lowest vertex.
inline std::vector<int> former_duplicates(const Polygons& polygons, const std::vector<char>& is_simple,
                                          int number_of_vertices, Execution execution)
{
  std::vector<int> starts(polygons.ends.size()); // the corner at the lowest vertex
  const auto lowest_vertex = [&](int polygon) { return polygons.vertices[starts[polygon]]; };
  for(int p = 0; p < polygons.number(); ++p)
    if(is_simple[p])
    {
      const auto corners = polygons.vertices.begin();
      starts[p] = int(std::min_element(corners + polygons.begin(p), corners + polygons.end(p)) - corners);
    }
  Buckets<int> simple_polygons(number_of_vertices, [&](const auto& visit)
  {
    for(int p = 0; p < polygons.number(); ++p)
      if(is_simple[p])
        visit(lowest_vertex(p), p);
  });

  // Negative, zero or positive, as the vertices of one come before, with or after those of the other.
  const auto comparison = [&](int p, int q)
  {
    if(polygons.size(p) != polygons.size(q))
      return polygons.size(p) - polygons.size(q);
    int c = starts[p], d = starts[q];
    for(int i = 0; i < polygons.size(p); ++i, c = polygons.next(p, c), d = polygons.next(q, d))
      if(polygons.vertices[c] != polygons.vertices[d])
        return polygons.vertices[c] - polygons.vertices[d];
    return 0;
  };
  std::vector<int> result(polygons.ends.size(), -1);
  Surface_mesh_parameterization::internal::execute_blocks(execution, number_of_vertices, [&](int first, int last)
  {
    for(int v = first; v < last; ++v)
    {
      const auto order = simple_polygons[v];
      std::sort(order.begin(), order.end(), [&](int p, int q)
                { const int c = comparison(p, q); return c != 0 ? c < 0 : p < q; });
      for(int i = 1; i < simple_polygons.size(v); ++i)
      {
        const int p = order.begin()[i - 1], q = order.begin()[i];
        if(comparison(p, q) == 0)
          result[q] = result[p] >= 0 ? result[p] : p;
      }
    }
  });
  return result;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_LEFT_OUT_POLYGONS_H
