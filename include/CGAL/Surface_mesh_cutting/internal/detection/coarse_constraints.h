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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_COARSE_CONSTRAINTS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_COARSE_CONSTRAINTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/detection/Coarse_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/input/restrict_to_feasible_component.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Topology.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The weight of each coarse edge: that of the cheapest way between its ends on the fine mesh, not far from the edge;
// infinite if there is none.
inline std::vector<double> coarse_weights(const Indexed_mesh& fine, const Edge_constraints& constraints,
                                          const Coarse_mesh& coarse)
{
  using CGAL::internal::Graph_kernel::Shortest_paths;
  constexpr double reach = 2; // of the longest edge at a vertex: no cheap way goes around further
  Shortest_paths paths(fine.graph());
  const auto& arcs = fine.graph().arcs;
  const auto& coarse_graph = coarse.mesh.graph();
  std::vector<double> weights(coarse.mesh.number_of_edges(), std::numeric_limits<double>::infinity());
  std::vector<char> is_wanted(fine.number_of_vertices(), 0);
  for(int u = 0; u < coarse.mesh.number_of_vertices(); ++u)
  {
    double radius = 0;
    int number_of_ends = 0;
    const auto for_each_end = [&](auto f)
    {
      for(int a = coarse_graph.offsets[u]; a < coarse_graph.offsets[u + 1]; ++a)
        if(coarse_graph.arcs[a].target > u) // once for both directions
          f(coarse_graph.arcs[a], coarse.vertices[coarse_graph.arcs[a].target]);
    };
    for_each_end([&](const auto& arc, int end)
    {
      radius = (std::max)(radius, reach * arc.weight);
      number_of_ends += !std::exchange(is_wanted[end], char(1));
    });
    const int source = coarse.vertices[u];
    paths.clear();
    paths.add_source(source);
    paths.run([&](int v)
              {
                number_of_ends -= std::exchange(is_wanted[v], char(0));
                return number_of_ends > 0;
              },
              [&](int a)
              {
                return (fine.point(arcs[a].target) - fine.point(source)).norm() < radius
                       ? constraints.weights[arcs[a].edge] : Shortest_paths::infinity();
              });
    for_each_end([&](const auto& arc, int end)
    {
      is_wanted[end] = 0;
      weights[arc.edge] = paths.distance(end);
    });
  }
  return weights;
}

// The constraints of a surface without mandatory edges on its coarser version with the given terminals. Where what
// they leave there does not suffice to cut it to a disk, what is forbidden is left to the surface itself.
inline Edge_constraints coarse_constraints(const Indexed_mesh& fine, const Edge_constraints& constraints,
                                           const Coarse_mesh& coarse, const std::vector<int>& terminals)
{
  Edge_constraints result = unconstrained(coarse.mesh);
  if(!has_forbidden_sides(constraints) && weights_are_lengths(fine, constraints))
    return result;
  Edge_constraints whole = result;
  whole.weights = coarse_weights(fine, constraints, coarse);
  const Corner_table chart = make_chart(coarse.mesh, whole.mandatory);
  const Topology topology = topologies(chart, Connected_parts(chart.opposites())).front();
  return restrict_to_feasible_component(coarse.mesh, topology, terminals, whole) ? whole : result;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_COARSE_CONSTRAINTS_H
