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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_INITIAL_MAP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_INITIAL_MAP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/areas.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/exact_flips.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Tutte's embedding of a chart whose longest border loop becomes a circle, scaled to the surface's
// area. `points` holds the position of each chart vertex on the surface. False if rounding left a
// triangle that is not positive, or so small against the whole that its coordinates have lost their
// digits, or if the chart has no border of at least three edges.
inline bool tutte_map(const Corner_table& chart, const std::vector<Eigen::Vector3d>& points, double area,
                      const Solvers& linear_solvers, std::vector<Eigen::Vector2d>& uv)
{
  const std::vector<std::vector<int> > loops = chart.border_loops();
  std::vector<double> lengths, outer_lengths;
  std::size_t outer = 0;
  double longest = -1;
  for(std::size_t l = 0; l < loops.size(); ++l)
  {
    double sum = 0;
    lengths.clear();
    for(int h : loops[l])
    {
      lengths.push_back((points[chart.target(h)] - points[chart.source(h)]).norm());
      sum += lengths.back();
    }
    if(loops[l].size() >= 3 && sum > longest)
    {
      longest = sum;
      outer = l;
      outer_lengths = lengths;
    }
  }
  if(longest < 0)
    return false;
  uv.assign(chart.number_of_vertices(), Eigen::Vector2d::Zero());
  map_border_to_circle(chart, loops[outer], outer_lengths, uv);
  if(!tutte_embedding(chart, loops, outer, linear_solvers, uv))
    return false;
  scale_to_area(chart.triangles(), area, uv);
  constexpr double smallest_share = 1e-28;
  return smallest_area(chart.triangles(), uv) > smallest_share * area &&
         count_flips(chart.triangles(), uv) == 0;
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_INITIAL_MAP_H
