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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_FACE_ENERGIES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_FACE_ENERGIES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// The energy of each triangle, infinite where the image is not counterclockwise.
template <typename Energy>
std::vector<double> face_energies(const std::vector<Rest_shape>& shapes,
                                  const std::vector<Triangle>& triangles,
                                  const std::vector<Eigen::Vector2d>& uv,
                                  Execution execution = Execution::SEQUENTIAL)
{
  std::vector<double> energies(shapes.size());
  execute_blocks(execution, int(shapes.size()), [&](int begin, int end)
  {
    for(int t = begin; t < end; ++t)
    {
      const Triangle& v = triangles[t];
      const Wirtinger_derivatives d = wirtinger_derivatives(shapes[t], uv[v[0]], uv[v[1]], uv[v[2]]);
      const double x = d.x(), y = d.y();
      energies[t] = x > y ? Energy::value(x, y) : std::numeric_limits<double>::infinity();
    }
  });
  return energies;
}

// The average over the area of the surface.
inline double area_average(const std::vector<Rest_shape>& shapes,
                           const std::vector<double>& energies)
{
  double sum = 0, area = 0;
  for(std::size_t t = 0; t < shapes.size(); ++t)
  {
    sum += shapes[t].area * energies[t];
    area += shapes[t].area;
  }
  return sum / area;
}

// What the scale of a map depends on: the sums of area |J|^2 and area |J^-1|^2.
struct Stretch_sums
{
  double stretch = 0, compression = 0;

  // The factor to multiply the map with, so that its area-averaged symmetric Dirichlet energy becomes as
  // small as possible: that of |sJ|^2 + |(sJ)^-1|^2 = s^2 |J|^2 + s^-2 |J^-1|^2.
  double best_scale() const { return std::sqrt(std::sqrt(compression / stretch)); }
};

// Of a flip-free map.
inline Stretch_sums stretch_sums(const std::vector<Rest_shape>& shapes, const std::vector<Triangle>& triangles,
                                 const std::vector<Eigen::Vector2d>& uv)
{
  Stretch_sums sums;
  for(std::size_t t = 0; t < shapes.size(); ++t)
  {
    const Triangle& v = triangles[t];
    const Wirtinger_derivatives d = wirtinger_derivatives(shapes[t], uv[v[0]], uv[v[1]], uv[v[2]]);
    const double squared_norm = 2 * (d.x() + d.y()), determinant = d.x() - d.y();
    sums.stretch += shapes[t].area * squared_norm;
    sums.compression += shapes[t].area * squared_norm / (determinant * determinant);
  }
  return sums;
}

inline double best_scale(const std::vector<Rest_shape>& shapes, const std::vector<Triangle>& triangles,
                         const std::vector<Eigen::Vector2d>& uv)
{
  return stretch_sums(shapes, triangles, uv).best_scale();
}

// The average over the triangles at each vertex, weighted by area; 0 at an isolated vertex.
inline std::vector<double> vertex_averages(const std::vector<Rest_shape>& shapes,
                                           const std::vector<Triangle>& triangles,
                                           const std::vector<double>& face_values,
                                           int number_of_vertices)
{
  std::vector<double> sums(number_of_vertices, 0), areas(number_of_vertices, 0);
  for(std::size_t t = 0; t < shapes.size(); ++t)
    for(int v : triangles[t])
    {
      sums[v] += shapes[t].area * face_values[t];
      areas[v] += shapes[t].area;
    }
  for(int v = 0; v < number_of_vertices; ++v)
    if(areas[v] > 0)
      sums[v] /= areas[v];
  return sums;
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_FACE_ENERGIES_H
