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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_DIHEDRAL_ANGLES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_DIHEDRAL_ANGLES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/flatness.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// For each edge the angle between the normals of its faces: positive where the surface is convex, negative
// where it is concave, zero where there is only one normal.
inline std::vector<double> dihedral_angles(const Indexed_mesh& mesh)
{
  using Surface_mesh_parameterization::internal::cross_product;
  const std::vector<Eigen::Vector3d> normals = unit_normals(mesh);
  std::vector<double> result(mesh.number_of_edges(), 0.);
  for(int e = 0; e < mesh.number_of_edges(); ++e)
  {
    if(mesh.is_border_edge(e))
      continue;
    const int h = mesh.halfedge(e);
    const Eigen::Vector3d& first = normals[h / 3];
    const Eigen::Vector3d& second = normals[mesh.opposite(h) / 3];
    const Eigen::Vector3d edge = mesh.point(mesh.target(h)) - mesh.point(mesh.source(h));
    result[e] = std::atan2(cross_product(first, second).dot(edge.stableNormalized()), first.dot(second));
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_DIHEDRAL_ANGLES_H
