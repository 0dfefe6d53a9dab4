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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_HIERARCHICAL_MAP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_HIERARCHICAL_MAP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/exact_flips.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Chart_hierarchy.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_solver.h>

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

inline std::vector<Eigen::Vector2d> restricted(const std::vector<Eigen::Vector2d>& uv, const std::vector<int>& vertices)
{
  std::vector<Eigen::Vector2d> result;
  for(int v : vertices)
    result.push_back(uv[v]);
  return result;
}

inline void extend(const std::vector<Eigen::Vector2d>& stage_uv, const std::vector<int>& vertices,
                   std::vector<Eigen::Vector2d>& uv)
{
  for(std::size_t v = 0; v < vertices.size(); ++v)
    uv[vertices[v]] = stage_uv[v];
}

constexpr int growth_of_stages = 4; // each has to be ordered and factorized

inline int next_smaller_stage(int number_of_vertices)
{
  return (number_of_vertices + growth_of_stages - 1) / growth_of_stages;
}

// The number of vertices of the coarsest stage, from which growth by a constant factor ends at the whole chart: a stage
// of almost as many vertices as that would cost as much, for nothing. Tutte's embedding of so few is cheap and sound.
inline int coarsest_size(int number_of_vertices)
{
  constexpr int largest = 500;
  while(number_of_vertices > largest)
    number_of_vertices = next_smaller_stage(number_of_vertices);
  return number_of_vertices;
}

enum class Stages_outcome { MAPPED, FAILED, STOPPED };

// From Tutte's embedding of the stage of about `coarsest_size` vertices to the whole chart.
template <typename Energy, typename Optimize>
Stages_outcome map_by_stages(Chart_hierarchy& hierarchy, int coarsest_size,
                             const Solvers& linear_solvers, const Optimize& optimize,
                             std::vector<Eigen::Vector2d>& uv)
{
  hierarchy.coarsen(coarsest_size, 0); // stages may be rough: each only has to initialize the next
  for(bool is_first = true; is_first || !hierarchy.is_complete(); is_first = false)
  {
    const Chart_hierarchy::Stage stage = hierarchy.stage();
    std::vector<Eigen::Vector2d> stage_uv = restricted(uv, stage.vertices);
    if(is_first && !tutte_map(stage.chart, stage.points, surface_area(stage.shapes), linear_solvers, stage_uv))
      return Stages_outcome::FAILED;
    const Newton_outcome outcome = optimize(stage, stage_uv);
    if(outcome == Newton_outcome::STOPPED)
      return Stages_outcome::STOPPED;
    if(outcome == Newton_outcome::SINGULAR || outcome == Newton_outcome::FAILED)
      return Stages_outcome::FAILED;
    extend(stage_uv, stage.vertices, uv);
    if(!hierarchy.refine_to<Energy>(growth_of_stages * hierarchy.number_of_vertices(), uv))
      return Stages_outcome::FAILED;
  }
  return Stages_outcome::MAPPED;
}

// A map from nothing: the coarsest stage of the hierarchy is mapped by Tutte's embedding, each stage is optimized by
// `optimize(stage, uv)` and handed to the next, four times as large. `uv` is near the optimum on return, but not
// optimized at full resolution. In floating point Tutte's embedding collapses where many vertices hang on few, as
// around one with a hundred neighbors: should a stage not be mapped, optimized or extended to a map that is
// `is_valid(uv)`, all is done again from a coarser one. `optimize` returns how it ended.
template <typename Energy, typename Optimize, typename IsValid>
Stages_outcome map_by_stages(const Corner_table& chart, const std::vector<Eigen::Vector3d>& points, bool keeps_region,
                             const Solvers& linear_solvers, const Optimize& optimize, const IsValid& is_valid,
                             std::vector<Eigen::Vector2d>& uv)
{
  constexpr int least = 4; // vertices
  for(int size = coarsest_size(chart.number_of_vertices());; size = next_smaller_stage(size))
  {
    uv.assign(chart.number_of_vertices(), Eigen::Vector2d::Zero());
    Chart_hierarchy hierarchy(chart, points, keeps_region, linear_solvers.execution);
    const Stages_outcome outcome = map_by_stages<Energy>(hierarchy, size, linear_solvers, optimize, uv);
    if(outcome == Stages_outcome::STOPPED || (outcome == Stages_outcome::MAPPED && is_valid(uv)))
      return outcome;
    if(size <= least)
      return Stages_outcome::FAILED;
  }
}

// A flip-free map of low energy. Coarse stages are solved tightly: the slow modes of charts far from
// their optimum are global, and every iteration saved at full resolution pays for many there.
template <typename Energy>
Stages_outcome hierarchical_map(const Corner_table& chart, const std::vector<Eigen::Vector3d>& points,
                                const Solvers& linear_solvers, std::vector<Eigen::Vector2d>& uv,
                                const Go_further& go_further = always_go_further)
{
  const auto optimize = [&](const Chart_hierarchy::Stage& stage, std::vector<Eigen::Vector2d>& stage_uv)
  {
    Newton_options options;
    options.decrement = 1e-5;
    options.go_further = go_further;
    Newton_solver solver(stage.chart.triangles(), stage.chart.number_of_vertices(), linear_solvers);
    return solver.minimize<Energy>(stage.shapes, area_weights(stage.shapes), stage_uv, options).outcome;
  };
  const auto is_valid = [&](const std::vector<Eigen::Vector2d>& map)
  { return count_flips(chart.triangles(), map, nullptr, linear_solvers.execution) == 0; };
  return map_by_stages<Energy>(chart, points, false, linear_solvers, optimize, is_valid, uv);
}

// Makes a map with a few flipped triangles flip-free, by progressive embedding [SJZP19]: vertices
// around the flips are collapsed and put back, each where it is as conformal as possible. `points`
// holds the position of each chart vertex on the surface. False if flips remain, or would take more
// collapses; then `uv` is not valid. About linear in the size of the chart.
inline bool remove_flips(const Corner_table& chart, const std::vector<Eigen::Vector3d>& points,
                         std::vector<Eigen::Vector2d>& uv,
                         int maximum_number_of_collapses = (std::numeric_limits<int>::max)())
{
  Chart_hierarchy hierarchy(chart, points);
  return hierarchy.collapse_flips(uv, maximum_number_of_collapses) &&
         hierarchy.refine_to<MIPS_energy>(chart.number_of_vertices(), uv) &&
         count_flips(chart.triangles(), uv) == 0;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_HIERARCHICAL_MAP_H
