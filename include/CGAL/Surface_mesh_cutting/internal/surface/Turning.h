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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_TURNING_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_TURNING_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// How ways along edges turn on the surface. A way that halves the angle around a vertex goes straight on, however the
// surface bends there.
class Turning
{
public:
  explicit Turning(const Indexed_mesh& mesh) : m_mesh(mesh)
  {
    using Surface_mesh_parameterization::internal::cross_product;
    m_angles.reserve(mesh.number_of_halfedges());
    for(int h = 0; h < mesh.number_of_halfedges(); ++h)
    {
      const Point& corner = mesh.point(mesh.source(h));
      const Point a = mesh.point(mesh.target(h)) - corner;
      const Point b = mesh.point(mesh.source(previous_halfedge(h))) - corner;
      m_angles.push_back(std::atan2(cross_product(a, b).norm(), a.dot(b)));
    }
  }

  // The halfedge of an edge that leads from this vertex, if the edge is inside the surface.
  int halfedge_from(int e, int vertex) const
  {
    const int h = m_mesh.halfedge(e);
    return m_mesh.source(h) == vertex ? h : m_mesh.opposite(h);
  }

  // To the left (positive) or right, in radians, of a way that arrives by `in` and leaves by `out`, at a vertex inside the
  // surface. The angle around it counts as a full turn.
  double operator()(int in, int out) const
  {
    const double left = angle_between(out, m_mesh.opposite(in)), right = angle_between(m_mesh.opposite(in), out);
    return left + right > 0 ? CGAL_PI * (right - left) / (left + right) : 0;
  }

private:
  // Counterclockwise between two halfedges that leave the same vertex.
  double angle_between(int first, int last) const
  {
    double sum = 0;
    for(int h = first; h != last; h = m_mesh.opposite(previous_halfedge(h)))
      sum += m_angles[h];
    return sum;
  }

  const Indexed_mesh& m_mesh;
  std::vector<double> m_angles; // of the corners, per halfedge that starts there
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_TURNING_H
