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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_RUN_PIPELINE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_RUN_PIPELINE_H

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/Unwrap_result.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/internal/input/read_edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/run/read_parameters.h>
#include <CGAL/Surface_mesh_cutting/internal/run/read_run_control.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/to_plane.h>

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers.h>

#include <CGAL/Default.h>

#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/cut_indexed_mesh.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

struct Ignore_result
{
  template <typename Adapter>
  void operator()(const Adapter&, const Mesh_result&) const {}
};

// Translates what a run on the indexed mesh found into terms of the caller's mesh.
template <typename TriangleMesh, typename Adapter>
void translate(const Mesh_result& found, const Adapter& adapter, Cut_result<TriangleMesh>& result)
{
  result.components = found.components;
  result.genus = found.genus;
  result.borders = found.borders;
  result.number_of_candidates = found.number_of_candidates;
  result.number_of_auxiliary_points = found.number_of_auxiliary_points;
  for(int v : found.features)
    result.feature_points.push_back(adapter.to_vertex(v));
  result.bounding_box_diagonal = adapter.to_original_scale(found.diagonal);
  result.cut_length = adapter.to_original_scale(found.length);
  result.cut_cost = adapter.to_original_scale(found.cost);
  if(found.lower_bound > 0)
  {
    result.lower_bound = adapter.to_original_scale(found.lower_bound);
    result.is_optimal = found.is_optimal;
  }
  result.has_result = found.has_result;
  if(found.symmetry)
    result.symmetry = to_plane(*found.symmetry, adapter);
  for(const Trade_off& t : found.trade_offs)
    result.trade_offs.push_back({adapter.to_original_scale(t.cut_length), adapter.to_original_scale(t.cut_cost),
                                 t.average_distortion});
}

template <typename TriangleMesh, typename Adapter>
void translate(const Mesh_result& found, const Adapter& adapter, Unwrap_result<TriangleMesh>& result)
{
  translate(found, adapter, static_cast<Cut_result<TriangleMesh>&>(result));
  result.average_distortion = found.average_energy;
  result.largest_face_distortion = found.maximum_energy;
  result.distortion_quantiles = found.quantiles;
  for(const Chart_energy& chart : found.charts)
    result.charts.push_back({chart.average, chart.maximum, 0});
  for(std::size_t f = 0; f < found.chart_of_face.size(); ++f)
    if(f == 0 || adapter.to_polygon(int(f)) != adapter.to_polygon(int(f) - 1)) // whose triangles follow each other
      ++result.charts[found.chart_of_face[f]].number_of_faces;
  result.flips = found.flips;
  result.overlaps = found.overlaps;
}

// What becomes of a result: it is written to the caller's property maps.
template <typename Adapter>
using Write = std::function<void(const Adapter&, const Mesh_result&)>;

// Runs the method and translates what it finds. The same for all named parameters. The map is proven for UVs held
// as `UV`.
template <typename UV, typename Result, typename Adapter>
Indexed_status run_method(const Adapter& adapter, Output_kind output, const Write<Adapter>& write,
                          const Cutting_constraints& constraints, const Context& context, Result& result)
{
  const auto round = [&adapter](const Eigen::Vector2d& uv) { return adapter.template rounded_uv<UV>(uv); };
  const Mesh_result found = cut_indexed_mesh(adapter.mesh(), output, round, constraints, context);
  translate(found, adapter, result);
  if(found.has_result)
  {
    context.control.finish();
    write(adapter, found);
  }
  Indexed_status status = found.status;
  if(context.control.is_stopped())
    status.finding = stopped_status().finding; // whatever else was found may come from that
  return status;
}

// The common part of the calls that run the method: reads the surface, by `make_adapter(go_further)`, and the named parameters,
// checks them, runs, lets `write(adapter, found)` hand out the result if there is one, and reports.
template <typename ConcurrencyTag, typename Result, typename UV, typename MakeAdapter, typename WriteResult,
          typename NamedParameters>
Result run_on_adapter(const MakeAdapter& make_adapter, Output_kind output, WriteResult write, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;

  Phase_clock clock;
  Result result;
  Default_visitor default_visitor;
  Visitor_reference<NamedParameters> visitor
    = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);
  Run_control control = read_run_control(visitor, np);
  const auto adapter = make_adapter(Go_further(control));
  using Adapter = std::decay_t<decltype(adapter)>;
  Cutting_parameters parameters = read_cutting_parameters(np);
  using namespace Surface_mesh_parameterization::internal;
  const auto linear_solvers = std::make_shared<Solvers>(make_solvers(
    choose_parameter(get_parameter(np, internal_np::sparse_linear_solver), Default()), control,
    execution_of<ConcurrencyTag>()));
  linear_solvers->factorized_unknowns = &clock.unknowns();
  parameters.linear_solvers = linear_solvers;

  Indexed_status status = adapter.status();
  if(status)
    status.finding = check_parameters(parameters).finding;
  Cutting_constraints constraints;
  if(status)
    status.finding = read_constraints(adapter, np, constraints).finding;
  if(status)
  {
    Indexed_status found;
    const auto run = [&]
    {
      found = run_method<UV, Result, Adapter>(
        adapter, output, write, constraints, Context{parameters, control, clock, execution_of<ConcurrencyTag>()}, result);
    };
    execute_both(execution_of<ConcurrencyTag>(), run, [&] { status.warnings = adapter.warnings(); });
    status.finding = found.finding;
    status.warnings.insert(status.warnings.end(), found.warnings.begin(), found.warnings.end());
  }
  result.status = adapter.translate(status);
  visitor.ended(clock.profile());
  return result;
}

// The same for a mesh.
template <typename ConcurrencyTag, typename Result, typename UV = Eigen::Vector2d, typename TriangleMesh,
          typename WriteResult, typename NamedParameters>
Result run_pipeline(const TriangleMesh& tmesh, Output_kind output, WriteResult write, const NamedParameters& np)
{
  constexpr Execution execution = Surface_mesh_parameterization::internal::execution_of<ConcurrencyTag>();
  return run_on_adapter<ConcurrencyTag, Result, UV>(
    [&](const Go_further& go_further) { return make_mesh_adapter(tmesh, np, execution, go_further); }, output, write, np);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_RUN_PIPELINE_H
