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

#include <CGAL/AABB_tree.h>
#if CGAL_VERSION_NR < 1060000000
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#else
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#endif
#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Finds the point of a surface that is closest to another one.
class Surface_distance
{
  using Kernel = Simple_cartesian<double>;
  using Triangles = std::vector<Kernel::Triangle_3>;
#if CGAL_VERSION_NR < 1060000000
  using Primitive = AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  using Tree = AABB_tree<AABB_traits<Kernel, Primitive> >;
#else
  using Primitive = AABB_triangle_primitive_3<Kernel, Triangles::const_iterator>;
  using Tree = AABB_tree<AABB_traits_3<Kernel, Primitive> >;
#endif

public:
  struct Closest
  {
    Point point;
    int vertex; // of the closest face, the nearest one
  };

  // O(n log n).
  explicit Surface_distance(const Indexed_mesh& mesh) : m_mesh(mesh)
  {
    for(int f = 0; f < mesh.number_of_faces(); ++f)
    {
      const Triangle& t = mesh.triangles()[f];
      const Kernel::Triangle_3 triangle(to_cgal(mesh.point(t[0])), to_cgal(mesh.point(t[1])), to_cgal(mesh.point(t[2])));
      if(triangle.is_degenerate()) // is no legal argument of the queries
        continue;
      m_triangles.push_back(triangle);
      m_faces.push_back(f);
    }
    m_tree.insert(m_triangles.begin(), m_triangles.end());
    m_tree.build();
    m_tree.accelerate_distance_queries();
  }

  bool is_empty() const { return m_triangles.empty(); }

  // Can be called by several threads.
  Closest closest(const Point& p) const
  {
    const auto [q, place] = m_tree.closest_point_and_primitive(to_cgal(p));
    Closest result{Point(q.x(), q.y(), q.z()), -1};
    for(const int v : m_mesh.triangles()[m_faces[std::size_t(place - m_triangles.begin())]])
      if(result.vertex < 0 || (m_mesh.point(v) - p).squaredNorm() < (m_mesh.point(result.vertex) - p).squaredNorm())
        result.vertex = v;
    return result;
  }

private:
  static Kernel::Point_3 to_cgal(const Point& p) { return {p.x(), p.y(), p.z()}; }

  const Indexed_mesh& m_mesh;
  Triangles m_triangles;
  std::vector<int> m_faces; // of the triangles
  Tree m_tree;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_SURFACE_DISTANCE_H
