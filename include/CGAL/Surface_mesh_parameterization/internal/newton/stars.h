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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_STARS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_STARS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// One triangle of a vertex star: the edge across from the vertex and the shape on the surface, its
// corner 0 at the vertex.
struct Star_triangle
{
  Eigen::Vector2d a, b;
  Rest_shape shape;
};

// The part of a convex polygon on the left of the line from a to b.
inline void clip_polygon(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                         std::vector<Eigen::Vector2d>& polygon, std::vector<Eigen::Vector2d>& buffer)
{
  buffer.clear();
  for(std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Eigen::Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double dp = doubled_area(a, b, p), dq = doubled_area(a, b, q);
    if(dp >= 0)
      buffer.push_back(p);
    if((dp > 0 && dq < 0) || (dp < 0 && dq > 0))
      buffer.push_back(p + dp / (dp - dq) * (q - p));
  }
  polygon.swap(buffer);
}

// After so many halvings, no digit of a step is left.
constexpr int maximum_halvings = 60;

// The same shape, starting at another corner.
inline Rest_shape rotated(const Rest_shape& s, int corner)
{
  return corner == 0 ? s : corner == 1 ? Rest_shape{s.g1, s.g2, s.g0, s.area} : Rest_shape{s.g2, s.g0, s.g1, s.area};
}

// For stars whose energy does not matter.
inline Rest_shape no_shape()
{
  const Eigen::Vector2d zero = Eigen::Vector2d::Zero();
  return {zero, zero, zero, 0};
}

// The star of a vertex with these corners, 3t+k. `shape_of(c)`: the shape of the triangle of a corner, which comes first.
template <typename Corners, typename ShapeOf>
void collect_star(const Corners& corners, const std::vector<Triangle>& triangles, const std::vector<Eigen::Vector2d>& uv,
                  const ShapeOf& shape_of, std::vector<Star_triangle>& star)
{
  star.clear();
  for(int c : corners)
  {
    const Triangle& t = triangles[c / 3];
    star.push_back({uv[t[(c + 1) % 3]], uv[t[(c + 2) % 3]], shape_of(c)});
  }
}

// Finds where the center of a star can be put so that all its triangles are positive, with as little
// energy as possible: the centroid of the kernel, then Newton's method on the center alone. False if the
// kernel has no interior in floating point.
template <typename Energy>
class Star_placement
{
public:
  bool operator()(const std::vector<Star_triangle>& star, Eigen::Vector2d& center)
  {
    if(!kernel_centroid(star, center))
      return false;
    improve(star, center);
    return true;
  }

  // From a center that makes all triangles positive.
  static void improve(const std::vector<Star_triangle>& star, Eigen::Vector2d& center)
  {
    constexpr int maximum_steps = 8;           // a limit
    constexpr double decrement_to_stop = 1e-3; // of the energy; the global solve does the rest
    double e = energy(star, center);
    Triangle_terms terms;
    for(int i = 0; i < maximum_steps; ++i)
    {
      Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
      Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
      for(const Star_triangle& t : star)
      {
        triangle_terms<Energy, 1>(t.shape, center, t.a, t.b, terms);
        gradient += t.shape.area * terms.gradient[0];
        for(int k = 0; k < 4; ++k)
          hessian(k) += t.shape.area * terms.diagonal[0](k);
      }
      const double inverse = 1 / (hessian(0, 0) * hessian(1, 1) - hessian(1, 0) * hessian(0, 1));
      const Eigen::Vector2d step(hessian(1, 1) * inverse * gradient.x() - hessian(0, 1) * inverse * gradient.y(),
                                 hessian(0, 0) * inverse * gradient.y() - hessian(1, 0) * inverse * gradient.x());
      const double decrement = gradient.dot(step);
      if(!(decrement > decrement_to_stop * e))
        return;
      double t = 1, next = energy(star, center - step);
      for(int k = 0; k < maximum_halvings && !(next < e); ++k)
      {
        t *= 0.5;
        next = energy(star, center - t * step);
      }
      if(!(next < e))
        return;
      center -= t * step;
      e = next;
    }
  }

  // The mean of the corners of the kernel.
  bool kernel_centroid(const std::vector<Star_triangle>& star, Eigen::Vector2d& center)
  {
    Bounding_box<2> box;
    for(const Star_triangle& t : star)
    {
      box.add(t.a);
      box.add(t.b);
    }
    // The kernel of a border vertex's star is unbounded: the box stands for the rest of the plane.
    box.grow(box.longest_side());
    m_polygon = {box.low, Eigen::Vector2d(box.high.x(), box.low.y()), box.high,
                 Eigen::Vector2d(box.low.x(), box.high.y())};
    for(const Star_triangle& t : star)
    {
      clip_polygon(t.a, t.b, m_polygon, m_buffer);
      if(m_polygon.size() < 3)
        return false;
    }
    center.setZero();
    for(const Eigen::Vector2d& p : m_polygon)
      center += p;
    center /= double(m_polygon.size());
    return is_positive(star, center);
  }

private:
  static bool is_positive(const std::vector<Star_triangle>& star, const Eigen::Vector2d& center)
  {
    return std::all_of(star.begin(), star.end(), [&](const Star_triangle& t)
                       { return doubled_area(center, t.a, t.b) > 0; });
  }

  static double energy(const std::vector<Star_triangle>& star, const Eigen::Vector2d& center)
  {
    double sum = 0;
    for(const Star_triangle& t : star)
    {
      if(!(doubled_area(center, t.a, t.b) > 0))
        return std::numeric_limits<double>::infinity();
      sum += triangle_energy<Energy>(t.shape.area, t.shape, center, t.a, t.b);
    }
    return sum;
  }

  std::vector<Eigen::Vector2d> m_polygon, m_buffer;
};

using CGAL::internal::Graph_kernel::Index_set;

// The sum to minimize: weight times energy over triangles.
struct Weighted_triangles
{
  const std::vector<Triangle>& triangles;
  const std::vector<Rest_shape>& shapes;
  const std::vector<double>& weights;
};

// Nonlinear elimination [LRW96]: a few triangles that a step brought near a flip make the quadratic model useless and the
// next steps short, for all others as well. Their vertices are moved one by one, each to where the energy of its star is
// least, before the next direction is found.
class Star_relaxation
{
public:
  explicit Star_relaxation(Execution execution) : m_execution(execution) {}

  // Moves vertices whose own decrement is above `threshold`, unless these are the majority: a global step serves more of
  // them better. The system holds the gradient of the sum at `uv`, and does so afterwards. Returns by how much the sum
  // became less. No triangle flips. The triangles are the same in all calls.
  template <typename Energy>
  double relax(const Weighted_triangles& sum, double threshold, Newton_system& system, std::vector<Eigen::Vector2d>& uv)
  {
    constexpr int maximum_number_of_rounds = 4;
    std::vector<int> active = system.vertices_above(threshold);
    if(2 * active.size() > uv.size())
      return 0;
    if(!active.empty() && m_corners.number_of_buckets() == 0)
    {
      m_corners = corners_at_vertices(sum.triangles, int(uv.size()));
      m_touched = Index_set(int(uv.size()));
    }
    double gain = 0;
    for(int round = 0; round < maximum_number_of_rounds && !active.empty(); ++round)
    {
      m_touched.clear();
      for(int v : active)
      {
        const double decrease = move<Energy>(v, sum, uv);
        gain += decrease;
        if(decrease > 0)
          for(int c : m_corners[v])
            for(int w : sum.triangles[c / 3])
              m_touched.insert(w);
      }
      m_touched.sort();
      const std::vector<int>& touched = m_touched.indices();
      execute_blocks(m_execution, int(touched.size()), [&](int begin, int end)
      {
        for(int i = begin; i < end; ++i)
          system.set_gradient(touched[i], gradient<Energy>(touched[i], sum, uv));
      });
      active.clear();
      std::copy_if(touched.begin(), touched.end(), std::back_inserter(active),
                   [&](int v) { return system.decrement(v) > threshold; });
    }
    return gain;
  }

private:
  // Returns what that gains, 0 if the vertex stays.
  template <typename Energy>
  double move(int v, const Weighted_triangles& sum, std::vector<Eigen::Vector2d>& uv)
  {
    const auto shape_of = [&](int c)
    {
      Rest_shape shape = rotated(sum.shapes[c / 3], c % 3);
      shape.area = sum.weights[c / 3];
      return shape;
    };
    collect_star(m_corners[v], sum.triangles, uv, shape_of, m_star);
    const Eigen::Vector2d former = uv[v];
    const double former_energy = energy<Energy>(v, sum, uv);
    Star_placement<Energy>::improve(m_star, uv[v]);
    const double decrease = former_energy - energy<Energy>(v, sum, uv);
    if(decrease > 0)
      return decrease;
    uv[v] = former;
    return 0;
  }

  // The star's energy, with corners in the order in which the solver takes them: rounding cannot make it see a flip.
  template <typename Energy>
  double energy(int v, const Weighted_triangles& sum, const std::vector<Eigen::Vector2d>& uv) const
  {
    double result = 0;
    for(int c : m_corners[v])
    {
      const Triangle& t = sum.triangles[c / 3];
      result += triangle_energy<Energy>(sum.weights[c / 3], sum.shapes[c / 3], uv[t[0]], uv[t[1]], uv[t[2]]);
    }
    return result;
  }

  template <typename Energy>
  Eigen::Vector2d gradient(int v, const Weighted_triangles& sum, const std::vector<Eigen::Vector2d>& uv) const
  {
    Eigen::Vector2d result = Eigen::Vector2d::Zero(), at_corners[3];
    for(int c : m_corners[v])
    {
      const Triangle& t = sum.triangles[c / 3];
      triangle_gradient<Energy>(sum.shapes[c / 3], uv[t[0]], uv[t[1]], uv[t[2]], at_corners);
      result += sum.weights[c / 3] * at_corners[c % 3];
    }
    return result;
  }

  Execution m_execution;
  Buckets<int> m_corners; // at each vertex; found when a vertex is to move
  Index_set m_touched;    // vertices, in each round
  std::vector<Star_triangle> m_star;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_STARS_H
