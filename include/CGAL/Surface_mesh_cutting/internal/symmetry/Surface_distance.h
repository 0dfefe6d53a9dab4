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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_SURFACE_DISTANCE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_SURFACE_DISTANCE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Triangle_tree.h>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Finds the point of a surface that is closest to another one.
class Surface_distance
{
public:
  struct Closest
  {
    Point point;
    int vertex; // of the closest face, the nearest one
  };

  // O(n log n). The reference is kept.
  explicit Surface_distance(const Indexed_mesh& mesh) : m_mesh(mesh), m_triangles(mesh)
  {
    m_triangles.tree().accelerate_distance_queries();
  }

  bool is_empty() const { return m_triangles.is_empty(); }

  // Can be called by several threads.
  Closest closest(const Point& p) const
  {
    const auto [q, place] = m_triangles.tree().closest_point_and_primitive(Triangle_tree::to_cgal(p));
    Closest result{Point(q.x(), q.y(), q.z()), -1};
    for(const int v : m_mesh.triangles()[m_triangles.face(place)])
      if(result.vertex < 0 || (m_mesh.point(v) - p).squaredNorm() < (m_mesh.point(result.vertex) - p).squaredNorm())
        result.vertex = v;
    return result;
  }

private:
  const Indexed_mesh& m_mesh;
  Triangle_tree m_triangles;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_SURFACE_DISTANCE_H
