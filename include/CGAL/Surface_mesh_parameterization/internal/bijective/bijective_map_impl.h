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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_BIJECTIVE_MAP_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_BIJECTIVE_MAP_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Chart_parameterizer.h>
#include <CGAL/Surface_mesh_parameterization/internal/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/bijective/Border_overlaps.h>
#include <CGAL/Surface_mesh_parameterization/internal/bijective/Scaffold_minimization.h>
#include <CGAL/Surface_mesh_parameterization/internal/bijective/bijective_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/exact_flips.h>

#include <CGAL/boost/graph/internal/Graph_kernel/separate_implementation.h>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_INLINE_UNLESS_SEPARATE
bool is_bijective(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv, Execution execution)
{
  if(count_flips(chart.triangles(), uv, nullptr, execution) > 0)
    return false;
  const Border_overlaps overlaps(chart, Connected_parts(chart.opposites()), uv);
  return overlaps.crossings().empty() && overlaps.containments().empty();
}

// An injective map near the optimum of a surface, whose shape `points` are: Tutte's embedding of the coarsest stage of the
// hierarchy is injective, optimizing a stage with a scaffold keeps it so, and refinement does not leave its image. The
// stage that ends above `hopeless_energy` is the last.
inline Stages_outcome bijective_stages(const Corner_table& chart, const std::vector<Eigen::Vector3d>& points,
                                       const Solvers& linear_solvers, const Scaffold_options& options,
                                       double hopeless_energy, std::vector<Eigen::Vector2d>& uv)
{
  // In coarse stages, which cost little, parts of the chart still travel far, which they hardly can where triangles are
  // small: these stages are solved as tightly as the chart, with scaffolds that move.
  constexpr int largest_coarse_stage = 1000, coarse_fraction = 32;
  const int largest_tight_stage = (std::max)(largest_coarse_stage, chart.number_of_vertices() / coarse_fraction);
  const auto optimize = [&](const Chart_hierarchy::Stage& stage, std::vector<Eigen::Vector2d>& stage_uv)
  {
    Scaffold_options stage_options = options;
    stage_options.moves_scaffold = stage.chart.number_of_vertices() <= largest_tight_stage;
    if(!stage_options.moves_scaffold)
      stage_options.decrease = 1e-2; // the next stage goes on
    const Newton_result result = Scaffold_minimization(stage.chart, stage.shapes, linear_solvers, stage_options)(stage_uv);
    return result.energy > hopeless_energy ? Newton_outcome::STOPPED : result.outcome;
  };
  constexpr bool keeps_region = true;
  const auto is_valid = [&](const std::vector<Eigen::Vector2d>& map)
  { return is_bijective(chart, map, linear_solvers.execution); };
  return map_by_stages<Symmetric_Dirichlet_energy>(chart, points, keeps_region, linear_solvers, optimize, is_valid, uv);
}

// An injective map near the optimum, from the isometric one, which overlaps itself. The latter as a flat surface has all
// its distortion in its shape already: what it takes to bend its parts apart is smooth, so that coarse stages find it.
// Should that fail, stages of the surface itself are mapped, or Tutte's embedding of the whole chart is optimized. False
// if rounding spoils all, if stopped, or if a stage ends above `hopeless_energy`.
inline bool bijective_start(const Corner_table& chart, const std::vector<Eigen::Vector3d>& points,
                            const std::vector<Rest_shape>& shapes, const Solvers& linear_solvers,
                            const Scaffold_options& options, double hopeless_energy, std::vector<Eigen::Vector2d>& uv)
{
  std::vector<Eigen::Vector3d> flat;
  for(const Eigen::Vector2d& p : uv)
    flat.emplace_back(p.x(), p.y(), 0);
  Stages_outcome outcome = bijective_stages(chart, flat, linear_solvers, options, hopeless_energy, uv);
  if(outcome == Stages_outcome::FAILED)
    outcome = bijective_stages(chart, points, linear_solvers, options, hopeless_energy, uv);
  if(outcome != Stages_outcome::FAILED)
    return outcome == Stages_outcome::MAPPED;
  if(!tutte_map(chart, points, surface_area(shapes), linear_solvers, uv))
    return false;
  Scaffold_options tutte_options = options;
  tutte_options.moves_scaffold = true;
  Scaffold_minimization(chart, shapes, linear_solvers, tutte_options)(uv);
  return is_bijective(chart, uv, linear_solvers.execution);
}

CGAL_INLINE_UNLESS_SEPARATE
Newton_result make_bijective(const Corner_table& chart, const std::vector<Eigen::Vector3d>& points,
                             const std::vector<Rest_shape>& shapes, const Solvers& linear_solvers,
                             std::vector<Eigen::Vector2d>& uv, const Newton_result& isometric,
                             const Newton_options& options,
                             double hopeless_energy)
{
  if(isometric.outcome == Newton_outcome::FAILED || is_bijective(chart, uv, linear_solvers.execution))
    return isometric;
  Scaffold_options scaffold_options;
  scaffold_options.go_further = options.go_further;
  if(isometric.outcome == Newton_outcome::STOPPED ||
     !bijective_start(chart, points, shapes, linear_solvers, scaffold_options, hopeless_energy, uv))
    return Newton_result();
  scaffold_options.least_decrease = options.least_decrease;
  scaffold_options.least_energy = isometric.energy;
  const Newton_result result = Scaffold_minimization(chart, shapes, linear_solvers, scaffold_options)(uv);
  return is_bijective(chart, uv, linear_solvers.execution) ? result : Newton_result();
}

CGAL_INLINE_UNLESS_SEPARATE
Newton_result bijective_map(const Corner_table& chart, const std::vector<Eigen::Vector3d>& points,
                            const std::vector<Rest_shape>& shapes, const Solvers& linear_solvers,
                            std::vector<Eigen::Vector2d>& uv, const Newton_options& options)
{
  const Newton_result isometric
    = Chart_parameterizer(chart, points, shapes, linear_solvers).isometric_map(uv, options);
  return make_bijective(chart, points, shapes, linear_solvers, uv, isometric, options);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_BIJECTIVE_MAP_IMPL_H
