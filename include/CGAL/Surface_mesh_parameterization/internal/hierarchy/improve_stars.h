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

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/exact_flips.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/star_placement.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// A halfedge that leaves each inner vertex; -1 for the others.
inline std::vector<int> halfedges_of_inner_vertices(const Corner_table& chart)
{
  std::vector<int> halfedges(chart.number_of_vertices(), -1);
  for(int h = 0; h < int(chart.opposites().size()); ++h)
    halfedges[chart.source(h)] = h;
  for(int h = 0; h < int(chart.opposites().size()); ++h)
    if(chart.is_border(h))
      halfedges[chart.source(h)] = -1;
  return halfedges;
}

// Sets of inner vertices that are not neighbors: each goes to the first set in which none of its neighbors is. O(n).
inline std::vector<std::vector<int> > independent_sets(const Corner_table& chart, const std::vector<int>& halfedges)
{
  std::vector<std::vector<int> > sets;
  std::vector<int> set_of(halfedges.size(), -1), last_neighbor; // of each set, the last vertex with a neighbor in it
  for(int v = 0; v < int(halfedges.size()); ++v)
  {
    if(halfedges[v] < 0)
      continue;
    int h = halfedges[v];
    do
    {
      const int s = set_of[chart.target(h)];
      if(s >= 0)
        last_neighbor[s] = v;
      h = chart.next_around_source(h);
    }
    while(h != halfedges[v]);
    int s = 0;
    while(s < int(sets.size()) && last_neighbor[s] == v)
      ++s;
    if(s == int(sets.size()))
    {
      sets.emplace_back();
      last_neighbor.push_back(-1);
    }
    set_of[v] = s;
    sets[s].push_back(v);
  }
  return sets;
}

// Moves each inner vertex of a flip-free map to where the energy of its star is least, after its neighbors of the sets
// before. A few rounds take out what is wrong in single places, for a fraction of what a global step costs; the border
// stays where it is. O(n).
template <typename Energy>
void improve_stars(const Corner_table& chart, const std::vector<Rest_shape>& shapes, std::vector<Eigen::Vector2d>& uv,
                   Execution execution = Execution::SEQUENTIAL)
{
  constexpr int number_of_rounds = 2;
  constexpr int part_size = 512; // vertices that one thread takes at a time
  const std::vector<int> halfedges = halfedges_of_inner_vertices(chart);
  const std::vector<std::vector<int> > sets = independent_sets(chart, halfedges);
  std::vector<Eigen::Vector2d> improved = uv;
  const auto improve = [&](int v, std::vector<Star_triangle>& star)
  {
    star.clear();
    int h = halfedges[v];
    do
    {
      star.push_back({improved[chart.target(h)], improved[chart.source(previous_halfedge(h))], rotated(shapes[h / 3], h % 3)});
      h = chart.next_around_source(h);
    }
    while(h != halfedges[v]);
    Star_placement<Energy>::improve(star, improved[v]);
  };
  for(int round = 0; round < number_of_rounds; ++round)
    for(const std::vector<int>& set : sets)
      execute_blocks(execution, int(set.size()), [&](int begin, int end)
      {
        std::vector<Star_triangle> star;
        for(int i = begin; i < end; ++i)
          improve(set[i], star);
      }, part_size);
  if(count_flips(chart.triangles(), improved, nullptr, execution) == 0) // exact, unlike the steps
    uv.swap(improved);
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_IMPROVE_STARS_H
