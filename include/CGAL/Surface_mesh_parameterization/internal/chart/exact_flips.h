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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_EXACT_FLIPS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_EXACT_FLIPS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The exact sign of the area of the triangle `abc` of finite points.
inline Orientation exact_orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  using Point_2 = Exact_predicates_inexact_constructions_kernel::Point_2;
  return orientation(Point_2(a.x(), a.y()), Point_2(b.x(), b.y()), Point_2(c.x(), c.y()));
}

// Whether the triangle `abc` is strictly counterclockwise; exact. Points that are not finite make no such triangle.
inline bool is_counterclockwise(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  return is_finite(a) && is_finite(b) && is_finite(c) && exact_orientation(a, b, c) == COUNTERCLOCKWISE;
}

// The number of triangles that are not strictly counterclockwise, decided exactly; their indices
// are appended to `witness`.
inline int count_flips(const std::vector<Triangle>& triangles, const std::vector<Eigen::Vector2d>& uv,
                       std::vector<int>* witness = nullptr, Execution execution = Execution::SEQUENTIAL)
{
  const int size = int(triangles.size());
  std::vector<std::vector<int> > flipped(number_of_blocks(size));
  execute_blocks(execution, size, [&](int begin, int end)
  {
    for(int t = begin; t < end; ++t)
    {
      const Triangle& v = triangles[t];
      if(!is_counterclockwise(uv[v[0]], uv[v[1]], uv[v[2]]))
        flipped[begin / block_size].push_back(t);
    }
  });
  int flips = 0;
  for(const std::vector<int>& block : flipped)
  {
    flips += int(block.size());
    if(witness != nullptr)
      witness->insert(witness->end(), block.begin(), block.end());
  }
  return flips;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_EXACT_FLIPS_H
