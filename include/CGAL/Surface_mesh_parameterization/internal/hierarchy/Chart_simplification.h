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

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Collapsible_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <Eigen/Core>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

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

// Adds what a triangle says about a corner of it: its plane, and upright planes on its border edges, which keep the
// border where it is.
inline void add_planes(const Collapsible_chart& chart, const std::vector<Eigen::Vector3d>& points, int t, int v,
                       Quadric& quadric)
{
  const Triangle& c = chart.triangles()[t];
  const Eigen::Vector3d normal = cross_product(points[c[1]] - points[c[0]], points[c[2]] - points[c[0]]);
  const double twice_area = normal.norm();
  if(!(twice_area > 0))
    return;
  const Eigen::Vector3d unit = normal / twice_area;
  for(int k = 0; k < 3; ++k)
  {
    const int s = c[k], e = c[(k + 1) % 3];
    if(s == v)
      quadric.add_plane(unit, points[v], twice_area);
    if((s != v && e != v) || chart.opposites()[3 * t + k] >= 0)
      continue;
    const Eigen::Vector3d edge = points[e] - points[s];
    const Eigen::Vector3d wall = cross_product(edge, unit);
    const double length = wall.norm();
    if(length > 0)
      quadric.add_plane(wall / length, points[s], length * length);
  }
}

// The quadrics of all vertices. Sums have the order of the triangles, whatever the number of threads.
inline std::vector<Quadric> vertex_quadrics(const Collapsible_chart& chart, const std::vector<Eigen::Vector3d>& points,
                                            Execution execution)
{
  std::vector<Quadric> quadrics(points.size());
  execute_blocks(execution, int(points.size()), [&](int begin, int end)
  {
    std::vector<int> fan;
    for(int v = begin; v < end; ++v)
    {
      if(!chart.is_used(v))
        continue;
      chart.fan(v, fan);
      std::sort(fan.begin(), fan.end());
      for(int h : fan)
        add_planes(chart, points, h / 3, v, quadrics[v]);
    }
  });
  return quadrics;
}

// Chooses half-edge collapses that keep the shape of the surface and of its triangles: lowest
// quadric error first, ties by index. The vertices of every stage are a subset of the input's.
class Chart_simplification
{
public:
  // `points` holds the position of each chart vertex on the surface, `quadrics` the error quadrics accumulated so far. Marks
  // in `is_stale` belong to the simplifications of one chart, which must not be neighbors if they run at the same time.
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
      const Candidate c = m_queue.top();
      m_queue.pop();
      if(m_is_stale[c.vertex] || !collapse(c, log)) // what is around it has changed since it was queued
        push(c.vertex);
    }
  }

private:
  // The cheapest admissible collapse of a vertex; the target is -1 if there is none.
  struct Candidate
  {
    double cost;
    int vertex, target;

    bool operator>(const Candidate& other) const
    { return cost != other.cost ? cost > other.cost : vertex > other.vertex; }
  };

  using Queue = std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate> >;

  struct Neighborhood
  {
    std::vector<int> fan, ring;
    std::vector<std::pair<double, int> > costs; // of collapses, with positions in the ring
  };

  // At the start, nothing is collapsed yet.
  void fill_queue(const std::vector<int>& vertices, Execution execution)
  {
    std::vector<Candidate> candidates(vertices.size());
    execute_blocks(execution, int(vertices.size()), [&](int begin, int end)
    {
      Neighborhood around;
      for(int i = begin; i < end; ++i)
      {
        m_is_stale[vertices[i]] = 0;
        candidates[i] = best_collapse(vertices[i], around);
      }
    });
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(), [](const Candidate& c) { return c.target < 0; }),
                     candidates.end());
    m_queue = Queue(std::greater<Candidate>(), std::move(candidates));
  }

  void find_neighborhood(int v, Neighborhood& around) const
  {
    m_chart.fan(v, around.fan);
    m_chart.ring(v, around.fan, around.ring);
  }

  Candidate best_collapse(int v, Neighborhood& around) const
  {
    find_neighborhood(v, around);
    around.costs.clear();
    const Candidate none{std::numeric_limits<double>::infinity(), v, -1};
    if((m_keeps_tips && around.fan.size() == 1) || around.ring.size() > Collapsible_chart::many_neighbors)
      return none;
    for(int j = 0; j < int(around.ring.size()); ++j)
    {
      // The small share of the squared length decides in flat regions, where all errors vanish.
      const Eigen::Vector3d& p = m_points[around.ring[j]];
      const double squared_length = (p - m_points[v]).squaredNorm();
      around.costs.emplace_back(m_quadrics[v](p) + 1e-3 * squared_length * squared_length, j);
    }
    std::sort(around.costs.begin(), around.costs.end());
    for(const auto& [cost, j] : around.costs)
      if(keeps_shape(v, around, j) && m_chart.can_collapse(v, around.fan, around.ring, j))
        return {cost, v, around.ring[j]};
    return none;
  }

  // Whether no remaining triangle turns over, or becomes a needle, or a far worse one.
  bool keeps_shape(int v, const Neighborhood& around, int j) const
  {
    constexpr double good_quality = 0.15; // enough for any triangle
    constexpr double kept_quality = 0.5;  // of a worse one, relative: among needles, nothing could go otherwise
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
      if(before.dot(after) < 0)
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
    const Candidate c = best_collapse(v, m_around);
    if(c.target >= 0)
      m_queue.push(c);
  }

  // False if the surroundings of the target do not allow it any more. Those of the vertex must not have changed.
  bool collapse(const Candidate& c, Collapse_log& log)
  {
    find_neighborhood(c.vertex, m_around);
    const std::vector<int>&fan = m_around.fan, &ring = m_around.ring;
    const int j = int(std::find(ring.begin(), ring.end(), c.target) - ring.begin());
    if(!m_chart.can_collapse(c.vertex, fan, ring, j))
      return false;
    m_quadrics[c.target].add(m_quadrics[c.vertex]);
    m_chart.collapse(c.vertex, fan, ring, j, log);
    for(int w : ring)
      m_is_stale[w] = 1;
    return true;
  }

  Collapsible_chart& m_chart;
  const std::vector<Eigen::Vector3d>& m_points;
  bool m_keeps_tips;
  std::vector<Quadric>& m_quadrics;
  std::vector<char>& m_is_stale;
  Queue m_queue;
  Neighborhood m_around;
};

// Divides the vertices of a large chart into regions of neighbors, about equally large: boxes are halved across their
// longest side. Changes of the inner vertices of a region, all of whose triangles are in it, do not touch the
// others, so that threads work on regions at the same time. A small chart is not divided.
class Chart_regions
{
public:
  // Divides the chart as far as it is not collapsed. `points`: of all its vertices.
  Chart_regions(const Collapsible_chart& chart, const std::vector<Eigen::Vector3d>& points, Execution execution)
  {
    // With what belongs to so many vertices, a core's own cache is not full. Smaller regions have too many at their edges.
    constexpr int largest = 4096;
    std::vector<int> vertices = chart.vertices_in_use();
    if(int(vertices.size()) <= largest)
      return;
    m_starts = {0, int(vertices.size())};
    while(m_starts[1] > largest)
      halve(points, execution, vertices);
    keep_inner(chart, execution, vertices, int(points.size()));
  }

  int size() const { return int(m_inner.size()); }

  // The number of vertices of a region, and those of them that are inner ones, in ascending order.
  int number_of_vertices(int r) const { return m_starts[r + 1] - m_starts[r]; }
  const std::vector<int>& inner_vertices(int r) const { return m_inner[r]; }

private:
  // Ties by index: the same regions everywhere.
  void halve(const std::vector<Eigen::Vector3d>& points, Execution execution, std::vector<int>& vertices)
  {
    const int number = int(m_starts.size()) - 1;
    std::vector<int> starts(2 * number + 1);
    execute(execution, number, [&](int r)
    {
      const auto begin = vertices.begin() + m_starts[r], end = vertices.begin() + m_starts[r + 1];
      const auto middle = begin + (end - begin) / 2;
      Bounding_box<3> box;
      for(auto v = begin; v != end; ++v)
        box.add(points[*v]);
      int axis;
      box.size().maxCoeff(&axis);
      std::nth_element(begin, middle, end, [&](int v, int w)
                       { return points[v][axis] != points[w][axis] ? points[v][axis] < points[w][axis] : v < w; });
      starts[2 * r + 1] = int(middle - vertices.begin());
      starts[2 * r + 2] = m_starts[r + 1];
    });
    m_starts = std::move(starts);
  }

  void keep_inner(const Collapsible_chart& chart, Execution execution, const std::vector<int>& vertices,
                  int number_of_all_vertices)
  {
    const int number = int(m_starts.size()) - 1;
    std::vector<int> region(number_of_all_vertices, -1);
    for(int r = 0; r < number; ++r)
      for(int i = m_starts[r]; i < m_starts[r + 1]; ++i)
        region[vertices[i]] = r;
    std::vector<char> is_inner(number_of_all_vertices, 1);
    for(int f = 0; f < int(chart.triangles().size()); ++f)
    {
      const Triangle& t = chart.triangles()[f];
      if(!chart.is_dormant(f) && (region[t[0]] != region[t[1]] || region[t[0]] != region[t[2]]))
        for(int v : t)
          is_inner[v] = 0;
    }
    m_inner.resize(number);
    execute(execution, number, [&](int r)
    {
      for(int i = m_starts[r]; i < m_starts[r + 1]; ++i)
        if(is_inner[vertices[i]])
          m_inner[r].push_back(vertices[i]);
      std::sort(m_inner[r].begin(), m_inner[r].end());
    });
  }

  std::vector<int> m_starts{0};
  std::vector<std::vector<int> > m_inner;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_CHART_SIMPLIFICATION_H
