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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_REST_SHAPES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_REST_SHAPES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A triangle laid flat: the gradients of its three hat functions and its area. A map with corner
// values u_i has the Jacobian sum of u_i g_i^T.
struct Rest_shape
{
  Eigen::Vector2d g0, g1, g2;
  double area;
};

// From the corners of a flat, counterclockwise triangle.
inline Rest_shape rest_shape(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  const double twice_area = doubled_area(a, b, c);
  const auto gradient = [&](const Eigen::Vector2d& s, const Eigen::Vector2d& t)
  { return Eigen::Vector2d((s.y() - t.y()) / twice_area, (t.x() - s.x()) / twice_area); };
  return Rest_shape{gradient(b, c), gradient(c, a), gradient(a, b), 0.5 * twice_area};
}

// The least height of a triangle over its longest edge. Thinner ones cannot be told from flipped ones where coordinates
// are rounded to 1e-16 of the whole.
constexpr double minimal_height = 1e-10;
// Rounding spoils what is smaller against its surroundings: at most nine digits are left. Coarser versions, whose
// flattest triangles simplification made, get at least this height: a rough shape does, and is easier to map.
constexpr double minimal_coarse_height = 1e-7;

// From the corners of a surface triangle. One edge is laid along the x axis; needles and caps get at least the
// height `lowest` relative to their longest edge, and points become equilateral with sides of
// `minimal_edge`, so that every triangle can be mapped without a flip and without an infinite energy.
inline Rest_shape rest_shape(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                             const Eigen::Vector3d& c, double minimal_edge, double lowest)
{
  // The longest edge carries the frame: this is the most accurate choice for needles.
  const Eigen::Vector3d* p[3] = {&a, &b, &c};
  const double squared_length[3] = {(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()};
  const int k = int(std::max_element(squared_length, squared_length + 3) - squared_length);
  const Eigen::Vector3d e = *p[(k + 1) % 3] - *p[k], f = *p[(k + 2) % 3] - *p[k];
  const double length = e.norm();
  const bool is_point = length <= minimal_edge;
  const double base = is_point ? minimal_edge : length;
  const double x = is_point ? 0.5 * base : f.dot(e) / length;
  const double height = is_point ? std::sqrt(0.75) * base
                                 : (std::max)(cross_product(e, f).norm() / length, lowest * base);
  Eigen::Vector2d q[3];
  q[k] = Eigen::Vector2d(0, 0);
  q[(k + 1) % 3] = Eigen::Vector2d(base, 0);
  q[(k + 2) % 3] = Eigen::Vector2d(x, height);
  return rest_shape(q[0], q[1], q[2]);
}

// The side of triangles that are points: far shorter than the mean edge, if that has a length at all.
inline double minimal_edge(const std::vector<Triangle>& triangles, const std::vector<Eigen::Vector3d>& points,
                           Execution execution = Execution::SEQUENTIAL)
{
  const double sum = reduce_blocks(execution, int(triangles.size()), 0., [&](int begin, int end)
  {
    double lengths = 0;
    for(int f = begin; f < end; ++f)
      lengths += (points[triangles[f][1]] - points[triangles[f][0]]).norm();
    return lengths;
  }, std::plus<double>());
  return minimal_coarse_height * (sum > 0 ? sum / double(triangles.size()) : 1);
}

// The shapes of all triangles of a surface in space.
inline std::vector<Rest_shape> rest_shapes(const std::vector<Triangle>& triangles,
                                           const std::vector<Eigen::Vector3d>& points,
                                           Execution execution = Execution::SEQUENTIAL,
                                           double lowest = minimal_height)
{
  const double shortest = minimal_edge(triangles, points, execution);
  std::vector<Rest_shape> shapes(triangles.size());
  execute_blocks(execution, int(triangles.size()), [&](int begin, int end)
  {
    for(int f = begin; f < end; ++f)
    {
      const Triangle& t = triangles[f];
      shapes[f] = rest_shape(points[t[0]], points[t[1]], points[t[2]], shortest, lowest);
    }
  });
  return shapes;
}

inline double triangle_area(const Triangle& t, const std::vector<Eigen::Vector2d>& uv)
{
  return 0.5 * doubled_area(uv[t[0]], uv[t[1]], uv[t[2]]);
}

inline double chart_area(const std::vector<Triangle>& triangles, const std::vector<Eigen::Vector2d>& uv)
{
  double area = 0;
  for(const Triangle& t : triangles)
    area += triangle_area(t, uv);
  return area;
}

inline double smallest_area(const std::vector<Triangle>& triangles, const std::vector<Eigen::Vector2d>& uv)
{
  double area = std::numeric_limits<double>::infinity();
  for(const Triangle& t : triangles)
    area = (std::min)(area, triangle_area(t, uv));
  return area;
}

inline double surface_area(const std::vector<Rest_shape>& shapes)
{
  double area = 0;
  for(const Rest_shape& s : shapes)
    area += s.area;
  return area;
}

// Each triangle's share of the area.
inline std::vector<double> area_weights(const std::vector<Rest_shape>& shapes)
{
  const double total = surface_area(shapes);
  std::vector<double> weights;
  weights.reserve(shapes.size());
  for(const Rest_shape& s : shapes)
    weights.push_back(s.area / total);
  return weights;
}

inline void scale_to_area(const std::vector<Triangle>& triangles, double area, std::vector<Eigen::Vector2d>& uv)
{
  const double factor = std::sqrt(area / chart_area(triangles, uv));
  for(Eigen::Vector2d& u : uv)
    u *= factor;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_REST_SHAPES_H
