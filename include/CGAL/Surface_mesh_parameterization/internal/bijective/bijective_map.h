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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_BIJECTIVE_MAP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_BIJECTIVE_MAP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/hierarchical_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/stars.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <Eigen/Core>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Whether `uv` flips no triangle and is injective up to contact; exact.
bool is_bijective(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv,
                  Execution execution = Execution::SEQUENTIAL);

// As isometric as possible among the injective maps of a connected chart, free border; `uv` holds the
// isometric map, with what its solve returned. That is the answer if its borders do not overlap.
// FAILED if no injective map was found, or if one on the way has more than `hopeless_energy`.
Newton_result make_bijective(const Corner_table& chart, const std::vector<Eigen::Vector3d>& points,
                             const std::vector<Rest_shape>& shapes, const Solvers& linear_solvers,
                             std::vector<Eigen::Vector2d>& uv, const Newton_result& isometric,
                             const Newton_options& options,
                             double hopeless_energy = std::numeric_limits<double>::infinity());

// The same without a map to start with. `points` holds the position of each chart vertex on the
// surface, `shapes` the triangles laid flat.
Newton_result bijective_map(const Corner_table& chart, const std::vector<Eigen::Vector3d>& points,
                            const std::vector<Rest_shape>& shapes, const Solvers& linear_solvers,
                            std::vector<Eigen::Vector2d>& uv, const Newton_options& options);

// Moves a border vertex inward, the source of a halfedge: to the left of both border edges, so that the chart's image
// shrinks, and only as far as no triangle around it loses more than half of its area.
inline void draw_inwards(const Corner_table& chart, int halfedge, std::vector<Eigen::Vector2d>& uv)
{
  constexpr double largest_step = 0.1; // of the shorter one of the two edges
  const int v = chart.source(halfedge);
  const Eigen::Vector2d former = uv[v];
  std::vector<Star_triangle> star;
  collect_star(chart.ring(halfedge), chart.triangles(), uv, [](int) { return no_shape(); }, star);
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

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_parameterization/internal/bijective/bijective_map_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_BIJECTIVE_MAP_H
