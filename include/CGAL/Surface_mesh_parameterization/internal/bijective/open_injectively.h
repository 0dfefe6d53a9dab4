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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_OPEN_INJECTIVELY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_OPEN_INJECTIVELY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/star_placement.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Moves a border vertex inward, the source of a halfedge: to the left of both border edges, so that the chart's image
// shrinks, and only as far as no triangle around it loses more than half of its area.
inline void draw_inwards(const Corner_table& chart, int halfedge, std::vector<Eigen::Vector2d>& uv)
{
  constexpr double largest_step = 0.1; // of the shorter one of the two edges
  const int v = chart.source(halfedge);
  const Eigen::Vector2d former = uv[v];
  std::vector<Star_triangle> star;
  collect_star(chart.ring(halfedge), chart.triangles(), uv, [](int) { return Rest_shape(); }, star);
  const Eigen::Vector2d incoming = former - star.back().b, outgoing = star.front().a - former;
  const Eigen::Vector2d along = incoming.normalized() + outgoing.normalized();
  const auto keeps_areas = [&](const Star_triangle& t)
  { return doubled_area(uv[v], t.a, t.b) > doubled_area(former, t.a, t.b) / 2; };
  double step = largest_step * (std::min)(incoming.norm(), outgoing.norm());
  for(int i = 0; i < maximum_halvings; ++i, step /= 2)
  {
    uv[v] = former + step * Eigen::Vector2d(-along.y(), along.x()).normalized();
    if(std::all_of(star.begin(), star.end(), keeps_areas))
      return;
  }
  uv[v] = former;
}

// Opens edges (one halfedge each) of a chart whose map is injective, and draws their sides a little apart: the map
// stays injective but for rounding. O(number of edges + their one-rings).
inline void open_injectively(const std::vector<int>& halfedges, Corner_table& chart, std::vector<Eigen::Vector2d>& uv)
{
  const Corner_table::Opening opening = chart.open(halfedges);
  std::vector<int> split; // all copies of the vertices that fell apart
  uv.resize(chart.number_of_vertices());
  for(const auto& [corner, former] : opening.corners)
  {
    uv[chart.source(corner)] = uv[former];
    split.push_back(former);
    split.push_back(chart.source(corner));
  }
  std::sort(split.begin(), split.end());
  for(const auto& [halfedge, former_opposite] : opening.opposites)
    if(std::binary_search(split.begin(), split.end(), chart.source(halfedge)))
      draw_inwards(chart, halfedge, uv);
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_OPEN_INJECTIVELY_H
