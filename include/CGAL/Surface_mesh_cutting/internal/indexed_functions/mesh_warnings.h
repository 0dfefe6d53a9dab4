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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_MESH_WARNINGS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_MESH_WARNINGS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/coincident_vertices_warning.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/parts_inside_out.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Indices from 0 to n - 1 for which `predicate` holds.
template <typename Predicate>
std::vector<int> indices_if(int n, const Predicate& predicate)
{
  std::vector<int> indices;
  for(int i = 0; i < n; ++i)
    if(predicate(i))
      indices.push_back(i);
  return indices;
}

enum class Thinness { NORMAL, NEEDLE, DEGENERATE };

// Needles have an angle below 0.01 degrees. Degenerate faces are so thin that their shape is replaced.
inline Thinness thinness(const Indexed_mesh& mesh, int f)
{
  constexpr double sine_of_a_hundredth_degree = 1.7453e-4;
  std::array<double, 3> lengths;
  for(int k = 0; k < 3; ++k)
    lengths[k] = mesh.length(mesh.edge(3 * f + k));
  std::sort(lengths.begin(), lengths.end());
  const double twice_area = 2 * mesh.face_area(f);
  return twice_area <= Surface_mesh_parameterization::internal::minimal_height * lengths[2] * lengths[2]
           ? Thinness::DEGENERATE
       : twice_area < sine_of_a_hundredth_degree * lengths[1] * lengths[2] ? Thinness::NEEDLE : Thinness::NORMAL;
}

// The edges that are far shorter than the longest one, without those of length zero.
inline std::vector<int> tiny_edges(const Indexed_mesh& mesh)
{
  constexpr double tiny = 1e-5;
  double longest = 0;
  for(double length : mesh.lengths())
    longest = (std::max)(longest, length);
  return indices_if(mesh.number_of_edges(),
                    [&](int e) { return mesh.length(e) > 0 && mesh.length(e) <= tiny * longest; });
}

// The vertices, isolated ones apart, at the very point of another one.
inline std::vector<int> coincident_vertices(const Indexed_mesh& mesh)
{
  const auto coordinates = [&mesh](int v)
  { return std::array<double, 3>{{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}}; };
  std::vector<int> order
    = indices_if(mesh.number_of_vertices(), [&mesh](int v) { return !mesh.is_isolated(v); });
  std::sort(order.begin(), order.end(), [&](int v, int w) { return coordinates(v) < coordinates(w); });
  std::vector<int> vertices;
  for(std::size_t i = 0; i < order.size(); ++i)
    if((i > 0 && mesh.point(order[i]) == mesh.point(order[i - 1])) ||
       (i + 1 < order.size() && mesh.point(order[i]) == mesh.point(order[i + 1])))
      vertices.push_back(order[i]);
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

CGAL_INLINE_UNLESS_SEPARATE std::vector<Finding> mesh_warnings(const Indexed_mesh& mesh)
{
  constexpr int many_neighbors = 1000;
  std::vector<Finding> warnings;
  const auto warn = [&warnings](const char* message, Element_kind kind, std::vector<int> indices)
  {
    if(!indices.empty())
      warnings.push_back(Finding{Status_code::OK, message, kind, std::move(indices)});
  };
  const auto faces = [&mesh](Thinness t)
  { return indices_if(mesh.number_of_faces(), [&](int f) { return thinness(mesh, f) == t; }); };

  warn("isolated vertices, which are ignored", Element_kind::VERTEX,
       indices_if(mesh.number_of_vertices(), [&](int v) { return mesh.is_isolated(v); }));
  warn("edges of length zero", Element_kind::EDGE,
       indices_if(mesh.number_of_edges(), [&](int e) { return mesh.length(e) == 0; }));
  warn("faces of (nearly) no area, which are treated as slightly thicker", Element_kind::FACE,
       faces(Thinness::DEGENERATE));
  warn("faces with an angle below 0.01 degrees", Element_kind::FACE, faces(Thinness::NEEDLE));
  warn("edges shorter than 1e-5 of the longest one", Element_kind::EDGE, tiny_edges(mesh));
  warn(coincident_vertices_warning, Element_kind::VERTEX, coincident_vertices(mesh));
  warn("vertices with 1000 neighbors or more", Element_kind::VERTEX,
       indices_if(mesh.number_of_vertices(), [&](int v) { return mesh.graph().degree(v) >= many_neighbors; }));
  warn("closed parts that are inside out, each named by a face", Element_kind::FACE,
       faces_of_parts_inside_out(mesh));
  return warnings;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_MESH_WARNINGS_H
