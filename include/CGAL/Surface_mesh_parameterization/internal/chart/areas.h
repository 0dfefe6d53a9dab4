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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_AREAS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_AREAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/cross_product.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

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

inline void scale_to_area(const std::vector<Triangle>& triangles, double area,
                          std::vector<Eigen::Vector2d>& uv)
{
  const double factor = std::sqrt(area / chart_area(triangles, uv));
  for(Eigen::Vector2d& u : uv)
    u *= factor;
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_AREAS_H
