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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_CARRY_OVER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_CARRY_OVER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/mapping/Open_chart.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/exact_flips.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/hierarchical_map.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Brings the map of a surface opened along one cut to the chart of another cut: copies of a vertex that are one now meet
// between their places. Opening keeps a map as it is; where a piece of the cut is closed, the triangles on both sides
// stretch to each other, and only where these lay one on the other, some flip. Those are put back, see `remove_flips()`.
// The order of elimination comes along, too. False if too many flip; then `next` has no map. O(n).
inline bool carry_over(const Indexed_mesh& mesh, const Open_chart& former, Open_chart& next)
{
  using namespace Surface_mesh_parameterization::internal;
  // After more, what follows takes longer than to start anew.
  constexpr double few_flips = 0.002; // of the triangles
  constexpr int few_collapses = 10;   // for each flip
  next.uv.assign(next.chart.number_of_vertices(), Eigen::Vector2d::Zero());
  std::vector<int> numbers(next.chart.number_of_vertices(), 0); // of corners
  for(int c = 0; c < 3 * mesh.number_of_faces(); ++c)
  {
    const int v = next.chart.source(c);
    // The mean so far: where all copies are in one place, rounding does not move it.
    next.uv[v] += (former.uv[former.chart.source(c)] - next.uv[v]) / ++numbers[v];
  }
  const int flips = count_flips(next.chart.triangles(), next.uv);
  if(flips > few_flips * mesh.number_of_faces() ||
     (flips > 0 && !remove_flips(next.chart, chart_points(mesh, next.chart), next.uv, few_collapses * flips)))
    return false;
  next.ranks = former.ranks;
  return true;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_CARRY_OVER_H
