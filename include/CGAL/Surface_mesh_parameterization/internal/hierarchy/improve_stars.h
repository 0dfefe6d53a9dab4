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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_IMPROVE_STARS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_IMPROVE_STARS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/exact_flips.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/star_placement.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Moves each inner vertex of a flip-free map to where the energy of its star is least, one after the other. A few rounds
// take out what is wrong in single places, for a fraction of what a global step costs; the border stays where it is. O(n).
template <typename Energy>
void improve_stars(const Corner_table& chart, const std::vector<Rest_shape>& shapes, std::vector<Eigen::Vector2d>& uv,
                   Execution execution = Execution::SEQUENTIAL)
{
  constexpr int number_of_rounds = 2;
  std::vector<int> halfedges(chart.number_of_vertices(), -1); // one that leaves each inner vertex
  for(int h = 0; h < int(chart.opposites().size()); ++h)
    halfedges[chart.source(h)] = h;
  for(int h = 0; h < int(chart.opposites().size()); ++h)
    if(chart.is_border(h))
      halfedges[chart.source(h)] = -1;
  std::vector<Eigen::Vector2d> improved = uv;
  std::vector<Star_triangle> star;
  for(int round = 0; round < number_of_rounds; ++round)
    for(int v = 0; v < int(halfedges.size()); ++v)
    {
      const int first = halfedges[v];
      if(first < 0)
        continue;
      star.clear();
      int h = first;
      do
      {
        star.push_back({improved[chart.target(h)], improved[chart.source(previous_halfedge(h))], rotated(shapes[h / 3], h % 3)});
        h = chart.next_around_source(h);
      }
      while(h != first);
      Star_placement<Energy>::improve(star, improved[v]);
    }
  if(count_flips(chart.triangles(), improved, nullptr, execution) == 0) // exact, unlike the steps
    uv.swap(improved);
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_IMPROVE_STARS_H
