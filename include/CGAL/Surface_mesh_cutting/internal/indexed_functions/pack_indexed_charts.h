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
#include <CGAL/Surface_mesh_cutting/internal/packing/Packing_certificate.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/pack_outlines.h>
#include <CGAL/Surface_mesh_cutting/internal/result/certified_map.h>
#include <CGAL/Surface_mesh_cutting/internal/result/exact_certificate.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <algorithm>
#include <cmath>
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
      uv[v] = turns[i] * (factor * uv[v] - outlines[i].center) + packed.motions[i].translation;
  return uv;
}

// The packed charts as they will be held, proven; where rounding spoils them, they are repaired. A slightly smaller
// scale, which keeps the margins, rounds differently.
inline Indexed_status certify_rounded(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv,
                                      const Packing_parameters& parameters, const Round& round,
                                      Execution execution, std::vector<Eigen::Vector2d>& held)
{
  const auto status_of = [&]
  {
    const Certificate certificate = certify(chart, held, parameters.do_bijective, execution);
    return certificate ? Packing_certificate(chart, held, parameters.margin).status() : certificate.status();
  };
  for(const Eigen::Vector2d& u : uv)
    held.push_back(round(u));
  Indexed_status status = status_of();
  if(status || !certify(chart, uv, parameters.do_bijective, execution))
    return status;
  for(const double shrinking : {0., 0.0002, 0.0005, 0.001})
  {
    const double rest = 1 - shrinking * parameters.margin.distance();
    std::vector<Eigen::Vector2d> scaled_uv = uv;
    for(Eigen::Vector2d& u : scaled_uv)
      u = rest * (u - Eigen::Vector2d::Constant(0.5)) + Eigen::Vector2d::Constant(0.5);
    held = rounded_without_flips(chart, scaled_uv, parameters.do_bijective, round);
    status = status_of();
    if(status)
      break;
  }
  return status;
}

CGAL_INLINE_UNLESS_SEPARATE
Indexed_packing pack_indexed_charts(const Corner_table& chart, const std::vector<Eigen::Vector2d>& corner_uv,
                                    const Packing_parameters& parameters, const Round& round, Execution execution,
                                    Run_control& control)
{
  constexpr double reserve = 1.002; // for rounding, of the margin
  Indexed_packing packing;
  packing.status = certify_corners(chart, corner_uv, false, execution).status();
  if(!packing.status)
    return packing;
  const Connected_parts parts(chart.opposites());
  std::vector<Eigen::Vector2d> uv = vertex_uvs(chart, corner_uv);
  const int exponent = extent_exponent(chart, uv); // at the UVs' own scale, areas may be out of range
  for(Eigen::Vector2d& u : uv)
    u = Surface_mesh_parameterization::internal::scaled(u, -exponent);
  const double area = Surface_mesh_parameterization::internal::chart_area(chart.triangles(), uv);
  const double factor = area > 0 ? 1 / std::sqrt(area) : 1;
  const std::vector<Chart_outline> outlines = chart_outlines(chart, parts, uv, factor);
  const std::optional<Packed_charts> packed
    = pack_outlines(outlines, reserve * parameters.margin.distance(), parameters.effort,
                                    parameters.rotation, execution, control);
  if(!packed)
    packing.status = Indexed_status(Status_code::INFEASIBLE_CONSTRAINTS,
                                    "the margins around " + std::to_string(parts.number) + " charts leave no room for them");
  if(!packed)
    return packing;
  packing.status = certify_rounded(chart, moved_charts(chart, parts, outlines, factor, *packed, uv), parameters, round,
                                   execution, packing.uv);
  if(!packing.status)
    return packing;
  packing.has_result = true;
  control.report(Phase::PACK, 1);
  if(!control.go_further())
    packing.status = stopped_status();
  packing.scale = std::ldexp(factor * packed->scale, -exponent);
  packing.fill = Surface_mesh_parameterization::internal::chart_area(chart.triangles(), packing.uv);
  packing.number_of_charts = parts.number;
  return packing;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_PACK_INDEXED_CHARTS_H
