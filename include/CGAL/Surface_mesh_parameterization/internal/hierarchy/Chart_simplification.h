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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_CHART_SIMPLIFICATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_CHART_SIMPLIFICATION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/cross_product.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Quadric.h>

#include <Eigen/Core>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Chooses half-edge collapses that keep the shape of the surface and of its triangles: lowest
// quadric error first, ties by index. The vertices of every stage are a subset of the input's.
class Chart_simplification
{
public:
  // `points` holds the position of each chart vertex on the surface, `quadrics` what has come to each so far. Marks in
  // `is_stale` belong to the simplifications of one chart, which must not be neighbors if they run at the same time.
  // With `keeps_tips`, border vertices of a single triangle stay.
  Chart_simplification(Collapsible_chart& chart, const std::vector<Eigen::Vector3d>& points, bool keeps_tips,
                       std::vector<Quadric>& quadrics, std::vector<char>& is_stale)
    : m_chart(chart), m_points(points), m_keeps_tips(keeps_tips), m_quadrics(quadrics), m_is_stale(is_stale)
  {}

  // Collapses `number` of the given vertices, or until none can go. O(n log n).
  void reduce_by(int number, const std::vector<int>& vertices, Collapse_log& log, Execution execution)
  {
    fill_queue(vertices, execution);
    const int size = log.size() + number;
    while(log.size() < size && !m_queue.empty())
    {
      const int v = m_queue.top().second;
      m_queue.pop();
      if(m_is_stale[v]) // its neighborhood has changed since it was queued
        push(v);
      else
        collapse(v, log);
    }
  }

private:
  using Queue = std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int> >,
                                    std::greater<std::pair<double, int> > >;

  struct Neighborhood
  {
    std::vector<int> fan, ring;
    std::vector<std::pair<double, int> > candidates;
  };

  // At the start, nothing is collapsed yet.
  void fill_queue(const std::vector<int>& vertices, Execution execution)
  {
    std::vector<std::pair<double, int> > collapses(vertices.size()); // cost, vertex
    execute_blocks(execution, int(vertices.size()), [&](int begin, int end)
    {
      Neighborhood around;
      for(int i = begin; i < end; ++i)
      {
        m_is_stale[vertices[i]] = 0;
        const auto [cost, j] = best_collapse(vertices[i], around);
        collapses[i] = {cost, j < 0 ? -1 : vertices[i]};
      }
    });
    collapses.erase(std::remove_if(collapses.begin(), collapses.end(), [](const auto& c) { return c.second < 0; }),
                    collapses.end());
    m_queue = Queue(std::greater<std::pair<double, int> >(), std::move(collapses));
  }

  // The cheapest admissible collapse of `v`: its cost and the position of the target in the ring;
  // -1 if there is none. Leaves the neighborhood in `around`.
  std::pair<double, int> best_collapse(int v, Neighborhood& around) const
  {
    m_chart.fan(v, around.fan);
    m_chart.ring(v, around.fan, around.ring);
    around.candidates.clear();
    if(m_keeps_tips && around.fan.size() == 1)
      return {std::numeric_limits<double>::infinity(), -1};
    for(int j = 0; j < int(around.ring.size()); ++j)
    {
      // The small share of the squared length decides in flat regions, where all errors vanish.
      const Eigen::Vector3d& p = m_points[around.ring[j]];
      const double squared_length = (p - m_points[v]).squaredNorm();
      around.candidates.emplace_back(m_quadrics[v](p) + 1e-3 * squared_length * squared_length, j);
    }
    std::sort(around.candidates.begin(), around.candidates.end());
    for(const auto& [cost, j] : around.candidates)
      if(m_chart.can_collapse(v, around.fan, around.ring, j) && keeps_shape(v, around, j))
        return {cost, j};
    return {std::numeric_limits<double>::infinity(), -1};
  }

  // Whether no remaining triangle turns over or becomes a needle.
  bool keeps_shape(int v, const Neighborhood& around, int j) const
  {
    constexpr double smallest_cosine = 0.2; // between the normals before and after
    constexpr double good_quality = 0.15;   // enough for any triangle
    constexpr double kept_quality = 0.5;    // of a worse triangle, relative
    const Eigen::Vector3d &p = m_points[v], &q = m_points[around.ring[j]];
    const int size = int(around.ring.size());
    for(int i = 0; i < int(around.fan.size()); ++i)
    {
      const int next = (i + 1) % size;
      if(i == j || next == j)
        continue;
      const Eigen::Vector3d &a = m_points[around.ring[i]], &b = m_points[around.ring[next]];
      const Eigen::Vector3d edge = b - a;
      const Eigen::Vector3d before = cross_product(edge, p - a), after = cross_product(edge, q - a);
      if(before.dot(after) < smallest_cosine * before.norm() * after.norm())
        return false;
      if(quality(edge, q - a, after) < (std::min)(good_quality, kept_quality * quality(edge, p - a, before)))
        return false;
    }
    return true;
  }

  // Area over squared edge lengths: 1 for equilateral triangles, 0 for degenerate ones.
  static double quality(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& cross)
  {
    const double sum = a.squaredNorm() + b.squaredNorm() + (b - a).squaredNorm();
    return sum > 0 ? 3.4641016151377544 * cross.norm() / sum : 0;
  }

  void push(int v)
  {
    m_is_stale[v] = 0;
    const auto [cost, j] = best_collapse(v, m_around);
    if(j >= 0)
      m_queue.emplace(cost, v);
  }

  void collapse(int v, Collapse_log& log)
  {
    const int j = best_collapse(v, m_around).second;
    if(j < 0)
      return;
    m_quadrics[m_around.ring[j]].add(m_quadrics[v]);
    m_chart.collapse(v, m_around.fan, m_around.ring, j, log);
    for(int w : m_around.ring)
      m_is_stale[w] = 1;
  }

  Collapsible_chart& m_chart;
  const std::vector<Eigen::Vector3d>& m_points;
  bool m_keeps_tips;
  std::vector<Quadric>& m_quadrics;
  std::vector<char>& m_is_stale;
  Queue m_queue;
  Neighborhood m_around;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_CHART_SIMPLIFICATION_H
