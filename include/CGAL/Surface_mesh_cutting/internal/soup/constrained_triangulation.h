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

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The constrained Delaunay triangulation of a polygon seen along its area vector; empty where that does not make
// n - 2 triangles of the corners alone, as where the polygon crosses or touches itself. O(n log n) on usual polygons.
inline std::vector<Triangle> constrained_triangulation(const std::vector<Point>& polygon)
{
  using Triangulation = Surface_mesh_parameterization::internal::Marked_triangulation;

  const Point normal = area_vector(polygon);
  int axis = 0; // that the normal is closest to
  for(int k : {1, 2})
    if(std::abs(normal[k]) > std::abs(normal[axis]))
      axis = k;
  const int x = normal[axis] < 0 ? (axis + 2) % 3 : (axis + 1) % 3, y = 3 - axis - x;

  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> corners;
  for(int i = 0; i < int(polygon.size()); ++i)
  {
    corners.push_back(triangulation.insert(Triangulation::Point(polygon[i][x], polygon[i][y])));
    corners.back()->info() = i;
  }
  try
  {
    for(std::size_t i = 0; i < corners.size(); ++i)
      if(corners[i] != corners[(i + 1) % corners.size()])
        triangulation.insert_constraint(corners[i], corners[(i + 1) % corners.size()]);
  }
  catch(const Triangulation::Intersection_of_constraints_exception&)
  {
    return {};
  }
  if(triangulation.number_of_vertices() != corners.size() || triangulation.dimension() != 2)
    return {};

  for(auto face : triangulation.all_face_handles())
    face->info() = false; // whether it is known to lie outside
  std::vector<Triangulation::Face_handle> outside = {triangulation.infinite_face()};
  outside.front()->info() = true;
  while(!outside.empty())
  {
    const Triangulation::Face_handle face = outside.back();
    outside.pop_back();
    for(int k = 0; k < 3; ++k)
      if(!face->is_constrained(k) && !std::exchange(face->neighbor(k)->info(), true))
        outside.push_back(face->neighbor(k));
  }
  std::vector<Triangle> triangles;
  for(auto face : triangulation.finite_face_handles())
    if(!face->info())
      triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  if(triangles.size() + 2 != corners.size())
    triangles.clear();
  return triangles;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_CONSTRAINED_TRIANGULATION_H
