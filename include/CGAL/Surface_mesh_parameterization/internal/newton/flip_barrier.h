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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_FLIP_BARRIER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_FLIP_BARRIER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// The smallest positive root of a + b t + c t^2 with a > 0, infinity if there is none.
inline double smallest_positive_root(double a, double b, double c)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double discriminant = b * b - 4 * a * c;
  if(!(discriminant >= 0))
    return infinity;
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  const double r = a / q, s = q / c;
  return (std::min)(r > 0 ? r : infinity, s > 0 ? s : infinity);
}

// After so many halvings, no digit of a step is left.
constexpr int maximum_halvings = 60;

// How far all vertices can move along `direction` until a triangle degenerates [SS15, Section 3.3].
inline double step_to_first_flip(const std::vector<Triangle>& triangles,
                                 const std::vector<Eigen::Vector2d>& uv,
                                 const std::vector<Eigen::Vector2d>& direction,
                                 Execution execution = Execution::SEQUENTIAL)
{
  const auto smaller = [](double s, double t) { return (std::min)(s, t); };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return reduce_blocks(execution, int(triangles.size()), infinity, [&](int begin, int end)
  {
    double step = infinity;
    for(int f = begin; f < end; ++f)
    {
      const Triangle& t = triangles[f];
      const Eigen::Vector2d a = uv[t[1]] - uv[t[0]], b = uv[t[2]] - uv[t[0]];
      const Eigen::Vector2d da = direction[t[1]] - direction[t[0]], db = direction[t[2]] - direction[t[0]];
      step = smaller(step, smallest_positive_root(determinant(a, b), determinant(a, db) + determinant(da, b),
                                                 determinant(da, db)));
    }
    return step;
  }, smaller);
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_FLIP_BARRIER_H
