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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHICAL_MAP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHICAL_MAP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Chart_hierarchy.h>
#include <CGAL/Surface_mesh_parameterization/internal/Newton_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/initial_map.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// A map from nothing: the coarsest stage of the hierarchy is mapped by Tutte's embedding, each stage
// is optimized by `optimize(stage, uv)` and handed to the next, twice as large. `uv` is near the
// optimum on return, but not optimized at full resolution. False if no stage could be mapped or
// extended without flips.
template <typename Energy, typename Optimize>
bool map_by_stages(Chart_hierarchy& hierarchy, const Optimize& optimize, std::vector<Eigen::Vector2d>& uv)
{
  constexpr int coarsest_size = 250, growth = 2;
  hierarchy.coarsen(coarsest_size);
  for(bool is_first = true; is_first || !hierarchy.is_complete(); is_first = false)
  {
    const Chart_hierarchy::Stage stage = hierarchy.stage();
    std::vector<Eigen::Vector2d> stage_uv(stage.vertices.size());
    for(std::size_t v = 0; v < stage_uv.size(); ++v)
      stage_uv[v] = uv[stage.vertices[v]];
    if(is_first && !tutte_map(stage.chart, stage.points, surface_area(stage.shapes), stage_uv))
      return false;
    optimize(stage, stage_uv);
    for(std::size_t v = 0; v < stage_uv.size(); ++v)
      uv[stage.vertices[v]] = stage_uv[v];
    if(!hierarchy.refine_to<Energy>(growth * hierarchy.number_of_vertices(), uv))
      return false;
  }
  return true;
}

// A flip-free map of low energy. Coarse stages are solved tightly: the slow modes of charts far from
// their optimum are global, and every iteration saved at full resolution pays for many there.
template <typename Energy, typename LinearSolver>
bool hierarchical_map(const Chart& chart, const std::vector<Eigen::Vector3d>& points,
                      std::vector<Eigen::Vector2d>& uv)
{
  const auto optimize = [](const Chart_hierarchy::Stage& stage, std::vector<Eigen::Vector2d>& stage_uv)
  {
    Newton_options options;
    options.decrement = 1e-5;
    Newton_solver<LinearSolver> solver(stage.chart.triangles(), stage.chart.number_of_vertices());
    solver.template minimize<Energy>(stage.shapes, area_weights(stage.shapes), stage_uv, options);
  };
  uv.assign(chart.number_of_vertices(), Eigen::Vector2d::Zero());
  Chart_hierarchy hierarchy(chart, points);
  return map_by_stages<Energy>(hierarchy, optimize, uv) && count_flips(chart.triangles(), uv) == 0;
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHICAL_MAP_H
