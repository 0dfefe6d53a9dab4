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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_ANGLES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_ANGLES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/Chart_outline.h>

#include <CGAL/number_utils.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <cmath>
#include <complex>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The turns that make an edge of the convex hull horizontal or vertical, from 0 to a quarter turn, sorted.
inline std::vector<double> hull_angles(const Chart_outline& outline)
{
  const double quarter = CGAL_PI / 2;
  std::vector<double> angles(1, 0.);
  for(std::size_t i = 0; i < outline.hull.size(); ++i)
  {
    const Eigen::Vector2d edge = outline.hull[(i + 1) % outline.hull.size()] - outline.hull[i];
    const double angle = std::fmod(2 * CGAL_PI - std::atan2(edge.y(), edge.x()), quarter);
    angles.push_back(angle);
  }
  CGAL::internal::Graph_kernel::sort_unique(angles);
  return angles;
}

template <typename Cost>
double cheapest_angle(const std::vector<double>& angles, Cost cost)
{
  double best = 0, least = std::numeric_limits<double>::infinity();
  for(const double angle : angles)
    if(cost(angle) < least * (1 - 1e-12)) // a turn has to be worth it
    {
      least = cost(angle);
      best = angle;
    }
  return best;
}

// The turn after which the bounding box is smallest: one of its sides then lies on an edge of the hull.
inline double smallest_box_angle(const Chart_outline& outline)
{
  return cheapest_angle(hull_angles(outline), [&](double angle) { return outline.extent(angle).prod(); });
}

// The turn after which the smallest square around the chart is smallest. Between two turns of `hull_angles()`, width
// and height are concave, so that their maximum is least at one of both or where they are equal.
inline double tightest_square_angle(const Chart_outline& outline)
{
  std::vector<double> angles = hull_angles(outline);
  const auto excess = [&](double angle)
  {
    const Eigen::Vector2d size = outline.extent(angle);
    return size.x() - size.y();
  };
  const std::size_t number = angles.size();
  for(std::size_t i = 0; i < number; ++i)
  {
    double low = angles[i], high = i + 1 < number ? angles[i + 1] : CGAL_PI / 2;
    const bool is_low_wide = excess(low) > 0;
    if(is_low_wide == (excess(high) > 0))
      continue;
    constexpr int bits = 50;
    for(int step = 0; step < bits; ++step)
    {
      const double middle = 0.5 * (low + high);
      (is_low_wide == (excess(middle) > 0) ? low : high) = middle;
    }
    angles.push_back(low);
  }
  return cheapest_angle(angles, [&](double angle) { return outline.extent(angle).maxCoeff(); });
}

// The mean of the directions of a chart's border, each taken as an angle times four, by which those at right angles are
// alike: of length 1 if all segments are parallel or at right angles, and near 0 on round and on jagged charts.
inline std::complex<double> mean_direction(const Chart_outline& outline)
{
  std::complex<double> sum = 0;
  double length = 0;
  for(const Outline_segment& s : outline.segments)
  {
    const std::complex<double> along(s.target.x() - s.source.x(), s.target.y() - s.source.y());
    const double part = std::abs(along);
    if(!(part > 0))
      continue;
    const std::complex<double> direction = along / part, doubled = direction * direction;
    sum += part * doubled * doubled;
    length += part;
  }
  return length > 0 ? sum / length : 0;
}

// The turn of at most an eighth either way after which the chart is aligned with the axes: its border runs along them as
// far as it can or, where no direction stands out, the smallest box around it does. A chart that has an axis stands upright.
inline double alignment_angle(const Chart_outline& outline)
{
  if(outline.has_axis)
    return 0;
  constexpr double clear = 0.5;
  const std::complex<double> direction = mean_direction(outline);
  if(std::abs(direction) > clear)
    return -std::arg(direction) / 4;
  const double angle = smallest_box_angle(outline);
  return angle > CGAL_PI / 4 ? angle - CGAL_PI / 2 : angle;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_ANGLES_H
