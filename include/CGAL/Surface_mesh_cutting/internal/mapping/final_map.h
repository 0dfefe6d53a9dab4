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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_FINAL_MAP_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_FINAL_MAP_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Incremental_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/bijective/bijective_map.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The map to return in `uv`: the running one, converged if it is not yet, and on request made
// bijective.
inline Newton_result final_map(const Problem& problem, const Open_chart& running, const Context& context,
                               std::vector<Eigen::Vector2d>& uv)
{
  Newton_options options;
  options.decrement = mapping_policy(context.parameters).final_precision;
  options.go_further = context.control;
  const Linear_solver_source& linear_solvers = *context.parameters.linear_solvers;
  const std::vector<Eigen::Vector3d> points = chart_points(problem.mesh, running.chart);
  Newton_result result;
  uv = running.uv;
  if(running.precision <= options.decrement)
  {
    result.outcome = Newton_outcome::CONVERGED;
    result.energy = running.energy;
  }
  else
    result
      = Chart_parameterizer(running.chart, points, problem.shapes, linear_solvers, running.chart_ranks())
          .improve_isometrically(uv, options);
  if(!context.parameters.do_bijective)
    return result;
  return Surface_mesh_parameterization::internal::make_bijective(running.chart, points, problem.shapes,
                                                                 linear_solvers, uv, result, options,
                                                                 running.chart_ranks());
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_FINAL_MAP_H
