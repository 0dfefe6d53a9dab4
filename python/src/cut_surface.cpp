// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#include "cut_surface.h"

#include "chart_vertices.h"
#include "pack.h"

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <functional>
#include <utility>

namespace binding {

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;
using SMC::internal::Corner_table;
using SMC::internal::Mesh_result;

// UVs of the vertices of a chart as those of the corners of the soup, which share them unless a cut lies between them.
Corner_map corner_map(const Soup_adapter& adapter, const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv)
{
  Corner_map map;
  std::vector<std::int64_t> numbers(chart.origins().size(), -1);
  for(const int v : chart_vertices_of_corners(adapter, chart))
  {
    if(numbers[v] < 0)
    {
      numbers[v] = std::int64_t(map.points.size());
      map.points.push_back(std::int64_t(adapter.to_vertex(chart.origins()[v])));
      map.uv.push_back(uv[v].x());
      map.uv.push_back(uv[v].y());
    }
    map.corners.push_back(numbers[v]);
  }
  return map;
}

// The map as it is, or packed.
void write_map(const Soup_adapter& adapter, const Mesh_result& found, bool do_bijective,
               const std::optional<Packing_options>& options, Run_monitor& monitor, Cut_surface& result,
               std::optional<Result_status>& packing_status)
{
  std::vector<Eigen::Vector2d> uv;
  uv.reserve(found.uv.size());
  for(const Eigen::Vector2d& p : found.uv)
    uv.push_back(SMP::internal::scaled(p, adapter.exponent()));
  if(!options)
  {
    result.number_of_charts = SMP::internal::Connected_parts(found.chart.opposites()).number;
    result.map = corner_map(adapter, found.chart, uv);
    return;
  }
  std::vector<Eigen::Vector2d> corner_uv;
  corner_uv.reserve(std::size_t(adapter.mesh().number_of_halfedges()));
  for(int h = 0; h < adapter.mesh().number_of_halfedges(); ++h)
    corner_uv.push_back(uv[found.chart.source(h)]);
  const auto wall_start = std::chrono::steady_clock::now();
  const std::clock_t cpu_start = std::clock();
  const SMC::internal::Indexed_packing packing = pack(adapter, found.chart, corner_uv, *options, do_bijective, monitor);
  result.packing_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start).count();
  result.packing_cpu_seconds = double(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  packing_status = adapter.translate(packing.status);
  if(!packing.has_result)
    return;
  result.number_of_charts = packing.number_of_charts;
  result.uv_scale = packing.scale;
  result.fill = packing.fill;
  result.page_fills = packing.page_fills;
  result.map = corner_map(adapter, found.chart, packing.uv);
}

// How packing ended counts where the run before it went well, and where it failed.
void merge(const Result_status& packing, Cut_surface& result)
{
  SMC::Unwrap_soup_result& found = result.found;
  found.has_result = !result.map.corners.empty();
  if(packing || (found.has_result && !found.status))
    return;
  static_cast<Finding&>(found.status) = packing;
  if(packing.code == Status_code::INFEASIBLE_CONSTRAINTS)
    found.status.message += "; a larger texture_size or uv_scale='surface' helps";
}

template <typename NamedParameters>
Cut_surface run(Named_surface& surface, const Cutting_options& options, const std::optional<Packing_options>& packing,
                Run_monitor& monitor, const NamedParameters& np)
{
  constexpr double share_without_packing = 0.9; // of the time, for the progress
  monitor.begin_part(0, packing ? share_without_packing : 1);
  Cut_surface result;
  std::optional<Result_status> packing_status;
  result.found = SMC::internal::run_on_adapter<Concurrency_tag, SMC::Unwrap_soup_result, Eigen::Vector2d>(
    [&](const Go_further& go_further) { return surface.read(go_further); }, options.output,
    [&](const Soup_adapter& adapter, const Mesh_result& found)
    {
      if(options.output != Output_kind::FEATURES)
        result.cut_edges = named_cut(adapter, found.cut);
      monitor.begin_part(packing ? share_without_packing : 0, 1);
      if(options.output == Output_kind::MAP)
        write_map(adapter, found, options.do_bijective, packing, monitor, result, packing_status);
    },
    np);
  result.profile = monitor.profile();
  if(packing_status)
    merge(*packing_status, result);
  return result;
}

} // namespace

std::vector<Edge> named_cut(const Soup_adapter& adapter, const SMC::internal::Cut& cut)
{
  std::vector<Edge> edges;
  for(int e = 0; e < adapter.mesh().number_of_edges(); ++e)
    if(cut[e])
      edges.push_back(adapter.to_edge(e));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end()); // a pair may stand for several edges
  return edges;
}

Cut_surface cut_surface(const Surface_arguments& arguments, const Cutting_options& options,
                        const std::optional<Packing_options>& packing, Run_monitor& monitor)
{
  Named_surface surface(arguments);
  const auto np = CGAL::parameters::visitor(std::ref(monitor))
                    .effort(options.effort)
                    .connection(options.connection)
                    .use_published_method(options.use_published_method)
                    .do_bijective(options.do_bijective)
                    .maximum_average_distortion(options.maximum_average_distortion)
                    .maximum_face_distortion(options.maximum_face_distortion)
                    .face_distortion_quantile(options.face_distortion_quantile)
                    .maximum_chart_distortion(options.maximum_chart_distortion)
                    .minimum_distortion_decrease(options.minimum_distortion_decrease)
                    .minimum_length_decrease(options.minimum_length_decrease)
                    .minimum_area_ratio(options.minimum_area_ratio)
                    .influence_threshold(options.influence_threshold)
                    .forbidden_radius(options.forbidden_radius)
                    .maximum_number_of_states(options.maximum_number_of_states)
                    .random_seed(options.random_seed)
                    .symmetry(options.symmetry)
                    .seam_smoothness(options.seam_smoothness)
                    .edge_is_constrained_map(surface.mandatory_edges())
                    .edge_is_forbidden_map(surface.forbidden_edges())
                    .initial_cut_map(surface.initial_cut())
                    .vertex_is_constrained_map(surface.terminals());
  Cut_surface result;
  try
  {
    result = arguments.has_weights
               ? run(surface, options, packing, monitor, np.edge_weight_map(surface.edge_weights()))
               : run(surface, options, packing, monitor, np);
  }
  catch(const Refusal& refusal)
  {
    static_cast<Finding&>(result.found.status) = refusal.finding;
  }
  result.found.interpreted = surface.interpreted();
  return result;
}

} // namespace binding
