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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_PARTS_INSIDE_OUT_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_PARTS_INSIDE_OUT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using Surface_mesh_parameterization::internal::Connected_parts;

// A face of each closed part that is oriented inward. O(n).
inline std::vector<int> faces_of_parts_inside_out(const Indexed_mesh& mesh, const Connected_parts& parts)
{
  // A volume this small against the area is rounding, or no inside at all.
  constexpr double smallest_volume = 1e-9;
  struct Part { int face = -1; bool is_closed = true; double volume = 0, area = 0; };
  std::vector<Part> sums(parts.number);
  for(int f = 0; f < mesh.number_of_faces(); ++f)
  {
    Part& part = sums[parts.part[f]];
    if(part.face < 0)
      part.face = f;
    const Point& origin = mesh.point(mesh.source(3 * part.face));
    const Triangle& t = mesh.triangles()[f];
    const Point a = mesh.point(t[0]) - origin, b = mesh.point(t[1]) - origin, c = mesh.point(t[2]) - origin;
    part.volume += a.dot(Surface_mesh_parameterization::internal::cross_product(b, c)) / 6;
    part.area += mesh.face_area(f);
    for(int h = 3 * f; h < 3 * f + 3; ++h)
      part.is_closed = part.is_closed && !mesh.is_border(h);
  }
  std::vector<int> faces;
  for(const Part& part : sums)
    if(part.is_closed && part.volume < -smallest_volume * std::pow(part.area, 1.5))
      faces.push_back(part.face);
  return faces;
}

inline std::vector<int> faces_of_parts_inside_out(const Indexed_mesh& mesh)
{
  return faces_of_parts_inside_out(mesh, Connected_parts(mesh.opposites()));
}

// Per face, whether it is one of a closed part that is oriented inward. O(n).
inline std::vector<char> inside_out(const Indexed_mesh& mesh)
{
  const Connected_parts parts(mesh.opposites());
  std::vector<char> is_inside_out(parts.number, 0);
  for(int f : faces_of_parts_inside_out(mesh, parts))
    is_inside_out[parts.part[f]] = 1;
  std::vector<char> result(mesh.number_of_faces());
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    result[f] = is_inside_out[parts.part[f]];
  return result;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_PARTS_INSIDE_OUT_H
