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

#include <CGAL/boost/graph/internal/Graph_kernel/sort_unique.h>

#include <cmath>
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

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_ANGLES_H
