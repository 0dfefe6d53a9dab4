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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_LONG_CHART_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_LONG_CHART_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/chart_angles.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Halfedge_arrays.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Divides the chart of a layout that needs the largest square, across and at a seam that is short.
//
// The faces of the chart are added one after the other, in the order of their distance from one of its ends, as long as
// paths through faces are. The seam is the border between those added and the others at the moment in the middle part of the
// chart at which it is shortest.
class Long_chart
{
public:
  // `uv`: per halfedge, of the corner to which it leads. `is_cut`: per halfedge, on both sides. References are kept.
  Long_chart(const Halfedge_arrays& mesh, const std::vector<Eigen::Vector2d>& uv, const std::vector<char>& is_cut)
    : m_mesh(mesh), m_uv(uv), m_is_cut(is_cut), m_chart(mesh.next.size(), -1)
  {
    find_charts();
  }

  // The side of the smallest square that holds any chart alone.
  double side() const { return m_side; }
  double area() const { return m_area; } // of all charts

  // The halfedges on one side of the seam; none if there is no place for it.
  std::vector<int> seam() const
  {
    const std::vector<int> ends = order_from(order_from(m_longest).back());
    const std::vector<int> order = order_from(ends.back());
    std::vector<char> is_added(m_mesh.next.size(), 0); // halfedges of faces
    double length = 0, least = std::numeric_limits<double>::infinity();
    std::size_t best = 0;
    for(std::size_t i = 0; i + 1 < order.size(); ++i)
    {
      for_each_side(order[i], [&](int h) { is_added[std::size_t(h)] = 1; });
      for_each_side(order[i], [&](int h)
      {
        if(is_joined(h))
          length += (is_added[std::size_t(m_mesh.opposite[h])] ? -1 : 1) * uv_length(h);
      });
      if(3 * i < order.size() || 3 * i > 2 * order.size() || length >= least)
        continue;
      least = length;
      best = i + 1;
    }
    std::fill(is_added.begin(), is_added.end(), 0);
    for(std::size_t i = 0; i < best; ++i)
      for_each_side(order[i], [&](int h) { is_added[std::size_t(h)] = 1; });
    return sides_between(is_added);
  }

private:
  bool is_joined(int h) const { return m_mesh.opposite[h] >= 0 && !m_is_cut[std::size_t(h)]; }
  double uv_length(int h) const { return (m_uv[h] - m_uv[m_mesh.previous[h]]).norm(); }

  template <typename Visit>
  void for_each_side(int first, Visit visit) const
  {
    int h = first;
    do
      visit(h);
    while((h = m_mesh.next[h]) != first);
  }

  Eigen::Vector2d middle(int first) const
  {
    Eigen::Vector2d sum(0, 0);
    int number = 0;
    for_each_side(first, [&](int h) { sum += m_uv[h]; ++number; });
    return sum / number;
  }

  void find_charts()
  {
    int number = 0;
    for(int first = 0; first < m_mesh.number_of_halfedges(); ++first)
    {
      if(m_mesh.next[first] < 0 || m_chart[first] >= 0)
        continue;
      Chart_outline outline;
      std::vector<int> stack(1, first);
      m_chart[first] = number;
      while(!stack.empty())
      {
        const int h = stack.back();
        stack.pop_back();
        const Eigen::Vector2d &p = m_uv[m_mesh.previous[h]], &q = m_uv[h];
        m_area += 0.5 * (p.x() * q.y() - p.y() * q.x());
        if(!is_joined(h))
          outline.segments.push_back({p, q});
        for(const int g : {m_mesh.next[h], is_joined(h) ? m_mesh.opposite[h] : -1})
          if(g >= 0 && std::exchange(m_chart[g], number) < 0)
            stack.push_back(g);
      }
      outline.hull = convex_hull(outline.segments);
      const double side = outline.extent(tightest_square_angle(outline)).maxCoeff();
      if(side > m_side)
        m_longest = first;
      m_side = (std::max)(m_side, side);
      ++number;
    }
  }

  // A halfedge of each face of a chart, by the distance from that of the first one.
  std::vector<int> order_from(int first) const
  {
    std::vector<char> is_done(m_mesh.next.size(), 0);
    std::vector<int> order;
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
    queue.push({0, first});
    while(!queue.empty())
    {
      const double distance = queue.top().first;
      const int face = queue.top().second;
      queue.pop();
      if(is_done[std::size_t(face)])
        continue;
      order.push_back(face);
      const Eigen::Vector2d center = middle(face);
      for_each_side(face, [&](int h) { is_done[std::size_t(h)] = 1; });
      for_each_side(face, [&](int h)
      {
        if(is_joined(h) && !is_done[std::size_t(m_mesh.opposite[h])])
          queue.push({distance + (middle(m_mesh.opposite[h]) - center).norm(), m_mesh.opposite[h]});
      });
    }
    return order;
  }

  // The sides between the added faces and the others of the chart. Faces that the other side encloses have no border in common
  // with the chart and go to that side: both sides are to be without holes.
  std::vector<int> sides_between(std::vector<char>& is_added) const
  {
    std::vector<char> is_met(m_mesh.next.size(), 0);
    for(const char side : {char(0), char(1)})
      for(int first = 0; first < m_mesh.number_of_halfedges(); ++first)
      {
        if(m_chart[first] != m_chart[m_longest] || is_met[first] || is_added[first] != side)
          continue;
        std::vector<int> piece, stack(1, first);
        is_met[first] = 1;
        bool is_at_border = false;
        while(!stack.empty())
        {
          const int h = stack.back();
          stack.pop_back();
          piece.push_back(h);
          is_at_border = is_at_border || !is_joined(h);
          for(const int g : {m_mesh.next[h], is_joined(h) ? m_mesh.opposite[h] : -1})
            if(g >= 0 && is_added[std::size_t(g)] == side && !std::exchange(is_met[g], char(1)))
              stack.push_back(g);
        }
        for(const int h : piece)
          if(!is_at_border)
            is_added[h] = !side;
      }
    std::vector<int> seam;
    for(int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      if(is_added[h] && is_joined(h) && !is_added[m_mesh.opposite[h]])
        seam.push_back(h);
    return seam;
  }

  const Halfedge_arrays& m_mesh;
  const std::vector<Eigen::Vector2d>& m_uv;
  const std::vector<char>& m_is_cut;
  std::vector<int> m_chart; // per halfedge of a face
  int m_longest = -1;       // a halfedge of it
  double m_side = 0, m_area = 0;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_LONG_CHART_H
