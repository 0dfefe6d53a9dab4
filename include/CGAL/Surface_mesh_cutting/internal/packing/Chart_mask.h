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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_MASK_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_MASK_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/Chart_outline.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Cells next to each other, both ends included.
struct Cell_run
{
  int row, first, last;

  int length() const { return last - first + 1; }
};

// All points at most `radius` away from a segment.
class Capsule
{
public:
  Capsule(const Eigen::Vector2d& p, const Eigen::Vector2d& q, double radius)
    : m_low(p.y() <= q.y() ? p : q), m_high(p.y() <= q.y() ? q : p), m_radius(radius)
  {}

  double bottom() const { return m_low.y() - m_radius; }
  double top() const { return m_high.y() + m_radius; }

  // What x ranges over where y is between two numbers. Left and right border are concave: each is extreme where y
  // comes closest to the height of the end farther out.
  std::pair<double, double> range(double low, double high) const
  {
    low = (std::max)(low, bottom());
    high = (std::min)(high, top());
    const auto clamped = [=](const Eigen::Vector2d& end) { return (std::min)((std::max)(end.y(), low), high); };
    const bool leans_right = m_high.x() >= m_low.x();
    return {-right(clamped(leans_right ? m_low : m_high), -1), right(clamped(leans_right ? m_high : m_low), 1)};
  }

private:
  // The right border at `y`, that of the mirror image for side -1.
  double right(double y, double side) const
  {
    const Eigen::Vector2d p(side * m_low.x(), m_low.y()), d(side * (m_high.x() - m_low.x()), m_high.y() - m_low.y());
    const double length = d.norm();
    const Eigen::Vector2d normal = length > 0 ? Eigen::Vector2d(d.y() / length, -d.x() / length) : Eigen::Vector2d(1, 0);
    const double begin = p.y() + m_radius * normal.y(), end = begin + d.y();
    if(y > begin && y < end)
      return p.x() + m_radius * normal.x() + (y - begin) / d.y() * d.x();
    const Eigen::Vector2d center = y <= begin && !(begin == end && d.x() > 0) ? p : Eigen::Vector2d(p + d);
    const double height = y - center.y();
    return center.x() + std::sqrt((std::max)(0., m_radius * m_radius - height * height));
  }

  const Eigen::Vector2d m_low, m_high;
  const double m_radius;
};

// The cells of a grid, of side 1, that the points at most `radius` away from the surface inside of an outline touch:
// sorted, disjoint runs. A cell that the border does not touch is inside if its center is; where the surface overlaps
// itself, winding numbers tell.
inline std::vector<Cell_run> touched_cells(const std::vector<Outline_segment>& outline, double radius)
{
  std::vector<Cell_run> runs;
  std::vector<std::tuple<int, double, int> > crossings; // row, place on the line through its centers, turn
  for(const Outline_segment& s : outline)
  {
    const Capsule capsule(s.source, s.target, radius);
    for(int row = int(std::floor(capsule.bottom())), end = int(std::floor(capsule.top())); row <= end; ++row)
    {
      const auto [left, right] = capsule.range(row, row + 1.);
      runs.push_back({row, int(std::floor(left)), int(std::floor(right))});
    }
    const Eigen::Vector2d d = s.target - s.source;
    const int turn = d.y() > 0 ? 1 : -1;
    const double low = (std::min)(s.source.y(), s.target.y()), high = (std::max)(s.source.y(), s.target.y());
    for(int row = int(std::ceil(low - 0.5)); row + 0.5 < high; ++row)
      crossings.emplace_back(row, s.source.x() + (row + 0.5 - s.source.y()) / d.y() * d.x(), turn);
  }
  std::sort(crossings.begin(), crossings.end());
  int winding_number = 0;
  for(std::size_t i = 0; i + 1 < crossings.size(); ++i)
  {
    winding_number += std::get<2>(crossings[i]);
    const int row = std::get<0>(crossings[i]);
    const int first = int(std::ceil(std::get<1>(crossings[i]) - 0.5)), last = int(std::floor(std::get<1>(crossings[i + 1]) - 0.5));
    if(winding_number != 0 && std::get<0>(crossings[i + 1]) == row && first <= last)
      runs.push_back({row, first, last});
  }
  std::sort(runs.begin(), runs.end(), [](const Cell_run& a, const Cell_run& b)
            { return std::tie(a.row, a.first, a.last) < std::tie(b.row, b.first, b.last); });
  std::size_t number = 0;
  for(const Cell_run& run : runs)
    if(number > 0 && runs[number - 1].row == run.row && run.first <= runs[number - 1].last + 1)
      runs[number - 1].last = (std::max)(runs[number - 1].last, run.last);
    else
      runs[number++] = run;
  runs.resize(number);
  return runs;
}

// A chart on a grid, turned, with its lowest and leftmost cells in row and column 0.
struct Chart_mask
{
  std::vector<Cell_run> inner; // touched by the chart, longest first
  std::vector<Cell_run> outer; // touched by what is too close to the chart; in parts outside of the box
  int width = 0, height = 0;
  Eigen::Vector2d origin; // of the chart, within the grid

  // `factor`: from the outline to the grid. `margin`: which distance between charts is too close, in cells.
  Chart_mask(const Chart_outline& chart, double angle, double factor, double margin)
  {
    constexpr double tolerance = 1e-3; // of a cell: more than coordinates of type `float` are rounded by
    const double c = factor * std::cos(angle), s = factor * std::sin(angle);
    std::vector<Outline_segment> turned;
    turned.reserve(chart.segments.size());
    const auto turn = [=](const Eigen::Vector2d& p) { return Eigen::Vector2d(c * p.x() - s * p.y(), s * p.x() + c * p.y()); };
    Surface_mesh_parameterization::internal::Bounding_box<2> box;
    for(const Outline_segment& segment : chart.segments)
    {
      turned.push_back({turn(segment.source), turn(segment.target)});
      box.add(turned.back().source);
    }
    origin = Eigen::Vector2d::Constant(2 * tolerance) - box.low;
    for(Outline_segment& segment : turned)
    {
      segment.source += origin;
      segment.target += origin;
    }
    width = int(std::floor(box.size().x() + 3 * tolerance)) + 1;
    height = int(std::floor(box.size().y() + 3 * tolerance)) + 1;
    inner = touched_cells(turned, tolerance);
    outer = touched_cells(turned, margin + tolerance);
    std::stable_sort(inner.begin(), inner.end(),
                     [](const Cell_run& a, const Cell_run& b) { return a.length() > b.length(); });
  }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_MASK_H
