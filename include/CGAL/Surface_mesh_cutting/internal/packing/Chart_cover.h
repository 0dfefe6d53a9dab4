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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_COVER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_COVER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/Chart_outline.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Triangles none of which is clockwise, and which cover charts that may be so: those of a chart, turned around where it is
// mirrored as a whole; and the convex hull of a chart that is folded. The parts have the same numbers.
class Chart_cover
{
public:
  Chart_cover(const Corner_table& chart, const Connected_parts& parts, const std::vector<Eigen::Vector2d>& uv)
    : m_uv(uv)
  {
    std::vector<std::vector<int> > triangles(parts.number);
    for(int f = 0; f < chart.number_of_triangles(); ++f)
      triangles[parts.part[f]].push_back(f);
    std::vector<Triangle> covering;
    std::vector<int> opposites, place(chart.number_of_triangles(), -1);
    for(const std::vector<int>& part : triangles)
    {
      const std::array<bool, 2> has = sides_of(chart, part);
      if(has[0] == has[1])
        add_hull(chart, part, covering, opposites);
      else
        for(const int f : part)
        {
          place[f] = int(covering.size());
          const Triangle& t = chart.triangles()[f];
          covering.push_back(has[0] ? t : Triangle{{t[0], t[2], t[1]}});
          opposites.insert(opposites.end(), 3, -1);
          for(int k = 0; k < 3; ++k) // turned around, the edges come in the opposite order
            if(const int o = chart.opposite(3 * f + k); o >= 0 && place[o / 3] >= 0)
            {
              const int g = 3 * place[f] + (has[0] ? k : 2 - k), h = 3 * place[o / 3] + (has[0] ? o % 3 : 2 - o % 3);
              opposites[g] = h;
              opposites[h] = g;
            }
        }
    }
    m_chart = Corner_table(std::move(covering), std::move(opposites), int(m_uv.size()));
  }

  const Corner_table& chart() const { return m_chart; }
  const std::vector<Eigen::Vector2d>& uv() const { return m_uv; } // those of the chart, and of corners of hulls

private:
  using Triangle = Surface_mesh_parameterization::internal::Triangle;

  // Whether there are triangles that are counterclockwise, and clockwise ones.
  std::array<bool, 2> sides_of(const Corner_table& chart, const std::vector<int>& part) const
  {
    using Point_2 = Exact_predicates_inexact_constructions_kernel::Point_2;
    const auto point = [&](int v) { return Point_2(m_uv[v].x(), m_uv[v].y()); };
    std::array<bool, 2> has = {{false, false}};
    for(const int f : part)
    {
      const Triangle& t = chart.triangles()[f];
      const Orientation side = orientation(point(t[0]), point(t[1]), point(t[2]));
      if(side != COLLINEAR)
        has[side == LEFT_TURN ? 0 : 1] = true;
    }
    return has;
  }

  // Without area, the hull is a small box.
  void add_hull(const Corner_table& chart, const std::vector<int>& part, std::vector<Triangle>& covering,
                std::vector<int>& opposites)
  {
    constexpr double thickness = 1e-6; // of the scaled UVs, whose extent is about 1
    std::vector<Outline_segment> points;
    Surface_mesh_parameterization::internal::Bounding_box<2> box;
    for(const int f : part)
      for(const int v : chart.triangles()[f])
      {
        points.push_back({m_uv[v], m_uv[v]});
        box.add(m_uv[v]);
      }
    std::vector<Eigen::Vector2d> hull = convex_hull(points);
    if(hull.size() < 3)
    {
      box.grow(thickness);
      hull = {box.low, {box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()}};
    }
    const int first = int(m_uv.size()), number = int(hull.size());
    m_uv.insert(m_uv.end(), hull.begin(), hull.end());
    for(int k = 1; k + 1 < number; ++k)
    {
      const int h = int(opposites.size());
      covering.push_back({{first, first + k, first + k + 1}});
      opposites.insert(opposites.end(), 3, -1);
      if(k > 1) // a fan
      {
        opposites[h] = h - 1;
        opposites[h - 1] = h;
      }
    }
  }

  std::vector<Eigen::Vector2d> m_uv;
  Corner_table m_chart;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_COVER_H
