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

#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

inline Newton_options final_options(const Context& context)
{
  Newton_options options;
  options.decrement = mapping_policy(context.parameters).final_precision;
  options.go_further = context.control;
  return options;
}

// In `uv`, the running map, converged if it is not yet; it may overlap itself.
inline Newton_result converged_map(const Problem& problem, const Open_chart& running, const Context& context,
                                   std::vector<Eigen::Vector2d>& uv)
{
  const Newton_options options = final_options(context);
  uv = running.uv;
  if(running.precision > options.decrement)
    return Chart_parameterizer(running.chart, chart_points(problem.mesh, running.chart), problem.shapes,
                               *context.parameters.linear_solvers, running.chart_ranks())
      .improve_isometrically(uv, options);
  Newton_result result;
  result.outcome = Newton_outcome::CONVERGED;
  result.energy = running.energy;
  return result;
}

// The same, on request made bijective: the map to return. FAILED also where that comes to `hopeless_energy` on the way.
inline Newton_result final_map(const Problem& problem, const Open_chart& running, const Context& context,
                               std::vector<Eigen::Vector2d>& uv,
                               double hopeless_energy = std::numeric_limits<double>::infinity())
{
  const Newton_result converged = converged_map(problem, running, context, uv);
  if(!context.parameters.do_bijective)
    return converged;
  // Factorizations at full resolution are what takes long, and the first one leads near the optimum.
  constexpr double least_decrease = 5e-4;
  Newton_options options = final_options(context);
  if(context.parameters.ends_early_in_room())
    options.least_decrease = least_decrease;
  return Surface_mesh_parameterization::internal::make_bijective(
    running.chart, chart_points(problem.mesh, running.chart), problem.shapes, *context.parameters.linear_solvers, uv,
    converged, options, hopeless_energy);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_FINAL_MAP_H
