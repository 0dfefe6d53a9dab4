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
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Collapsible_chart.h>

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

// Squared distances to a set of planes, weighted [Garland, Heckbert 1997].
struct Quadric
{
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  double c = 0;

  void add_plane(const Eigen::Vector3d& normal, const Eigen::Vector3d& point, double weight)
  {
    const double offset = -normal.dot(point);
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        a(i, j) += weight * normal[i] * normal[j];
    b += weight * offset * normal;
    c += weight * offset * offset;
  }
  void add(const Quadric& q)
  {
    a += q.a;
    b += q.b;
    c += q.c;
  }
  double operator()(const Eigen::Vector3d& p) const
  {
    const Eigen::Vector3d product = a * p;
    return p.dot(product) + 2 * b.dot(p) + c;
  }
};

// Chooses half-edge collapses that keep the shape of the surface and of its triangles: lowest
// quadric error first, ties by index. The vertices of every stage are a subset of the input's.
class Chart_simplification
{
public:
  // `points` holds the position of each chart vertex on the surface.
  // With `keeps_tips`, border vertices of a single triangle stay.
  Chart_simplification(Collapsible_chart& chart, const std::vector<Eigen::Vector3d>& points,
                       bool keeps_tips = false)
    : m_chart(chart), m_points(points), m_keeps_tips(keeps_tips), m_quadrics(points.size()), m_is_stale(points.size(), 0)
  {
    accumulate_quadrics();
    for(int v = 0; v < int(points.size()); ++v)
      if(m_chart.is_used(v))
      {
        ++m_number_of_vertices;
        push(v);
      }
  }

  int number_of_vertices() const { return m_number_of_vertices; }

  // Collapses until at most `target` vertices are left or none can go; those with `is_kept` (empty: none) stay.
  // O(n log n).
  void reduce_to(int target, const std::vector<char>& is_kept = {})
  {
    while(m_number_of_vertices > target && !m_queue.empty())
    {
      const int v = m_queue.top().second;
      m_queue.pop();
      if(!is_kept.empty() && is_kept[v])
        continue;
      if(m_is_stale[v]) // its neighborhood has changed since it was queued
      {
        push(v);
        continue;
      }
      collapse(v);
    }
  }

private:
  void accumulate_quadrics()
  {
    for(int t = 0; t < int(m_chart.triangles().size()); ++t)
    {
      const Triangle& c = m_chart.triangles()[t];
      const Eigen::Vector3d normal = cross_product(m_points[c[1]] - m_points[c[0]], m_points[c[2]] - m_points[c[0]]);
      const double twice_area = normal.norm();
      if(!(twice_area > 0))
        continue;
      const Eigen::Vector3d unit = normal / twice_area;
      for(int k = 0; k < 3; ++k)
      {
        m_quadrics[c[k]].add_plane(unit, m_points[c[k]], twice_area);
        if(m_chart.opposites()[3 * t + k] < 0) // keeps the border where it is
        {
          const int s = c[k], e = c[(k + 1) % 3];
          const Eigen::Vector3d edge = m_points[e] - m_points[s];
          const Eigen::Vector3d wall = cross_product(edge, unit);
          const double length = wall.norm();
          if(!(length > 0))
            continue;
          m_quadrics[s].add_plane(wall / length, m_points[s], length * length);
          m_quadrics[e].add_plane(wall / length, m_points[s], length * length);
        }
      }
    }
  }

  // The cheapest admissible collapse of `v`: its cost and the position of the target in the ring;
  // -1 if there is none. Leaves the neighborhood in m_fan and m_ring.
  std::pair<double, int> best_collapse(int v)
  {
    m_chart.fan(v, m_fan);
    m_chart.ring(v, m_fan, m_ring);
    m_candidates.clear();
    if(m_keeps_tips && m_fan.size() == 1)
      return {std::numeric_limits<double>::infinity(), -1};
    for(int j = 0; j < int(m_ring.size()); ++j)
    {
      // The small share of the squared length decides in flat regions, where all errors vanish.
      const Eigen::Vector3d& p = m_points[m_ring[j]];
      const double squared_length = (p - m_points[v]).squaredNorm();
      m_candidates.emplace_back(m_quadrics[v](p) + 1e-3 * squared_length * squared_length, j);
    }
    std::sort(m_candidates.begin(), m_candidates.end());
    for(const auto& [cost, j] : m_candidates)
      if(m_chart.can_collapse(v, m_fan, m_ring, j) && keeps_shape(v, j))
        return {cost, j};
    return {std::numeric_limits<double>::infinity(), -1};
  }

  // Whether no remaining triangle turns over or becomes a needle.
  bool keeps_shape(int v, int j) const
  {
    constexpr double smallest_cosine = 0.2; // between the normals before and after
    constexpr double good_quality = 0.15;   // enough for any triangle
    constexpr double kept_quality = 0.5;    // of a worse triangle, relative
    const Eigen::Vector3d &p = m_points[v], &q = m_points[m_ring[j]];
    const int size = int(m_ring.size());
    for(int i = 0; i < int(m_fan.size()); ++i)
    {
      const int next = (i + 1) % size;
      if(i == j || next == j)
        continue;
      const Eigen::Vector3d &a = m_points[m_ring[i]], &b = m_points[m_ring[next]];
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
    const auto [cost, j] = best_collapse(v);
    if(j >= 0)
      m_queue.emplace(cost, v);
  }

  void collapse(int v)
  {
    const int j = best_collapse(v).second;
    if(j < 0)
      return;
    m_quadrics[m_ring[j]].add(m_quadrics[v]);
    m_chart.collapse(v, m_fan, m_ring, j);
    --m_number_of_vertices;
    for(int w : m_ring)
      m_is_stale[w] = 1;
  }

  Collapsible_chart& m_chart;
  const std::vector<Eigen::Vector3d>& m_points;
  bool m_keeps_tips;
  std::vector<Quadric> m_quadrics;
  std::vector<char> m_is_stale;
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int> >,
                      std::greater<std::pair<double, int> > > m_queue;
  int m_number_of_vertices = 0;
  std::vector<int> m_fan, m_ring;
  std::vector<std::pair<double, int> > m_candidates;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_CHART_SIMPLIFICATION_H
