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

#ifndef CGAL_SURFACE_MESH_CUTTING_CUT_HANDLES_H
#define CGAL_SURFACE_MESH_CUTTING_CUT_HANDLES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/internal/handles/Handle_loops.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/internal/input/read_edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/run/read_run_control.h>
#include <CGAL/Surface_mesh_cutting/Result_status.h>
#include <CGAL/Surface_mesh_cutting/Visitor.h>

#include <boost/graph/graph_traits.hpp>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// is the result of `cut_handles()`.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
template <typename TriangleMesh>
struct Handles_result
{
  /// how the call ended.
  Result_status<TriangleMesh> status;
  /// one loop per handle, in the order of their discovery: a sequence of halfedges, each of which
  /// starts where the previous one ends. A loop may share vertices and edges with earlier loops,
  /// and run along the border.
  std::vector<std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> > loops;
  /// the length of the loops: each edge counts once; border edges and constrained edges do not
  /// count.
  double length = 0;

  /// `true` iff all handles are cut.
  explicit operator bool() const { return bool(status); }
};

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// finds short loops that cut the handles of a surface: opened along them, each of its components stays
/// connected and has genus 0. There are as many loops as handles.
///
/// The function chooses the loops one after the other. Each is at most 1.02 times as long as the shortest loop that does
/// not separate the surface opened along the earlier loops. Moving along the border, along constrained edges, and along
/// earlier loops costs nothing.
///
/// With \f$ n \f$ vertices and genus \f$ g \f$, the time is \f$ O(\lceil g / 192 \rceil\, n \log n + s) \f$, where \f$ s \f$
/// is the total size of balls around some vertices, whose radii are about half the lengths of the loops. The memory is
/// \f$ O(n) \f$.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsCutMap a model of `WritablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface; it may have borders and several components
/// \param edge_is_cut_map receives `true` for the edges of the loops and for the constrained ones, and `false` for the
///        others; stays unchanged if the handles cannot be cut
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{can end the run}
///     \cgalParamType{a class model of `CuttingVisitor`}
///     \cgalParamDefault{`Surface_mesh_cutting::Default_visitor`}
///     \cgalParamExtra{It is copied; pass it by `std::ref` to keep it.}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{the time in seconds after which the run ends with `Status_code::STOPPED`; 0 means no limit,
///                           and a negative value ends the run at once}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \copydetails PkgSurfaceMeshCuttingConstraintParameters
///
/// \return the loops and their length, and a status, one of
/// - `Status_code::OK`;
/// - `Status_code::INFEASIBLE_CONSTRAINTS`, with edges that are both constrained and forbidden, or with the forbidden
///   edges that keep a handle from being cut;
/// - `Status_code::WRONG_PARAMETER`, with the edges of invalid weight;
/// - `Status_code::STOPPED`, without loops;
/// - `Status_code::EMPTY_MESH`, `Status_code::NOT_TRIANGULATED`, `Status_code::NON_MANIFOLD` or
///   `Status_code::INVALID_POINT` for an unsupported mesh.
///
/// \sa `connect_points()`
template <typename TriangleMesh, typename EdgeIsCutMap,
          typename NamedParameters = parameters::Default_named_parameters>
Handles_result<TriangleMesh> cut_handles(const TriangleMesh& tmesh, EdgeIsCutMap edge_is_cut_map,
                                         const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter_reference;

  Default_visitor default_visitor;
  internal::Visitor_reference<NamedParameters> visitor
    = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);
  internal::Run_control control = internal::read_run_control(visitor, np);
  const auto adapter = internal::make_mesh_adapter(tmesh, np);
  Handles_result<TriangleMesh> result;
  internal::Indexed_status status = adapter.status();
  internal::Edge_constraints constraints;
  internal::Handle_loops handles;
  if(status)
    status.finding = internal::read_edge_constraints(adapter, np, constraints).finding;
  if(status)
  {
    status.warnings = adapter.warnings();
    handles = internal::cut_handles_of_components(adapter.mesh(), constraints, control);
    status.finding = handles.status.finding;
  }
  result.status = adapter.translate(status);
  if(!status)
    return result;

  adapter.write_cut(handles.cut, edge_is_cut_map);
  result.length = adapter.to_original_scale(
    internal::cut_length(adapter.mesh(), handles.cut) -
    internal::cut_length(adapter.mesh(), constraints.mandatory));
  for(const std::vector<internal::Directed_edge>& loop : handles.loops)
  {
    result.loops.emplace_back();
    for(const internal::Directed_edge& e : loop)
    {
      const auto h = adapter.to_halfedge(e.halfedge);
      result.loops.back().push_back(e.is_forward ? h : opposite(h, tmesh));
    }
  }
  return result;
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_CUT_HANDLES_H
