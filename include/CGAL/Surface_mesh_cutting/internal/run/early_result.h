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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_EARLY_RESULT_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_EARLY_RESULT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/connection/connect_terminals.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/handles/Handle_loops.h>
#include <CGAL/Surface_mesh_cutting/internal/handles/cut_graph.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/early_map.h>
#include <CGAL/Surface_mesh_cutting/internal/result/Component_result.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>
#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Vertices of a closed surface that are far from each other: each is the farthest from all before it, and from the given
// ones. Fewer if there are no more.
inline std::vector<int> far_vertices(const Indexed_mesh& mesh, const Edge_constraints& constraints, std::vector<int> vertices)
{
  constexpr std::size_t enough = 8;
  const std::vector<char> is_reachable = reachable_vertices(mesh, constraints);
  CGAL::internal::Graph_kernel::Shortest_paths paths(mesh.graph());
  const auto weight = [&](int a)
  {
    const auto& arc = mesh.graph().arcs[a];
    return constraints.is_forbidden(arc.edge) ? paths.infinity() : arc.weight;
  };
  const auto search = [&] { paths.run([](int) { return true; }, weight); };
  if(vertices.empty()) // any one leads to the first
    paths.add_source(int(std::find(is_reachable.begin(), is_reachable.end(), char(1)) - is_reachable.begin()));
  for(int v : vertices)
    paths.add_source(v);
  search();
  for(bool is_first = vertices.empty(); vertices.size() < enough; is_first = false)
  {
    const std::vector<int>& reached = paths.touched();
    const int farthest = *std::max_element(reached.begin(), reached.end(),
                                           [&](int v, int w) { return paths.distance(v) < paths.distance(w); });
    if(paths.distance(farthest) == 0)
      break;
    vertices.push_back(farthest);
    if(is_first)
      paths.clear();
    paths.add_source(farthest);
    search();
  }
  return vertices;
}

// A cut to one disk, along the given one where there is one.
inline Connected_cut early_cut(const Problem& problem, const std::vector<int>& terminals, Execution execution)
{
  const Indexed_mesh& mesh = problem.mesh;
  Edge_constraints constraints = problem.constraints;
  if(total_genus(make_chart(mesh, constraints.mandatory)) > 0) // the run was stopped before it had all loops
    constraints.mandatory = cut_graph(mesh, problem.initial.is_given() ? problem.initial.guide(constraints) : constraints);
  if(problem.initial.is_given())
    return problem.initial.connected(mesh, constraints, terminals, execution, always_go_further);
  CGAL::internal::Steiner_tree::Options options;
  options.method = CGAL::internal::Steiner_tree::Method::metric_closure;
  return connect_terminals(mesh, constraints, terminals, options, execution, always_go_further);
}

// Completes `found`, what a run leaves of a surface that was stopped or failed numerically, to a result: by a cut that takes
// little time to find, through what features there are, unless there is one, and a map of it without overlaps. The status of a stop stays.
inline void complete_early(const Problem& problem, bool needs_map, const Context& context, Component_result& found)
{
  if(!found.has_cut)
  {
    CGAL::internal::Graph_kernel::add_unique(problem.terminals, found.features);
    if(problem.is_sphere && !problem.initial.is_given())
      found.features = far_vertices(problem.mesh, problem.constraints, std::move(found.features));
    Connected_cut connected = early_cut(problem, found.features, context.execution);
    if(!connected.status)
      return;
    std::sort(found.features.begin(), found.features.end());
    found.cut = std::move(connected.cut);
    found.length = cut_length(problem.mesh, found.cut);
    found.cost = cut_cost(problem.constraints, found.cut);
    found.number_of_auxiliary_points = connected.number_of_auxiliary_points;
    found.has_cut = true;
  }
  found.is_optimal = false;
  if(!needs_map || found.has_map)
    return;
  using namespace Surface_mesh_parameterization::internal;
  found.chart = make_chart(problem.mesh, found.cut);
  const auto goes_on = [&control = context.control]
  { return control.is_stopped() ? control.was_just_stopped() : control.go_further(); };
  found.has_map = early_map(problem, found.chart, *context.parameters.linear_solvers, goes_on, context.execution, found.uv);
  if(found.has_map)
    found.energy = area_average(problem.shapes, face_energies<Symmetric_Dirichlet_energy>(
                                                  problem.shapes, found.chart.triangles(), found.uv, context.execution));
  if(found.has_map && found.status.finding.code == Status_code::NUMERICAL_FAILURE)
    found.status = Indexed_status();
  found.keep_undominated_trade_offs();
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_EARLY_RESULT_H
