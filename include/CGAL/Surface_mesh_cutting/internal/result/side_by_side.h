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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_SIDE_BY_SIDE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_SIDE_BY_SIDE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/chart_angles.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Turns each chart about its middle so that it is aligned with the axes.
inline void align_charts(const Corner_table& chart, const Connected_parts& parts, const std::vector<int>& part_of_vertex,
                         std::vector<Eigen::Vector2d>& uv)
{
  const std::vector<Chart_outline> outlines = chart_outlines(chart, parts, uv, 1);
  std::vector<Eigen::Matrix2d> turns;
  for(const Chart_outline& outline : outlines)
    turns.push_back(Eigen::Rotation2Dd(alignment_angle(outline)).toRotationMatrix());
  for(std::size_t v = 0; v < uv.size(); ++v)
    if(const int i = part_of_vertex[v]; i >= 0)
      uv[v] = turns[i] * (uv[v] - outlines[i].center) + outlines[i].center;
}

// Moves several charts apart: rows of about the width of a square that holds all, charts in the order of their heights.
inline void move_apart(int number_of_charts, const std::vector<int>& part_of_vertex, std::vector<Eigen::Vector2d>& uv)
{
  std::vector<Surface_mesh_parameterization::internal::Bounding_box<2> > boxes(number_of_charts);
  for(std::size_t v = 0; v < uv.size(); ++v)
    if(part_of_vertex[v] >= 0)
      boxes[part_of_vertex[v]].add(uv[v]);
  std::vector<std::pair<double, int> > order; // height, downwards, and chart
  double area = 0, widest = 0;
  for(int i = 0; i < number_of_charts; ++i)
  {
    const Eigen::Vector2d size = boxes[i].size();
    area += size.x() * size.y();
    widest = (std::max)(widest, size.x());
    order.emplace_back(-size.y(), i);
  }
  std::sort(order.begin(), order.end());
  constexpr double gap_share = 0.02;  // between charts, of the side of a square of their area: visible
  constexpr double width_share = 1.2; // of rows, of that side: boxes and gaps leave some area empty
  const double side = std::sqrt(area), gap = gap_share * side, width = (std::max)(widest, width_share * side);
  Eigen::Vector2d corner(0, 0);
  double row_height = 0;
  std::vector<Eigen::Vector2d> shifts(number_of_charts);
  for(const auto& [height, i] : order)
  {
    const Eigen::Vector2d size = boxes[i].size();
    if(corner.x() > 0 && corner.x() + size.x() > width)
    {
      corner = Eigen::Vector2d(0, corner.y() + row_height + gap);
      row_height = 0;
    }
    shifts[i] = corner - boxes[i].low;
    corner.x() += size.x() + gap;
    row_height = (std::max)(row_height, size.y());
  }
  for(std::size_t v = 0; v < uv.size(); ++v)
    if(part_of_vertex[v] >= 0)
      uv[v] += shifts[part_of_vertex[v]];
}

// The charts of a map, at its scale, side by side and, where asked for, aligned with the axes.
inline std::vector<Eigen::Vector2d> side_by_side(const Corner_table& chart, std::vector<Eigen::Vector2d> uv, bool do_align)
{
  const Connected_parts parts(chart.opposites());
  const std::vector<int> part_of_vertex = Surface_mesh_parameterization::internal::parts_of_vertices(chart, parts);
  const bool is_finite = std::all_of(uv.begin(), uv.end(), [](const Eigen::Vector2d& u) { return u.allFinite(); });
  if(do_align && is_finite)
    align_charts(chart, parts, part_of_vertex, uv);
  if(parts.number > 1)
    move_apart(parts.number, part_of_vertex, uv);
  return uv;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_SIDE_BY_SIDE_H
