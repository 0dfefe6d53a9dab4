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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_CONTINUING_SIDES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_CONTINUING_SIDES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/soup/Least_triangulation.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Polygons.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Per polygon, of unit length, or zero. Those of a polygon and of its reverse are opposite to the last bit.
inline std::vector<Point> unit_normals(const std::vector<Point>& points, const Polygons& polygons)
{
  std::vector<Point> result;
  result.reserve(polygons.ends.size());
  for(int p = 0; p < polygons.number(); ++p)
  {
    const auto vertex = [&](int c) { return polygons.vertices[c]; };
    int c = polygons.begin(p); // the lowest vertex, then towards its lower neighbor
    for(int other = c; other < polygons.end(p); ++other)
      if(vertex(other) < vertex(c))
        c = other;
    const bool is_forward = vertex(polygons.next(p, c)) < vertex(polygons.previous(p, c));
    std::vector<Point> corners;
    for(int i = 0; i < polygons.size(p); ++i, c = is_forward ? polygons.next(p, c) : polygons.previous(p, c))
      corners.push_back(points[vertex(c)]);
    const Point sum = is_forward ? area_vector(corners) : Point(-area_vector(corners));
    const double length = sum.norm();
    result.push_back(length > 0 ? Point(sum / length) : Point(0, 0, 0));
  }
  return result;
}

// Angles around an edge at which polygons leave it.
class Turn_around_edge
{
public:
  explicit Turn_around_edge(const Point& axis) : m_axis(axis)
  {
    int least = 0;
    for(int k : {1, 2})
      if(std::abs(axis[k]) < std::abs(axis[least]))
        least = k;
    m_x = cross_product(axis, Point::Unit(least)).normalized();
    m_y = cross_product(axis, m_x).normalized();
  }

  // Of a polygon with this normal, one of whose sides leads along the axis, or back.
  double angle(const Point& normal, bool is_along) const
  {
    const Point inward = cross_product(normal, is_along ? m_axis : Point(-m_axis));
    return std::atan2(inward.dot(m_y), inward.dot(m_x));
  }

private:
  static Point cross_product(const Point& a, const Point& b)
  {
    return Surface_mesh_parameterization::internal::cross_product(a, b);
  }

  Point m_axis, m_x, m_y;
};

// A side at an edge with many.
struct Side_at_angle
{
  double angle; // from -pi to pi
  bool is_up;   // which side of the surface
  int index;
};

// Gives each side in turn to the one that continues it with the least turn, on the same side of the surface; then the same for
// those that are left, on either. `connect(i, j)` tells whether two fit together; only the nearest are tried.
// O(n log n).
template <typename Connect>
void connect_continuing_sides(const std::vector<Side_at_angle>& sides, const Connect& connect)
{
  constexpr int maximal_number_of_trials = 4;
  using Angles = std::set<std::pair<double, int> >;
  std::array<Angles, 2> open;
  for(const Side_at_angle& side : sides)
    open[side.is_up].emplace(side.angle, side.index);
  for(const bool do_agree : {true, false})
    for(const Side_at_angle& side : sides)
    {
      if(open[side.is_up].erase({side.angle, side.index}) == 0)
        continue; // connected already
      Angles& others = open[side.is_up != do_agree];
      const double opposite = side.angle > 0 ? side.angle - CGAL_PI : side.angle + CGAL_PI;
      auto after = others.lower_bound({opposite, -1}), before = after;
      const auto distance = [&](Angles::const_iterator other)
      {
        const double d = std::abs(other->first - opposite);
        return (std::min)(d, 2 * CGAL_PI - d);
      };
      bool is_connected = false;
      for(int trial = 0; trial < maximal_number_of_trials && trial < int(others.size()) && !is_connected; ++trial)
      {
        after = after == others.end() ? others.begin() : after;
        const auto previous = std::prev(before == others.begin() ? others.end() : before);
        const bool is_after = distance(after) <= distance(previous);
        const auto next = is_after ? after++ : before = previous;
        is_connected = connect(side.index, next->second);
        if(is_connected)
          others.erase(next);
      }
      if(!is_connected)
        open[side.is_up].emplace(side.angle, side.index);
    }
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_CONTINUING_SIDES_H
