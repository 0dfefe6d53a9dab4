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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_CONSTRAINED_TRIANGULATION_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_CONSTRAINED_TRIANGULATION_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/soup/Least_triangulation.h>

#include <CGAL/Surface_mesh_parameterization/internal/bijective/Marked_triangulation.h>
#include <CGAL/boost/graph/internal/Graph_kernel/Execution.h>

#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using CGAL::internal::Graph_kernel::Go_further;

constexpr int maximal_size_of_least = 32; // of polygons; above, `Least_triangulation` takes longer than the constrained one

// The constrained Delaunay triangulation of a polygon seen along its area vector; empty where that does not make
// n - 2 triangles of the corners alone, as where the polygon crosses itself. It may touch itself in corners and along
// sides, as a polygon does whose hole is connected by a bridge. O(n log n) on usual polygons, and O(n^2) or more where sides
// cross many triangles of the corners, as those of long teeth. Asks before each corner and side whether to go on, and is empty
// if not: one of them takes O(n) on all but the worst polygons.
class Constrained_polygon
{
  using Triangulation = Surface_mesh_parameterization::internal::Marked_triangulation;
  using Face_handle = Triangulation::Face_handle;
  using Vertex_handle = Triangulation::Vertex_handle;

public:
  Constrained_polygon(const std::vector<Point>& polygon, const Go_further& go_further)
  {
    if(insert(polygon, go_further) && insert_sides(go_further) && m_triangulation.dimension() == 2)
      collect_triangles();
  }

  // Of corners, oriented like the polygon.
  const std::vector<Triangle>& triangles() const { return m_triangles; }

private:
  Vertex_handle next(std::size_t i) const { return m_corners[(i + 1) % m_corners.size()]; }
  Vertex_handle previous(std::size_t i) const { return m_corners[(i + m_corners.size() - 1) % m_corners.size()]; }

  // False if stopped.
  bool insert(const std::vector<Point>& polygon, const Go_further& go_further)
  {
    const Point normal = area_vector(polygon);
    int axis = 0; // that the normal is closest to
    for(int k : {1, 2})
      if(std::abs(normal[k]) > std::abs(normal[axis]))
        axis = k;
    const int x = normal[axis] < 0 ? (axis + 2) % 3 : (axis + 1) % 3, y = 3 - axis - x;
    std::vector<Triangulation::Point> points;
    points.reserve(polygon.size());
    for(const Point& p : polygon)
      points.emplace_back(p[x], p[y]);
    m_corners.resize(points.size());
    Face_handle former; // near the next one
    for(std::size_t i : spatial_order(points))
    {
      if(!go_further())
        return false;
      m_corners[i] = m_triangulation.insert(points[i], former);
      former = m_corners[i]->face();
    }
    return true;
  }

  // Along the polygon, each corner would be outside of all former triangles, which takes O(n).
  static std::vector<std::size_t> spatial_order(const std::vector<Triangulation::Point>& points)
  {
    using Map = Pointer_property_map<Triangulation::Point>::const_type;
    using Traits = Spatial_sort_traits_adapter_2<Triangulation::Geom_traits, Map>;
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    spatial_sort(order.begin(), order.end(), Traits(make_property_map(points)));
    return order;
  }

  // False if stopped, or if they cross.
  bool insert_sides(const Go_further& go_further)
  {
    try
    {
      for(std::size_t i = 0; i < m_corners.size(); ++i)
      {
        if(!go_further())
          return false;
        if(m_corners[i] != next(i))
          m_triangulation.insert_constraint(m_corners[i], next(i));
      }
    }
    catch(const Triangulation::Intersection_of_constraints_exception&)
    {
      return false;
    }
    return true;
  }

  void collect_triangles()
  {
    for(std::size_t i = 0; i < m_corners.size(); ++i)
      if(!take_sector(i))
        return;
    for(auto face : m_triangulation.finite_face_handles())
      if(const Triangle t = m_corners_of_faces[face]; (std::min)({t[0], t[1], t[2]}) >= 0)
        m_triangles.push_back(t);
    if(m_triangles.size() + 2 != m_corners.size())
      m_triangles.clear();
  }

  // Gives a corner to the faces between its two sides; false where that is impossible.
  bool take_sector(std::size_t i)
  {
    const Vertex_handle v = m_corners[i];
    Face_handle face;
    int k;
    if(!m_triangulation.is_edge(v, next(i), face, k))
      return false;
    face = face->neighbor(k); // on the left
    while(!m_triangulation.is_infinite(face))
    {
      k = face->index(v);
      if(std::exchange(m_corners_of_faces[face][k], int(i)) >= 0)
        return false;
      if(face->vertex(Triangulation::cw(k)) == previous(i))
        return true;
      if(face->is_constrained(Triangulation::ccw(k)))
        return false;
      face = face->neighbor(Triangulation::ccw(k));
    }
    return false;
  }

  Triangulation m_triangulation;
  std::vector<Vertex_handle> m_corners; // there may be several at a vertex
  Unique_hash_map<Face_handle, Triangle> m_corners_of_faces{Triangle{{-1, -1, -1}}};
  std::vector<Triangle> m_triangles;
};

inline std::vector<Triangle> constrained_triangulation(const std::vector<Point>& polygon, const Go_further& go_further)
{
  return Constrained_polygon(polygon, go_further).triangles();
}

// A triangulation of a polygon with several corners at a vertex, as of a disk that touches itself: no triangle is flat or
// turned over, no diagonal connects two corners at the same vertex. Empty if none is found, or if stopped.
inline std::vector<Triangle> touching_triangulation(const std::vector<Point>& polygon, const Is_taken& is_same_vertex,
                                                    const Go_further& go_further)
{
  const Point area = area_vector(polygon);
  const auto is_valid = [&](const std::vector<Triangle>& triangles)
  {
    return std::none_of(triangles.begin(), triangles.end(), [&](const Triangle& t)
    {
      return is_turned_over(polygon[t[0]], polygon[t[1]], polygon[t[2]], area) ||
             is_same_vertex(t[0], t[1]) || is_same_vertex(t[1], t[2]) || is_same_vertex(t[2], t[0]);
    });
  };
  std::vector<Triangle> triangles = constrained_triangulation(polygon, go_further);
  if(int(polygon.size()) <= maximal_size_of_least && (triangles.empty() || !is_valid(triangles)))
    triangles = Least_triangulation(polygon, is_same_vertex).triangles();
  return is_valid(triangles) ? triangles : std::vector<Triangle>();
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_CONSTRAINED_TRIANGULATION_H
