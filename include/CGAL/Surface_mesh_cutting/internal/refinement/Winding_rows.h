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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_WINDING_ROWS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_WINDING_ROWS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/mapping/winding_of_segment.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Buckets.h>

#include <Eigen/Core>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using CGAL::internal::Graph_kernel::Buckets;

// How often closed polygons wind around points. Around the borders of a flip-free map, that is the number of layers that lie
// there. Segments are kept in rows, so that a query looks at few of them. Not exact near the segments.
class Winding_rows
{
public:
  struct Segment
  {
    Eigen::Vector2d source, target;

    double low() const { return (std::min)(source.y(), target.y()); }
    double high() const { return (std::max)(source.y(), target.y()); }
  };

  // The segments of closed polygons, in any order.
  explicit Winding_rows(std::vector<Segment> segments)
    : m_segments(std::move(segments)), m_number_of_rows(int(m_segments.size()) + 1)
  {
    double high = -std::numeric_limits<double>::infinity();
    for(const Segment& s : m_segments)
    {
      m_low = (std::min)(m_low, s.low());
      high = (std::max)(high, s.high());
    }
    m_rows_per_unit = high > m_low ? m_number_of_rows / (high - m_low) : 0;
    m_rows = Buckets<int>(m_number_of_rows, [&](const auto& visit)
    {
      for(int i = 0; i < int(m_segments.size()); ++i)
        for(int row = row_of(m_segments[i].low()); row <= row_of(m_segments[i].high()); ++row)
          visit(row, i);
    });
  }

  int operator()(const Eigen::Vector2d& p) const
  {
    int winding = 0;
    for(int i : m_rows[row_of(p.y())])
      winding += winding_of_segment(m_segments[i].source, m_segments[i].target, p);
    return winding;
  }

private:
  int row_of(double y) const
  {
    return int((std::min)((std::max)(0., (y - m_low) * m_rows_per_unit), double(m_number_of_rows - 1)));
  }

  std::vector<Segment> m_segments;
  int m_number_of_rows;
  double m_low = std::numeric_limits<double>::infinity(), m_rows_per_unit = 0;
  Buckets<int> m_rows; // of segments
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_WINDING_ROWS_H
