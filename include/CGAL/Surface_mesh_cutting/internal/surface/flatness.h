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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_FLATNESS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_FLATNESS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The unit normal, or zero for a face without area.
inline Eigen::Vector3d unit_normal(const Indexed_mesh& mesh, int f)
{
  const Triangle& t = mesh.triangles()[f];
  const Eigen::Vector3d u = mesh.point(t[1]) - mesh.point(t[0]), v = mesh.point(t[2]) - mesh.point(t[0]);
  return Surface_mesh_parameterization::internal::cross_product(u.stableNormalized(), v.stableNormalized())
    .stableNormalized();
}

inline std::vector<Eigen::Vector3d> unit_normals(const Indexed_mesh& mesh)
{
  std::vector<Eigen::Vector3d> normals;
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    normals.push_back(unit_normal(mesh, f));
  return normals;
}

// For each edge the cosine of the angle between the normals of its faces, 0 if that is more than a
// right angle; 1 where there is only one normal.
inline std::vector<double> flatness(const Indexed_mesh& mesh)
{
  const std::vector<Eigen::Vector3d> normals = unit_normals(mesh);
  std::vector<double> result(mesh.number_of_edges(), 1.);
  for(int e = 0; e < mesh.number_of_edges(); ++e)
  {
    if(mesh.is_border_edge(e))
      continue;
    const Eigen::Vector3d& first = normals[mesh.halfedge(e) / 3];
    const Eigen::Vector3d& second = normals[mesh.opposite(mesh.halfedge(e)) / 3];
    if(!first.isZero() && !second.isZero())
      result[e] = (std::min)((std::max)(first.dot(second), 0.), 1.);
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_FLATNESS_H
