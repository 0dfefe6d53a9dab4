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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_PACK_INDEXED_CHARTS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_PACK_INDEXED_CHARTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Chart_cover.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Chart_units.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Mirrored_parts.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Packing_certificate.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Page_tile.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/pack_outlines.h>
#include <CGAL/Surface_mesh_cutting/internal/result/certified_map.h>
#include <CGAL/Surface_mesh_cutting/internal/result/exact_certificate.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The power of two that is about the extent of the charts.
inline int extent_exponent(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv)
{
  Surface_mesh_parameterization::internal::Bounding_box<2> box;
  for(const Triangle& t : chart.triangles())
    for(const int v : t)
      box.add(uv[v]);
  return std::ilogb(box.longest_side());
}

// Moves the outlines' charts; `factor` is what the outlines were scaled by.
inline std::vector<Eigen::Vector2d> moved_charts(const Corner_table& chart, const Connected_parts& parts,
                                                 const std::vector<Chart_outline>& outlines, double factor,
                                                 const Packed_charts& packed, std::vector<Eigen::Vector2d> uv)
{
  const std::vector<int> part_of_vertex = Surface_mesh_parameterization::internal::parts_of_vertices(chart, parts);
  std::vector<Eigen::Matrix2d> turns;
  for(const Chart_motion& motion : packed.motions)
  {
    const double c = packed.scale * std::cos(motion.angle), s = packed.scale * std::sin(motion.angle);
    turns.emplace_back();
    turns.back() << c, -s, s, c;
  }
  for(std::size_t v = 0; v < uv.size(); ++v)
    if(const int i = part_of_vertex[v]; i >= 0)
      uv[v] = turns[i] * (factor * uv[v] - outlines[i].center) + packed.motions[i].translation
              + corner_of_page(packed.motions[i].page);
  return uv;
}

inline std::vector<Eigen::Vector2d> rounded(const std::vector<Eigen::Vector2d>& uv, const Round& round)
{
  std::vector<Eigen::Vector2d> held;
  for(const Eigen::Vector2d& u : uv)
    held.push_back(round(u));
  return held;
}

// Its triangles are none of the surface, and stay unnamed.
inline Indexed_status certify_cover(const Corner_table& cover, const std::vector<Eigen::Vector2d>& uv,
                                    const Packing_margin& margin, int number_of_pages)
{
  const Packing_certificate certificate(cover, uv, margin, number_of_pages);
  return certificate ? Indexed_status()
                     : Indexed_status(Status_code::NOT_CERTIFIED, certificate.status().finding.message);
}

// The packed charts as they will be held, proven; where rounding spoils them, they are repaired. A slightly smaller
// scale, which keeps the margins, rounds differently.
inline Indexed_status certify_rounded(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv,
                                      const Packing_parameters& parameters, int number_of_pages, const Round& round,
                                      Execution execution, std::vector<Eigen::Vector2d>& held)
{
  const auto status_of = [&]
  {
    const Certificate certificate = certify(chart, held, parameters.do_bijective, execution);
    return certificate ? Packing_certificate(chart, held, parameters.margin, number_of_pages).status()
                       : certificate.status();
  };
  held = rounded(uv, round);
  Indexed_status status = status_of();
  if(status || !certify(chart, uv, parameters.do_bijective, execution))
    return status;
  for(const double shrinking : {0., 0.0002, 0.0005, 0.001})
  {
    const double rest = 1 - shrinking * parameters.margin.distance();
    std::vector<Eigen::Vector2d> scaled_uv = uv;
    for(Eigen::Vector2d& u : scaled_uv)
    {
      const Eigen::Vector2d middle = corner_of_page((std::max)(page_at(u), 0)) + Eigen::Vector2d::Constant(0.5);
      u = rest * (u - middle) + middle;
    }
    held = rounded_without_flips(chart, scaled_uv, parameters.do_bijective, round);
    status = status_of();
    if(status)
      break;
  }
  return status;
}

// The area of the charts on each page.
inline std::vector<double> page_fills(const Corner_table& chart, const Connected_parts& parts, const Packed_charts& packed,
                                      const std::vector<Eigen::Vector2d>& uv)
{
  std::vector<double> fills(packed.number_of_pages(), 0.);
  for(int f = 0; f < chart.number_of_triangles(); ++f)
    fills[packed.motions[parts.part[f]].page]
      += Surface_mesh_parameterization::internal::triangle_area(chart.triangles()[f], uv);
  return fills;
}

inline std::optional<Packed_charts> packed_outlines(const std::vector<Chart_outline>& outlines,
                                                    const Packing_parameters& parameters, double wanted_scale,
                                                    Execution execution, Run_control& control)
{
  constexpr double reserve = 1.002; // for rounding, of the margin
  const double margin = reserve * parameters.margin.distance();
  if(!(wanted_scale > 0))
    return pack_outlines(outlines, margin, parameters.effort, parameters.rotation, execution, control, {parameters.most_pages});
  const int most_pages = parameters.most_pages > 0 ? parameters.most_pages : int(outlines.size());
  return pack_at_scale(outlines, margin, parameters.effort, parameters.rotation, execution, control,
                       {most_pages, wanted_scale});
}

// The same, mirrored charts as one. Their distance at a scale that is not known yet is that at a small one.
inline std::optional<Packed_charts> packed_units(const std::vector<Chart_outline>& outlines, const Mirrored_parts& mirrored,
                                                 Packing_parameters parameters, double wanted_scale, Execution execution,
                                                 Run_control& control)
{
  constexpr double reserve = 1.003, hopeful = 0.5, shrinking = 0.9, least_gap = 1e-5;
  constexpr int most_tries = 4;
  const double margin = reserve * parameters.margin.distance();
  const Chart_rotation rotation = parameters.rotation;
  if(rotation == Chart_rotation::UPRIGHT)
    parameters.rotation = Chart_rotation::NONE;
  double scale = wanted_scale > 0 ? wanted_scale
                                  : hopeful * largest_scale_of_areas(outlines, margin, parameters.most_pages);
  for(int i = 0; i < most_tries && scale > 0; ++i)
  {
    const Chart_units units(outlines, mirrored, rotation, (std::max)(margin / scale, least_gap));
    const std::optional<Packed_charts> packed = packed_outlines(units.outlines(), parameters, wanted_scale, execution, control);
    if(!packed)
      return std::nullopt;
    if(packed->scale >= scale || units.outlines().size() == outlines.size())
      return units.of_charts(*packed);
    scale = shrinking * packed->scale;
  }
  return std::nullopt;
}

// Mirrored charts side by side if there is room for that, as there is but with large margins.
inline std::optional<Packed_charts> packed_mirrored(const std::vector<Chart_outline>& outlines, const Mirrored_parts& mirrored,
                                                    Packing_parameters parameters, double wanted_scale, Execution execution,
                                                    Run_control& control)
{
  if(std::any_of(mirrored.images.begin(), mirrored.images.end(), [](int i) { return i >= 0; }))
    if(std::optional<Packed_charts> packed = packed_units(outlines, mirrored, parameters, wanted_scale, execution, control))
      return packed;
  if(parameters.rotation == Chart_rotation::UPRIGHT)
    parameters.rotation = Chart_rotation::QUARTER;
  return packed_outlines(outlines, parameters, wanted_scale, execution, control);
}

inline Indexed_status no_room(const Packing_parameters& parameters, int number_of_charts)
{
  const std::string charts = std::to_string(number_of_charts) + " charts", pages = std::to_string(parameters.most_pages);
  if(!(parameters.texels_per_unit > 0))
    return Indexed_status(Status_code::INFEASIBLE_CONSTRAINTS, "the margins around " + charts + " leave no room for them");
  return Indexed_status(Status_code::INFEASIBLE_CONSTRAINTS,
                        parameters.most_pages > 0 ? charts + " with so many texels per unit do not fit on " + pages + " pages"
                                                  : "with so many texels per unit, a chart is larger than a page");
}

CGAL_INLINE_UNLESS_SEPARATE
Indexed_packing pack_indexed_charts(const Corner_table& chart, const std::vector<Eigen::Vector2d>& corner_uv,
                                    const std::vector<int>& mirrored_vertices, const Packing_parameters& parameters,
                                    const Round& round, Execution execution, Run_control& control)
{
  Indexed_packing packing;
  const Certificate certificate = certify_corners(chart, corner_uv, false, execution);
  const bool is_folded = certificate.flips > 0 && certificate.non_finite == 0 && certificate.torn == 0;
  if(!certificate && !(parameters.allow_flips && is_folded))
    packing.status = certificate.status();
  if(!packing.status)
    return packing;
  const Connected_parts parts(chart.opposites());
  std::vector<Eigen::Vector2d> uv = vertex_uvs(chart, corner_uv);
  const int exponent = extent_exponent(chart, uv); // at the UVs' own scale, areas may be out of range
  for(Eigen::Vector2d& u : uv)
    u = Surface_mesh_parameterization::internal::scaled(u, -exponent);
  std::optional<Chart_cover> cover;
  if(is_folded)
    cover.emplace(chart, parts, uv);
  const Corner_table& outer_chart = is_folded ? cover->chart() : chart;
  const std::vector<Eigen::Vector2d>& outer_uv = is_folded ? cover->uv() : uv;
  const double area = Surface_mesh_parameterization::internal::chart_area(outer_chart.triangles(), outer_uv);
  const double factor = area > 0 ? 1 / std::sqrt(area) : 1;
  const Connected_parts outer_parts(outer_chart.opposites());
  const std::vector<Chart_outline> outlines = chart_outlines(outer_chart, outer_parts, outer_uv, factor);
  const double wanted_scale = parameters.texels_per_unit / parameters.margin.texture_size;
  const std::optional<Packed_charts> packed
    = packed_mirrored(outlines, Mirrored_parts(chart, parts, uv, mirrored_vertices), parameters,
                      std::ldexp(wanted_scale, exponent) / factor, execution, control);
  if(!packed)
    packing.status = no_room(parameters, parts.number);
  if(!packed)
    return packing;
  const std::vector<Eigen::Vector2d> outer = moved_charts(outer_chart, outer_parts, outlines, factor, *packed, outer_uv);
  if(is_folded)
  {
    packing.uv = rounded(moved_charts(chart, parts, outlines, factor, *packed, uv), round);
    packing.status = certify_cover(outer_chart, rounded(outer, round), parameters.margin, packed->number_of_pages());
  }
  else
    packing.status = certify_rounded(chart, outer, parameters, packed->number_of_pages(), round, execution, packing.uv);
  if(!packing.status)
    return packing;
  packing.has_result = true;
  control.report(Phase::PACK, 1);
  if(!control.go_further())
    packing.status = stopped_status();
  packing.scale = std::ldexp(factor * packed->scale, -exponent);
  packing.page_fills = page_fills(outer_chart, outer_parts, *packed, is_folded ? outer : packing.uv);
  packing.fill = std::accumulate(packing.page_fills.begin(), packing.page_fills.end(), 0.) / double(packing.page_fills.size());
  packing.number_of_charts = parts.number;
  return packing;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_PACK_INDEXED_CHARTS_H
