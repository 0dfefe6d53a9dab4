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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_SEAM_MEASURES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_SEAM_MEASURES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Seam_measures.h>
#include <CGAL/Surface_mesh_cutting/internal/connection/Key_paths.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Chart_outline.h>
#include <CGAL/Surface_mesh_cutting/internal/connection/turnings_along.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Turning.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Visibility.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/dihedral_angles.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/lengths.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Execution.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The turning of a way beyond that of the smoothest one nearby, which turns in each place by the mean of the turnings around it:
// left and right cancel out, and a bend remains.
inline double excess_turning(const std::vector<double>& turnings)
{
  constexpr int reach = 2; // vertices on each side: zigzags have a period of two or three edges
  const int size = int(turnings.size());
  double excess = 0;
  for(int i = 0; i < size; ++i)
  {
    double sum = 0; // beyond the ends, ways go straight on
    for(int k = (std::max)(0, i - reach); k <= (std::min)(size - 1, i + reach); ++k)
      sum += turnings[k];
    excess += std::abs(turnings[i]) - std::abs(sum) / (2 * reach + 1);
  }
  return excess;
}

// In radians per average edge length of the surface, so that it does not depend on the fineness.
inline std::optional<double> jaggedness(const Indexed_mesh& mesh, const Cut& cut)
{
  const double length = cut_length(mesh, cut);
  if(!(length > 0))
    return std::nullopt;
  const Turning turning(mesh);
  const Key_paths ways(mesh, cut, std::vector<char>(mesh.number_of_vertices(), 0));
  double sum = 0;
  for(const Key_paths::Path& path : ways.paths())
    sum += excess_turning(turnings_along(mesh, turning, path));
  return sum * average_edge_length(mesh) / length;
}

// The mean of what edges have, by their lengths.
template <typename Value>
std::optional<double> mean_along_cut(const Indexed_mesh& mesh, const Cut& cut, Execution execution, const Value& value)
{
  std::vector<int> edges;
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    if(cut[e])
      edges.push_back(e);
  std::vector<double> values(edges.size());
  CGAL::internal::Graph_kernel::execute(execution, int(edges.size()), [&](int i) { values[i] = value(edges[i]); });
  double sum = 0;
  for(std::size_t i = 0; i < edges.size(); ++i)
    sum += mesh.length(edges[i]) * values[i];
  const double length = total_length(mesh, edges);
  return length > 0 ? std::make_optional(sum / length) : std::nullopt;
}

// Measures the map given by `uv`, one for each vertex of the chart, which has an area.
inline Seam_measures seam_measures(const Indexed_mesh& mesh, const Cut& cut, const Corner_table& chart,
                                   const std::vector<Eigen::Vector2d>& uv, Execution execution)
{
  constexpr double hard_angle = CGAL_PI / 6; // where smooth shading usually ends
  Seam_measures measures;
  measures.jaggedness = jaggedness(mesh, cut);
  const std::vector<double> angles = dihedral_angles(mesh);
  measures.on_hard_edges
    = mean_along_cut(mesh, cut, execution, [&](int e) { return std::abs(angles[e]) >= hard_angle ? 1. : 0.; });
  if(measures.jaggedness)
  {
    const Visibility visibility(mesh, View());
    measures.hidden = mean_along_cut(mesh, cut, execution, [&](int e) { return 1 - visibility(e); });
  }
  double area = 0, compactness = 0, convexity = 0;
  for(const Chart_outline& outline : chart_outlines(chart, Connected_parts(chart.opposites()), uv, 1))
  {
    const double chart_area = std::abs(outline.area), hull_area = outline.hull_area();
    double perimeter = 0;
    for(const Outline_segment& s : outline.segments)
      perimeter += (s.target - s.source).norm();
    if(!(perimeter > 0 && hull_area > 0))
      continue;
    area += chart_area;
    compactness += chart_area * 4 * CGAL_PI * chart_area / (perimeter * perimeter);
    convexity += chart_area * (std::min)(1., chart_area / hull_area);
  }
  measures.compactness = area > 0 ? compactness / area : 0;
  measures.convexity = area > 0 ? convexity / area : 0;
  return measures;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_SEAM_MEASURES_H
