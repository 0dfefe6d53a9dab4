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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_DISTANCE_FIELD_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_DISTANCE_FIELD_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/simplified_outline.h>

#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Where a point is to a chart: how far outside, negative if inside, and in which direction that grows.
struct Signed_distance
{
  double distance = std::numeric_limits<double>::infinity();
  Eigen::Vector2d direction = Eigen::Vector2d::Zero();
};

// Signed distances from an outline. A grid holds for each cell the segments that can be the closest ones to a point of
// it; distances are exact near the border and within about a cell deep inside.
class Distance_field
{
public:
  // Points farther than `reach` outside are at infinity.
  Distance_field(const std::vector<Outline_segment>& outline, double reach)
    : m_lines(outline.begin(), outline.end()), m_reach(reach)
  {
    for(const Line& line : m_lines)
      m_box.add(line.source);
    m_box.grow(reach);
    m_cell = (std::max)(m_box.longest_side() / resolution, (std::numeric_limits<double>::min)());
    m_cells_per_length = 1 / m_cell;
    m_columns = int(m_box.size().x() / m_cell) + 1;
    m_rows = int(m_box.size().y() / m_cell) + 1;
    for(int y = 0; y < m_rows; ++y)
      for(int x = 0; x < m_columns; ++x)
        add_cell(m_box.low + m_cell * Eigen::Vector2d(x + 0.5, y + 0.5));
  }

  // At infinity, too, may be what is at least `limit` outside.
  Signed_distance operator()(const Eigen::Vector2d& p, double limit = std::numeric_limits<double>::infinity()) const
  {
    const Eigen::Vector2d place = place_of(p);
    if(!is_on_grid(place))
      return Signed_distance();
    const std::size_t cell = cell_of(place);
    if(m_center_distances[cell] - 0.5 * diagonal() >= limit)
      return Signed_distance();
    return closest(p, m_begins[cell], m_begins[cell + 1], m_is_inside[cell]);
  }

  // The distance within half the diagonal of a cell of the grid, or less where points are farther than `reach`. It costs
  // a look at one cell.
  double rough_distance(const Eigen::Vector2d& p) const
  {
    const Eigen::Vector2d place = place_of(p);
    if(is_on_grid(place))
      return m_center_distances[cell_of(place)];
    const Eigen::Vector2d beyond = (-place).cwiseMax(place - Eigen::Vector2d(m_columns, m_rows)).cwiseMax(0.);
    return m_reach + m_cell * beyond.norm();
  }

  // A bound from below.
  double least_distance(const Eigen::Vector2d& p) const { return rough_distance(p) - 0.5 * diagonal(); }

private:
  Eigen::Vector2d place_of(const Eigen::Vector2d& p) const { return (p - m_box.low) * m_cells_per_length; }

  bool is_on_grid(const Eigen::Vector2d& place) const
  { return place.x() >= 0 && place.y() >= 0 && place.x() < m_columns && place.y() < m_rows; }

  std::size_t cell_of(const Eigen::Vector2d& place) const
  { return std::size_t(place.y()) * m_columns + std::size_t(place.x()); }

  double diagonal() const { return std::sqrt(2.) * m_cell; } // of a cell

  static constexpr int resolution = 48; // cells along the longer side

  void add_cell(const Eigen::Vector2d& center)
  {
    m_distances.clear();
    double least = std::numeric_limits<double>::infinity();
    int winding_number = 0;
    for(const Line& line : m_lines)
    {
      winding_number += line.winding_number(center);
      m_distances.push_back(line.offset_to(center).norm());
      least = (std::min)(least, m_distances.back());
    }
    const double limit = least + (least > 3 * diagonal() ? 1e-9 * least : diagonal());
    for(std::size_t i = 0; i < m_lines.size(); ++i)
      if(m_distances[i] <= limit)
        m_candidates.push_back(int(i));
    m_begins.push_back(int(m_candidates.size()));
    const int begin = m_begins[m_begins.size() - 2];
    m_is_inside.push_back(winding_number != 0);
    m_center_distances.push_back(m_is_inside.back() ? -least : least);
    if(least > m_reach + 0.5 * diagonal() && !m_is_inside.back()) // never reached
    {
      m_candidates.resize(std::size_t(begin));
      m_begins.back() = begin;
    }
  }

  // At a corner, the segment seen less slantwise tells the side. Where the border runs back along itself, the center of
  // the cell does: a slit and a chart without area have the same segments.
  Signed_distance closest(const Eigen::Vector2d& p, int begin, int end, bool is_inside) const
  {
    double least = std::numeric_limits<double>::infinity(), height = 0;
    Eigen::Vector2d offset = Eigen::Vector2d::Zero(), normal = offset;
    for(int i = begin; i < end; ++i)
    {
      const Line& line = m_lines[m_candidates[i]];
      const Eigen::Vector2d v = line.offset_to(p);
      const double squared = v.squaredNorm();
      if(squared > least * (1 + 1e-9))
        continue;
      const double h = line.normal.dot(p - line.source);
      const bool is_opposite = std::abs(h + height) <= 1e-9 * std::abs(height);
      if(squared < least * (1 - 1e-9) || (is_opposite ? (h < 0) == is_inside : std::abs(h) > std::abs(height)))
      {
        least = squared;
        height = h;
        offset = v;
        normal = line.normal;
      }
    }
    if(end == begin)
      return Signed_distance();
    const double distance = std::sqrt(least);
    if(!(distance > 0))
      return {0, normal};
    return height >= 0 ? Signed_distance{distance, offset / distance} : Signed_distance{-distance, -offset / distance};
  }

  // A segment, and what is asked for often.
  struct Line
  {
    Eigen::Vector2d source, direction, normal; // the last one of length 1, to the right
    double inverse_squared_length = 0;         // 0 for a point

    explicit Line(const Outline_segment& s)
      : source(s.source), direction(s.target - s.source), normal(direction.y(), -direction.x())
    {
      normal.normalize(); // keeps zero
      if(direction.squaredNorm() > 0)
        inverse_squared_length = 1 / direction.squaredNorm();
    }

    // What the segment adds to the winding number of the outline around `p`.
    int winding_number(const Eigen::Vector2d& p) const
    {
      const bool is_below = source.y() <= p.y();
      if(is_below == (source.y() + direction.y() <= p.y()))
        return 0;
      const bool is_left = normal.dot(p - source) < 0;
      return is_below && is_left ? 1 : !is_below && !is_left ? -1 : 0;
    }

    // From the closest point of the segment to `p`.
    Eigen::Vector2d offset_to(const Eigen::Vector2d& p) const
    {
      const Eigen::Vector2d q = p - source;
      return q - (std::min)(1., (std::max)(0., q.dot(direction) * inverse_squared_length)) * direction;
    }
  };

  std::vector<Line> m_lines;
  Surface_mesh_parameterization::internal::Bounding_box<2> m_box;
  double m_reach, m_cell, m_cells_per_length;
  int m_columns, m_rows;
  std::vector<int> m_begins = {0}, m_candidates; // of cells, row by row: segments
  std::vector<char> m_is_inside;                 // of the centers of cells
  std::vector<double> m_center_distances;        // of cells
  std::vector<double> m_distances;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_DISTANCE_FIELD_H
