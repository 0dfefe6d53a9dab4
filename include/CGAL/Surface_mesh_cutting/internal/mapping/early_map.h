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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_EARLY_MAP_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_EARLY_MAP_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Run_control.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>

#include <CGAL/Surface_mesh_parameterization/internal/bijective/Scaffold_minimization.h>
#include <CGAL/Surface_mesh_parameterization/internal/bijective/bijective_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A map without overlaps of a disk, quickly: Tutte's embedding of the coarsest stage of the hierarchy is refined to the whole,
// and stages are optimized only as long as `goes_on()`. Should rounding spoil that, Tutte's embedding of the whole. False if
// that fails, too.
inline bool early_map(const Problem& problem, const Corner_table& chart,
                      const Surface_mesh_parameterization::internal::Solvers& given, const Go_further& goes_on,
                      Surface_mesh_parameterization::internal::Execution execution, std::vector<Eigen::Vector2d>& uv)
{
  using namespace Surface_mesh_parameterization::internal;
  const Solvers solvers = given.is_given ? given : default_solvers(always_go_further, execution);
  const Solvers stage_solvers = given.is_given ? given : default_solvers(goes_on, execution);
  Scaffold_options options;
  options.decrease = 1e-2;
  options.moves_scaffold = true;
  options.go_further = goes_on;
  const auto optimize = [&](const Chart_hierarchy::Stage& stage, std::vector<Eigen::Vector2d>& stage_uv)
  {
    if(goes_on())
      Scaffold_minimization(stage.chart, stage.shapes, stage_solvers, options)(stage_uv);
    return Newton_outcome::CONVERGED; // any injective map will do
  };
  const auto is_valid = [&](const std::vector<Eigen::Vector2d>& map) { return is_bijective(chart, map, execution); };
  const std::vector<Point> points = chart_points(problem.mesh, chart);
  constexpr bool keeps_region = true;
  return map_by_stages<Symmetric_Dirichlet_energy>(chart, points, keeps_region, solvers, optimize, is_valid, uv)
           == Stages_outcome::MAPPED ||
         (tutte_map(chart, points, surface_area(problem.shapes), solvers, uv) && is_valid(uv));
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_EARLY_MAP_H
