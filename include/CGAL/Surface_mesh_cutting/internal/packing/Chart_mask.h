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

#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using CGAL::internal::Graph_kernel::Buckets;

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
  Capsule(const Outline_segment& s, double radius)
    : m_low(s.source.y() <= s.target.y() ? s.source : s.target),
      m_high(s.source.y() <= s.target.y() ? s.target : s.source), m_radius(radius)
  {
    const Eigen::Vector2d d = m_high - m_low;
    const double length = d.norm();
    m_normal = length > 0 ? Eigen::Vector2d(d.y() / length, -d.x() / length) : Eigen::Vector2d(1, 0);
    m_slope = d.y() > 0 ? d.x() / d.y() : 0;
  }

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
    const double rise = side * m_radius * m_normal.y(), begin = m_low.y() + rise, end = m_high.y() + rise;
    if(y > begin && y < end)
      return side * m_low.x() + m_radius * m_normal.x() + (y - begin) * side * m_slope;
    const Eigen::Vector2d& center = y <= begin && !(begin == end && side * (m_high.x() - m_low.x()) > 0) ? m_low : m_high;
    const double height = y - center.y();
    return side * center.x() + std::sqrt((std::max)(0., m_radius * m_radius - height * height));
  }

  const Eigen::Vector2d m_low, m_high;
  const double m_radius;
  Eigen::Vector2d m_normal; // to the right
  double m_slope;           // of x over y
};

// The runs of cells, of side 1, whose centers are inside of an outline; where the surface overlaps itself, winding
// numbers tell.
inline std::vector<Cell_run> inside_runs(const std::vector<Outline_segment>& outline)
{
  std::vector<std::tuple<int, double, int> > crossings; // row, place on the line through its centers, turn
  for(const Outline_segment& s : outline)
  {
    const Eigen::Vector2d d = s.target - s.source;
    const double low = (std::min)(s.source.y(), s.target.y()), high = (std::max)(s.source.y(), s.target.y());
    for(int row = int(std::ceil(low - 0.5)); row + 0.5 < high; ++row)
      crossings.emplace_back(row, s.source.x() + (row + 0.5 - s.source.y()) / d.y() * d.x(), d.y() > 0 ? 1 : -1);
  }
  std::sort(crossings.begin(), crossings.end());
  std::vector<Cell_run> runs;
  int winding_number = 0;
  for(std::size_t i = 0; i + 1 < crossings.size(); ++i)
  {
    winding_number += std::get<2>(crossings[i]);
    const int row = std::get<0>(crossings[i]);
    const int first = int(std::ceil(std::get<1>(crossings[i]) - 0.5)), last = int(std::floor(std::get<1>(crossings[i + 1]) - 0.5));
    if(winding_number != 0 && std::get<0>(crossings[i + 1]) == row && first <= last)
      runs.push_back({row, first, last});
  }
  return runs;
}

// Sorts runs by rows, of which there are few, and joins those without a gap between.
inline std::vector<Cell_run> joined_runs(const std::vector<Cell_run>& runs, int first_row, int last_row)
{
  Buckets<Cell_run> rows(last_row - first_row + 1, [&](const auto& visit)
  {
    for(const Cell_run& run : runs)
      visit(run.row - first_row, run);
  });
  std::vector<Cell_run> result;
  result.reserve(runs.size());
  for(int row = 0; row < rows.number_of_buckets(); ++row)
  {
    const auto sorted = rows[row];
    std::sort(sorted.begin(), sorted.end(), [](const Cell_run& a, const Cell_run& b) { return a.first < b.first; });
    for(const Cell_run& run : sorted)
      if(!result.empty() && result.back().row == run.row && run.first <= result.back().last + 1)
        result.back().last = (std::max)(result.back().last, run.last);
      else
        result.push_back(run);
  }
  return result;
}

// The cells that the points at most `radius` away from the surface inside of an outline touch: sorted, disjoint runs.
// A cell that the border does not touch is inside if its center is.
inline std::vector<Cell_run> touched_cells(const std::vector<Outline_segment>& outline,
                                           const std::vector<Cell_run>& inside, double radius)
{
  std::vector<Cell_run> runs = inside;
  int first_row = (std::numeric_limits<int>::max)(), last_row = 0;
  for(const Outline_segment& s : outline)
  {
    const Capsule capsule(s, radius);
    const int begin = int(std::floor(capsule.bottom())), end = int(std::floor(capsule.top()));
    first_row = (std::min)(first_row, begin);
    last_row = (std::max)(last_row, end);
    for(int row = begin; row <= end; ++row)
    {
      const auto [left, right] = capsule.range(row, row + 1.);
      runs.push_back({row, int(std::floor(left)), int(std::floor(right))});
    }
  }
  return joined_runs(runs, first_row, last_row);
}

// A chart on a grid, turned, with its lowest and leftmost cells in row and column 0.
struct Chart_mask
{
  std::vector<Cell_run> inner; // touched by the chart, longest first
  std::vector<Cell_run> outer; // touched by what is too close to the chart; in parts outside of the box; row by row
  int width = 0, height = 0;
  double angle;           // turned by
  Eigen::Vector2d origin; // of the chart, within the grid

  // `factor`: from the outline to the grid. `margin`: which distance between charts is too close, in cells.
  Chart_mask(const Chart_outline& chart, double angle, double factor, double margin)
    : angle(angle)
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
    const std::vector<Cell_run> inside = inside_runs(turned);
    inner = touched_cells(turned, inside, tolerance);
    outer = touched_cells(turned, inside, margin + tolerance);
    std::stable_sort(inner.begin(), inner.end(),
                     [](const Cell_run& a, const Cell_run& b) { return a.length() > b.length(); });
  }

  // Turned by half a turn more, which takes cells to cells: they need not be found again.
  Chart_mask upside_down() const
  {
    Chart_mask turned = *this;
    turned.angle += CGAL_PI;
    turned.origin = Eigen::Vector2d(width, height) - origin;
    for(std::vector<Cell_run>* runs : {&turned.inner, &turned.outer})
      for(Cell_run& run : *runs)
        run = {height - 1 - run.row, width - 1 - run.last, width - 1 - run.first};
    return turned;
  }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_MASK_H
