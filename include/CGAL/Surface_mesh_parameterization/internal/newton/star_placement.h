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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_STAR_PLACEMENT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_STAR_PLACEMENT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/flip_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

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

// The same shape, starting at another corner.
inline Rest_shape rotated(const Rest_shape& s, int corner)
{
  return corner == 0 ? s : corner == 1 ? Rest_shape{s.g1, s.g2, s.g0, s.area} : Rest_shape{s.g2, s.g0, s.g1, s.area};
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

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_STAR_PLACEMENT_H
