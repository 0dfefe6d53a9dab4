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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_FLIP_COLLAPSE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_FLIP_COLLAPSE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/exact_flips.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Collapsible_chart.h>

#include <Eigen/Core>

#include <cstddef>
#include <deque>
#include <tuple>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Takes flipped triangles out of a chart by half-edge collapses of their vertices, as progressive
// embedding does [SJZP19]. Undone with each vertex in the kernel of its star, the collapses leave a
// map without flips that differs from the given one near its flips only.
class Flip_collapse
{
public:
  Flip_collapse(Collapsible_chart& chart, const std::vector<Eigen::Vector2d>& uv, Collapse_log& log)
    : m_chart(chart), m_uv(uv), m_log(log)
  {}

  // False if a triangle stays flipped, as may happen between short borders, after at most so many collapses. Each takes
  // the time of the one-rings around it.
  bool operator()(int maximum_number_of_collapses)
  {
    for(int t = 0; t < int(m_chart.triangles().size()); ++t)
      if(is_flipped(t))
        m_queue.push_back(t);
    std::size_t failures = 0;
    while(!m_queue.empty() && failures < m_queue.size() && m_log.size() < maximum_number_of_collapses)
    {
      const int t = m_queue.front();
      m_queue.pop_front();
      if(!is_flipped(t))
        continue;
      if(collapse_best(t))
      {
        failures = 0;
        continue;
      }
      ++failures;
      m_queue.push_back(t); // collapses nearby may change what is possible
    }
    return m_queue.empty();
  }

private:
  bool is_flipped(int t) const
  {
    const Triangle& v = m_chart.triangles()[t];
    return !m_chart.is_dormant(t) && !is_counterclockwise(m_uv[v[0]], m_uv[v[1]], m_uv[v[2]]);
  }

  // The collapse of a vertex of `t` that leaves fewest flips; of these, the shortest.
  bool collapse_best(int t)
  {
    // Flips gained, squared length, vertex, place in the ring.
    std::tuple<int, double, int, int> best;
    bool is_found = false;
    for(int v : m_chart.triangles()[t])
    {
      m_chart.fan(v, m_fan);
      m_chart.ring(v, m_fan, m_ring);
      int flips = 0;
      for(int h : m_fan)
        flips += is_flipped(h / 3);
      for(int j = 0; j < int(m_ring.size()); ++j)
      {
        if(!m_chart.can_collapse(v, m_fan, m_ring, j))
          continue;
        const double squared_length = (m_uv[m_ring[j]] - m_uv[v]).squaredNorm();
        const std::tuple<int, double, int, int> next(flips_after(j) - flips, squared_length, v, j);
        if(!is_found || next < best)
          best = next;
        is_found = true;
      }
    }
    if(is_found)
      collapse(std::get<2>(best), std::get<3>(best));
    return is_found;
  }

  // How many triangles of the fan are flipped once their vertex lies at the j-th neighbor.
  int flips_after(int j) const
  {
    int flips = 0;
    const int size = int(m_ring.size());
    for(int i = 0; i < int(m_fan.size()); ++i)
    {
      const int next = (i + 1) % size;
      if(i != j && next != j)
        flips += !is_counterclockwise(m_uv[m_ring[j]], m_uv[m_ring[i]], m_uv[m_ring[next]]);
    }
    return flips;
  }

  void collapse(int v, int j)
  {
    m_chart.fan(v, m_fan);
    m_chart.ring(v, m_fan, m_ring);
    m_chart.collapse(v, m_fan, m_ring, j, m_log);
    for(int h : m_fan)
      if(is_flipped(h / 3))
        m_queue.push_back(h / 3);
  }

  Collapsible_chart& m_chart;
  const std::vector<Eigen::Vector2d>& m_uv;
  Collapse_log& m_log;
  std::deque<int> m_queue;
  std::vector<int> m_fan, m_ring;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_FLIP_COLLAPSE_H
