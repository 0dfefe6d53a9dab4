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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_RUN_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_RUN_H

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/Unwrap_result.h>
#include <CGAL/Surface_mesh_cutting/internal/flat_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/internal/input/read_edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/input/read_parameters.h>
#include <CGAL/Surface_mesh_cutting/internal/input/read_run_control.h>

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/linear_solver_source.h>

#include <CGAL/Default.h>

#include <functional>
#include <utility>

#ifndef CGAL_SURFACE_MESH_CUTTING_USE_LIBRARY
#include <CGAL/Surface_mesh_cutting/internal/flat_functions/cut_flat_mesh.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

struct Ignore_result
{
  template <typename Adapter>
  void operator()(const Adapter&, const Mesh_result&) const {}
};

// Translates what a run on the flat mesh found into terms of the caller's mesh.
template <typename TriangleMesh, typename Adapter>
void translate(const Mesh_result& found, const Adapter& adapter, Unwrap_result<TriangleMesh>& result)
{
  result.components = found.components;
  result.genus = found.genus;
  result.borders = found.borders;
  result.candidates = found.candidates;
  result.features = int(found.features.size());
  result.auxiliary = found.auxiliary;
  for(int v : found.features)
    result.feature_points.push_back(adapter.to_vertex(v));
  result.bounding_box_diagonal = adapter.to_original_scale(found.diagonal);
  result.cut_length = adapter.to_original_scale(found.length);
  if(found.lower_bound > 0)
  {
    result.cut_lower_bound = adapter.to_original_scale(found.lower_bound);
    result.optimal = found.is_optimal;
  }
  result.E_iso = found.average_energy;
  result.E_max = found.maximum_energy;
  result.flips = found.flips;
  result.overlaps = found.overlaps;
  result.has_result = found.has_result;
  for(const Trade_off& t : found.trade_offs)
    result.trade_offs.push_back({adapter.to_original_scale(t.cut_length), t.E_iso});
}

// What becomes of a result: it is written to the caller's property maps.
template <typename Adapter>
using Write = std::function<void(const Adapter&, const Mesh_result&)>;

// Runs the method and translates what it finds. The same for all named parameters. The map is proven for UVs held
// as `UV`.
template <typename ConcurrencyTag, typename UV, typename TriangleMesh, typename Adapter>
void run_adapted(const Adapter& adapter, Goal goal, const Write<Adapter>& write, const Cutting_constraints& constraints,
                 const Request& request, Run_control& control, Phase_clock& clock, Flat_status status,
                 Unwrap_result<TriangleMesh>& result)
{
  if(status)
  {
    const auto round = [&adapter](const Eigen::Vector2d& uv) { return adapter.template rounded_uv<UV>(uv); };
    const Mesh_result found
      = cut_flat_mesh<ConcurrencyTag>(adapter.mesh(), goal, round, constraints, request, control, clock);
    status.finding = found.status.finding;
    status.warnings.insert(status.warnings.end(), found.status.warnings.begin(), found.status.warnings.end());
    translate(found, adapter, result);
    if(found.has_result)
      write(adapter, found);
    if(control.is_stopped())
      status.finding = stopped_status().finding; // whatever else was found may come from that
  }
  result.status = adapter.translate(status);
  result.seconds = clock.wall();
  result.cpu_seconds = clock.cpu();
}

// The common part of the calls that run the method: reads the mesh and the named parameters, checks them, runs, lets
// `write(adapter, found)` hand out the result if there is one, and reports.
template <typename ConcurrencyTag, typename UV = Eigen::Vector2d, typename TriangleMesh, typename WriteResult,
          typename NamedParameters>
Unwrap_result<TriangleMesh> run(const TriangleMesh& tmesh, Goal goal, WriteResult write, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;

  Phase_clock clock;
  Unwrap_result<TriangleMesh> result;
  Default_visitor default_visitor;
  Visitor_reference<NamedParameters> visitor
    = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);
  Run_control control = read_run_control(visitor, np);
  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type Vertex_point_map;
  typedef Mesh_adapter<TriangleMesh, Vertex_point_map> Adapter;
  const Adapter adapter(tmesh, choose_parameter(get_parameter(np, internal_np::vertex_point),
                                                get_const_property_map(CGAL::vertex_point, tmesh)));
  Request request = read_request(np);
  request.parameters.linear_solvers = Surface_mesh_parameterization::internal::make_linear_solver_source(
    choose_parameter(get_parameter(np, internal_np::sparse_linear_solver), Default()));

  Flat_status status = adapter.status();
  if(status)
    status.finding = check_parameters(request.parameters).finding;
  Cutting_constraints constraints;
  if(status)
    status.finding = read_constraints(adapter, np, constraints).finding;
  run_adapted<ConcurrencyTag, UV, TriangleMesh, Adapter>(adapter, goal, write, constraints, request, control, clock,
                                                         std::move(status), result);
  return result;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_RUN_H
