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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_OUTLINE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_OUTLINE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using Surface_mesh_parameterization::internal::Connected_parts;
using Surface_mesh_parameterization::internal::Corner_table;

struct Outline_segment { Eigen::Vector2d source, target; };

// The border of a chart, the surface on the left. The origin is the middle of its bounding box.
struct Chart_outline
{
  std::vector<Outline_segment> segments;
  std::vector<Eigen::Vector2d> hull; // counterclockwise
  Eigen::Vector2d center;            // what the origin was moved to
  double area = 0;
  bool has_axis = false; // whether it is its own mirror image, left and right

  // The box around the chart turned by `angle`.
  Surface_mesh_parameterization::internal::Bounding_box<2> box(double angle) const
  {
    const double c = std::cos(angle), s = std::sin(angle);
    Surface_mesh_parameterization::internal::Bounding_box<2> box;
    for(const Eigen::Vector2d& p : hull)
      box.add(Eigen::Vector2d(c * p.x() - s * p.y(), s * p.x() + c * p.y()));
    return box;
  }

  Eigen::Vector2d extent(double angle) const { return box(angle).size(); }

  double hull_area() const
  {
    double area = 0;
    for(std::size_t i = 0; i < hull.size(); ++i)
    {
      const Eigen::Vector2d &p = hull[i], &q = hull[(i + 1) % hull.size()];
      area += 0.5 * (p.x() * q.y() - p.y() * q.x());
    }
    return area;
  }
};

inline std::vector<Eigen::Vector2d> convex_hull(const std::vector<Outline_segment>& segments)
{
  using Point_2 = Exact_predicates_inexact_constructions_kernel::Point_2;
  std::vector<Point_2> points, corners;
  for(const Outline_segment& s : segments)
    points.emplace_back(s.source.x(), s.source.y());
  convex_hull_2(points.begin(), points.end(), std::back_inserter(corners));
  std::vector<Eigen::Vector2d> hull;
  for(const Point_2& p : corners)
    hull.emplace_back(p.x(), p.y());
  return hull;
}

// The scale at which charts of such an area and perimeter, each with half of the margin around, take this much room; there has to
// be some besides the corners of the margins.
inline double scale_that_fills(double room, double area, double perimeter, double margin, std::size_t number)
{
  room -= 0.25 * margin * margin * CGAL_PI * double(number);
  const double linear = 0.25 * margin * perimeter;
  return room > 0 ? room / (linear + std::sqrt(linear * linear + area * room)) : 0; // area * scale^2 + 2 * linear * scale = room
}

// The scale at which charts and half of the margin around each fill pages without a gap. The margin around a chart has at least
// the area that it has around a disk of the same area (the inequality of Brunn and Minkowski), and around a convex chart, it has
// that of the perimeter.
inline double largest_scale_of_areas(const std::vector<Chart_outline>& outlines, double margin, int pages)
{
  constexpr double rounding = 1e-9;
  double area = 0, perimeter = 0;
  for(const Chart_outline& outline : outlines)
  {
    double hull_perimeter = 0;
    for(std::size_t i = 0; i < outline.hull.size(); ++i)
      hull_perimeter += (outline.hull[(i + 1) % outline.hull.size()] - outline.hull[i]).norm();
    const bool is_convex = outline.area > (1 - rounding) * outline.hull_area();
    area += outline.area;
    perimeter += is_convex ? hull_perimeter : 2 * std::sqrt(CGAL_PI * outline.area);
  }
  return scale_that_fills(pages * (1 - margin) * (1 - margin), area, perimeter, margin, outlines.size());
}

// One outline per part of `chart`, times `factor`. O(n log n).
inline std::vector<Chart_outline> chart_outlines(const Corner_table& chart, const Connected_parts& parts,
                                                 const std::vector<Eigen::Vector2d>& uv, double factor)
{
  std::vector<Chart_outline> outlines(parts.number);
  std::vector<Surface_mesh_parameterization::internal::Bounding_box<2> > boxes(parts.number);
  for(int h = 0; h < int(chart.opposites().size()); ++h)
    if(chart.is_border(h))
    {
      const int i = parts.part[h / 3];
      outlines[i].segments.push_back({uv[chart.source(h)] * factor, uv[chart.target(h)] * factor});
      boxes[i].add(outlines[i].segments.back().source);
    }
  for(int f = 0; f < chart.number_of_triangles(); ++f)
    outlines[parts.part[f]].area
      += Surface_mesh_parameterization::internal::triangle_area(chart.triangles()[f], uv) * factor * factor;
  for(int i = 0; i < parts.number; ++i)
  {
    Chart_outline& outline = outlines[i];
    outline.center = 0.5 * (boxes[i].low + boxes[i].high);
    for(Outline_segment& s : outline.segments)
    {
      s.source -= outline.center;
      s.target -= outline.center;
    }
    outline.hull = convex_hull(outline.segments);
  }
  return outlines;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_OUTLINE_H
