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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_VERTEX_DISTORTION_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_VERTEX_DISTORTION_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The distortion of each surface vertex in a map of a chart (paper, Equation (3)).
inline std::vector<double>
vertex_distortion(const Indexed_mesh& mesh, const std::vector<Surface_mesh_parameterization::internal::Rest_shape>& shapes,
                  const Surface_mesh_parameterization::internal::Corner_table& chart, const std::vector<Eigen::Vector2d>& uv)
{
  using namespace Surface_mesh_parameterization::internal;
  return vertex_averages(shapes, mesh.triangles(), face_energies<Symmetric_Dirichlet_energy>(shapes, chart.triangles(), uv),
                         mesh.number_of_vertices());
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_VERTEX_DISTORTION_H
