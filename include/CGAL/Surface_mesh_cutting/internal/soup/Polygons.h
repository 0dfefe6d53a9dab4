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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_POLYGONS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_POLYGONS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Polygons in index arrays: their corners one after the other. Side c leads from corner c to the next corner of the
// same polygon.
struct Polygons
{
  std::vector<int> vertices; // per corner
  std::vector<int> ends;     // per polygon, where its corners end

  int number() const { return int(ends.size()); }
  int number_of_corners() const { return int(vertices.size()); }
  int begin(int polygon) const { return polygon == 0 ? 0 : ends[std::size_t(polygon) - 1]; }
  int end(int polygon) const { return ends[polygon]; }
  int size(int polygon) const { return end(polygon) - begin(polygon); }

  // Makes a polygon of the corners added since the last call.
  void close() { ends.push_back(number_of_corners()); }

  int next(int polygon, int corner) const { return corner + 1 == end(polygon) ? begin(polygon) : corner + 1; }
  int previous(int polygon, int corner) const { return (corner == begin(polygon) ? end(polygon) : corner) - 1; }

  // The polygon of each corner.
  std::vector<int> owners() const
  {
    std::vector<int> result;
    result.reserve(vertices.size());
    for(int polygon = 0; polygon < number(); ++polygon)
      result.insert(result.end(), std::size_t(size(polygon)), polygon);
    return result;
  }

  // Whether each polygon has three corners or more, no two at the same vertex, of `number_of_vertices`. O(n).
  std::vector<char> are_simple(int number_of_vertices) const
  {
    std::vector<int> latest(number_of_vertices, -1);
    std::vector<char> result(ends.size(), 1);
    for(int polygon = 0; polygon < number(); ++polygon)
    {
      result[polygon] = size(polygon) >= 3;
      for(int c = begin(polygon); c < end(polygon); ++c)
        if(std::exchange(latest[vertices[c]], polygon) == polygon)
          result[polygon] = 0;
    }
    return result;
  }

  // Whether a polygon has three corners or more, no two of its neighbors at the same vertex.
  bool has_sides(int polygon) const
  {
    bool result = size(polygon) >= 3;
    for(int c = begin(polygon); c < end(polygon); ++c)
      result = result && vertices[c] != vertices[next(polygon, c)];
    return result;
  }
};

// The same polygons of other vertices: `vertices[v]` for each `v`.
inline Polygons renumbered(Polygons polygons, const std::vector<int>& vertices)
{
  for(int& v : polygons.vertices)
    v = vertices[v];
  return polygons;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_POLYGONS_H
