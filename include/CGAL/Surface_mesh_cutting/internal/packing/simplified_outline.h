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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_SIMPLIFIED_OUTLINE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_SIMPLIFIED_OUTLINE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/Chart_outline.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

inline double squared_distance_to_segment(const Eigen::Vector2d& p, const Outline_segment& segment)
{
  const Eigen::Vector2d d = segment.target - segment.source;
  const double length = d.squaredNorm();
  const double t = length > 0 ? (std::min)(1., (std::max)(0., (p - segment.source).dot(d) / length)) : 0;
  return (p - segment.source - t * d).squaredNorm();
}

// The segments one after the other; where several start at a point, any of them continues.
inline std::vector<std::vector<Eigen::Vector2d> > outline_loops(const std::vector<Outline_segment>& segments)
{
  const auto is_less = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q)
  { return p.x() < q.x() || (p.x() == q.x() && p.y() < q.y()); };
  std::vector<Outline_segment> sorted = segments;
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Outline_segment& a, const Outline_segment& b)
                   { return is_less(a.source, b.source); });
  std::vector<char> is_used(sorted.size(), false);
  std::vector<std::vector<Eigen::Vector2d> > loops;
  for(std::size_t first = 0; first < sorted.size(); ++first)
  {
    if(is_used[first])
      continue;
    loops.emplace_back();
    for(std::size_t i = first; i < sorted.size();)
    {
      is_used[i] = true;
      loops.back().push_back(sorted[i].source);
      const Eigen::Vector2d& next = sorted[i].target;
      const auto place = std::lower_bound(sorted.begin(), sorted.end(), next,
                                          [&](const Outline_segment& s, const Eigen::Vector2d& p)
                                          { return is_less(s.source, p); });
      i = std::size_t(place - sorted.begin());
      while(i < sorted.size() && sorted[i].source == next && is_used[i])
        ++i;
      if(i < sorted.size() && sorted[i].source != next)
        break;
    }
  }
  return loops;
}

// Few segments, from which no point of the outline is farther than `tolerance` (Douglas and Peucker).
inline std::vector<Outline_segment> simplified_outline(const std::vector<Outline_segment>& segments, double tolerance)
{
  std::vector<Outline_segment> simplified;
  for(std::vector<Eigen::Vector2d>& loop : outline_loops(segments))
  {
    loop.push_back(loop.front());
    const auto farthest = std::max_element(loop.begin(), loop.end(),
                                           [&](const Eigen::Vector2d& p, const Eigen::Vector2d& q)
                                           { return (p - loop[0]).squaredNorm() < (q - loop[0]).squaredNorm(); });
    const std::size_t middle = std::size_t(farthest - loop.begin());
    std::vector<std::pair<std::size_t, std::size_t> > pieces = {{middle, loop.size() - 1}, {0, middle}};
    while(!pieces.empty())
    {
      const auto [begin, end] = pieces.back();
      pieces.pop_back();
      if(begin == end)
        continue;
      const Outline_segment chord = {loop[begin], loop[end]};
      std::size_t worst = begin;
      double most = tolerance * tolerance;
      for(std::size_t i = begin + 1; i < end; ++i)
        if(const double distance = squared_distance_to_segment(loop[i], chord); distance > most)
        {
          most = distance;
          worst = i;
        }
      if(worst == begin)
        simplified.push_back(chord);
      else
      {
        pieces.emplace_back(worst, end);
        pieces.emplace_back(begin, worst);
      }
    }
  }
  return simplified;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_SIMPLIFIED_OUTLINE_H
