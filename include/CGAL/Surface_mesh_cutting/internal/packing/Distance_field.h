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

#include <CGAL/Surface_mesh_parameterization/internal/Bounding_box.h>

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
  Distance_field(std::vector<Outline_segment> outline, double reach)
    : m_outline(std::move(outline))
  {
    for(const Outline_segment& s : m_outline)
      m_box.add(s.source);
    m_box.grow(reach);
    m_cell = (std::max)(m_box.longest_side() / resolution, (std::numeric_limits<double>::min)());
    m_columns = int(m_box.size().x() / m_cell) + 1;
    m_rows = int(m_box.size().y() / m_cell) + 1;
    for(int y = 0; y < m_rows; ++y)
      for(int x = 0; x < m_columns; ++x)
        add_cell(m_box.low + m_cell * Eigen::Vector2d(x + 0.5, y + 0.5), reach);
  }

  Signed_distance operator()(const Eigen::Vector2d& p) const
  {
    const double x = (p.x() - m_box.low.x()) / m_cell, y = (p.y() - m_box.low.y()) / m_cell;
    if(!(x >= 0 && y >= 0 && x < m_columns && y < m_rows))
      return Signed_distance();
    const std::size_t cell = std::size_t(y) * m_columns + std::size_t(x);
    return closest(p, m_begins[cell], m_begins[cell + 1]);
  }

private:
  static constexpr int resolution = 48; // cells along the longer side

  void add_cell(const Eigen::Vector2d& center, double reach)
  {
    const double diagonal = std::sqrt(2.) * m_cell;
    m_distances.clear();
    double least = std::numeric_limits<double>::infinity();
    for(const Outline_segment& s : m_outline)
    {
      m_distances.push_back(std::sqrt(squared_distance_to_segment(center, s)));
      least = (std::min)(least, m_distances.back());
    }
    const double limit = least + (least > 3 * diagonal ? 1e-9 * least : diagonal);
    for(std::size_t i = 0; i < m_outline.size(); ++i)
      if(m_distances[i] <= limit)
        m_candidates.push_back(int(i));
    m_begins.push_back(int(m_candidates.size()));
    const int begin = m_begins[m_begins.size() - 2];
    if(least > reach + 0.5 * diagonal && closest(center, begin, m_begins.back()).distance > 0) // never reached
    {
      m_candidates.resize(std::size_t(begin));
      m_begins.back() = begin;
    }
  }

  // At a corner, the segment seen less slantwise tells the side.
  Signed_distance closest(const Eigen::Vector2d& p, int begin, int end) const
  {
    double least = std::numeric_limits<double>::infinity(), height = 0;
    Eigen::Vector2d offset = Eigen::Vector2d::Zero(), normal = offset;
    for(int i = begin; i < end; ++i)
    {
      const Outline_segment& s = m_outline[m_candidates[i]];
      const Eigen::Vector2d d = s.target - s.source, q = p - s.source;
      const double length = d.squaredNorm(), dot = q.dot(d);
      const double t = dot <= 0 ? 0 : dot >= length ? 1 : dot / length;
      const Eigen::Vector2d v = q - t * d;
      const double squared = v.squaredNorm();
      if(squared > least * (1 + 1e-9))
        continue;
      const double h = length > 0 ? (d.y() * q.x() - d.x() * q.y()) / std::sqrt(length) : 0;
      if(squared < least * (1 - 1e-9) || std::abs(h) > std::abs(height))
      {
        least = squared;
        height = h;
        offset = v;
        normal = Eigen::Vector2d(d.y(), -d.x());
      }
    }
    if(end == begin)
      return Signed_distance();
    const double distance = std::sqrt(least);
    if(!(distance > 0))
      return {0, normal.normalized()};
    return height >= 0 ? Signed_distance{distance, offset / distance} : Signed_distance{-distance, -offset / distance};
  }

  const std::vector<Outline_segment> m_outline;
  Surface_mesh_parameterization::internal::Bounding_box<2> m_box;
  double m_cell;
  int m_columns, m_rows;
  std::vector<int> m_begins = {0}, m_candidates; // of cells, row by row: segments
  std::vector<double> m_distances;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_DISTANCE_FIELD_H
