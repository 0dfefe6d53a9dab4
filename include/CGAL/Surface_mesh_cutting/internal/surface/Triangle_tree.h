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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_TRIANGLE_TREE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_TRIANGLE_TREE_H

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

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// CGAL's search tree of the triangles of a surface, without those that have no area: they are no legal argument of its queries.
class Triangle_tree
{
public:
  using Kernel = Simple_cartesian<double>;

private:
  using Triangles = std::vector<Kernel::Triangle_3>;
#if CGAL_VERSION_NR < 1060000000
  using Primitive = AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  using Tree = AABB_tree<AABB_traits<Kernel, Primitive> >;
#else
  using Primitive = AABB_triangle_primitive_3<Kernel, Triangles::const_iterator>;
  using Tree = AABB_tree<AABB_traits_3<Kernel, Primitive> >;
#endif

public:
  // O(n log n).
  explicit Triangle_tree(const Indexed_mesh& mesh)
  {
    for(int f = 0; f < mesh.number_of_faces(); ++f)
    {
      const Triangle& t = mesh.triangles()[f];
      const Kernel::Triangle_3 triangle(to_cgal(mesh.point(t[0])), to_cgal(mesh.point(t[1])), to_cgal(mesh.point(t[2])));
      if(triangle.is_degenerate())
        continue;
      m_triangles.push_back(triangle);
      m_faces.push_back(f);
    }
    m_tree.insert(m_triangles.begin(), m_triangles.end());
    m_tree.build();
  }

  // The tree refers to the triangles.
  Triangle_tree(const Triangle_tree&) = delete;
  Triangle_tree& operator=(const Triangle_tree&) = delete;

  static Kernel::Point_3 to_cgal(const Point& p) { return {p.x(), p.y(), p.z()}; }

  bool is_empty() const { return m_triangles.empty(); }

  // Its queries can be called by several threads.
  const Tree& tree() const { return m_tree; }
  Tree& tree() { return m_tree; }

  // The face that a query has found.
  int face(Triangles::const_iterator place) const { return m_faces[place - m_triangles.begin()]; }

private:
  Triangles m_triangles;
  std::vector<int> m_faces; // of the triangles
  Tree m_tree;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_TRIANGLE_TREE_H
