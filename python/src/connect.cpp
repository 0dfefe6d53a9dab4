// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#include "connect.h"

#include "cut_surface.h"

#include <CGAL/Surface_mesh_cutting/internal/context/Run_control.h>
#include <CGAL/Surface_mesh_cutting/internal/handles/Handle_loops.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/input/read_edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/run/read_parameters.h>

namespace binding {

namespace {

using SMC::internal::Edge_constraints;
using SMC::internal::Indexed_mesh;
using SMC::internal::Indexed_status;

Indexed_status read_constraints(const Named_surface& surface, const Soup_adapter& adapter, Edge_constraints& constraints)
{
  const auto np = CGAL::parameters::edge_is_constrained_map(surface.mandatory_edges())
                    .edge_is_forbidden_map(surface.forbidden_edges());
  return surface.arguments().has_weights
           ? read_edge_constraints(adapter, np.edge_weight_map(surface.edge_weights()), constraints)
           : read_edge_constraints(adapter, np, constraints);
}

// Reads the surface and its constraints, lets `find(adapter, constraints, result)` look for a cut, and reports.
template <typename Result, typename Find>
Result find_cut(const Surface_arguments& arguments, const Find& find)
{
  Result result;
  Named_surface surface(arguments);
  try
  {
    const Soup_adapter adapter = surface.read();
    Indexed_status status = adapter.status();
    Edge_constraints constraints;
    if(status)
      status.finding = read_constraints(surface, adapter, constraints).finding;
    if(status)
      status.finding = find(surface, adapter, constraints, result).finding;
    result.status = adapter.translate(status);
  }
  catch(const Refusal& refusal)
  {
    static_cast<Finding&>(result.status) = refusal.finding;
  }
  result.interpreted = surface.interpreted();
  return result;
}

// The vertices of the surface that the caller names: all that stand for the same point.
std::vector<int> terminals(const Named_surface& surface, const Soup_adapter& adapter)
{
  std::vector<int> result;
  for(int v = 0; v < adapter.mesh().number_of_vertices(); ++v)
    if(get(surface.terminals(), adapter.to_vertex(v)))
      result.push_back(v);
  return result;
}

} // namespace

Connected_points connect_points(const Surface_arguments& arguments, const Connection_options& options, Run_monitor& monitor)
{
  const auto find = [&](const Named_surface& surface, const Soup_adapter& adapter, const Edge_constraints& constraints,
                        Connected_points& result)
  {
    const Indexed_mesh& mesh = adapter.mesh();
    SMC::internal::Run_control control([&] { return monitor.go_further(); }, {});
    const SMC::internal::Connected_cut connected = SMC::internal::connect_indexed_points(
      mesh, constraints, terminals(surface, adapter),
      SMC::internal::read_cutting_parameters(CGAL::parameters::connection(options.connection)
                                               .maximum_number_of_states(options.maximum_number_of_states)),
      CGAL::internal::Graph_kernel::execution_of<Concurrency_tag>(), control);
    result.has_result = connected.has_cut();
    if(result.has_result)
    {
      result.cut_edges = named_cut(adapter, connected.cut);
      result.length = adapter.to_original_scale(SMC::internal::cut_length(mesh, connected.cut));
      result.lower_bound = adapter.to_original_scale(connected.lower_bound);
      result.is_optimal = connected.is_optimal;
      result.number_of_auxiliary_points = connected.number_of_auxiliary_points;
    }
    return control.is_stopped() ? SMC::internal::stopped_status() : connected.status;
  };
  return find_cut<Connected_points>(arguments, find);
}

Cut_handles cut_handles(const Surface_arguments& arguments, Run_monitor& monitor)
{
  const auto find = [&](const Named_surface&, const Soup_adapter& adapter, const Edge_constraints& constraints,
                        Cut_handles& result)
  {
    const Indexed_mesh& mesh = adapter.mesh();
    const SMC::internal::Handle_loops handles
      = SMC::internal::cut_handles_of_components(mesh, constraints, [&] { return monitor.go_further(); });
    result.has_result = bool(handles.status);
    if(!result.has_result)
      return handles.status;
    result.cut_edges = named_cut(adapter, handles.cut);
    result.length = adapter.to_original_scale(SMC::internal::cut_length(mesh, handles.cut) -
                                              SMC::internal::cut_length(mesh, constraints.mandatory));
    for(const std::vector<SMC::internal::Directed_edge>& loop : handles.loops)
    {
      result.loops.emplace_back();
      for(const SMC::internal::Directed_edge& e : loop)
        result.loops.back().push_back(
          std::int64_t(adapter.to_vertex(e.is_forward ? mesh.source(e.halfedge) : mesh.target(e.halfedge))));
    }
    return handles.status;
  };
  return find_cut<Cut_handles>(arguments, find);
}

} // namespace binding
