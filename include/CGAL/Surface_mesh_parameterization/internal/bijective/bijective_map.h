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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_BIJECTIVE_MAP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_BIJECTIVE_MAP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/hierarchical_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_solver.h>

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Whether `uv` flips no triangle and is injective up to contact; exact.
bool is_bijective(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv,
                  Execution execution = Execution::SEQUENTIAL);

// As isometric as possible among the injective maps of a connected chart, free border; `uv` holds the
// isometric map, with what its solve returned. That is the answer if its borders do not overlap.
// FAILED if no injective map was found, or if one on the way has more than `hopeless_energy`.
Newton_result make_bijective(const Corner_table& chart, const std::vector<Eigen::Vector3d>& points,
                             const std::vector<Rest_shape>& shapes, const Solvers& linear_solvers,
                             std::vector<Eigen::Vector2d>& uv, const Newton_result& isometric,
                             const Newton_options& options,
                             double hopeless_energy = std::numeric_limits<double>::infinity());

// The same without a map to start with. `points` holds the position of each chart vertex on the
// surface, `shapes` the triangles laid flat.
Newton_result bijective_map(const Corner_table& chart, const std::vector<Eigen::Vector3d>& points,
                            const std::vector<Rest_shape>& shapes, const Solvers& linear_solvers,
                            std::vector<Eigen::Vector2d>& uv, const Newton_options& options);

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_parameterization/internal/bijective/bijective_map_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_BIJECTIVE_MAP_H
