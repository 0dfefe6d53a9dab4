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

#ifndef CGAL_SURFACE_MESH_CUTTING_CONNECT_POINTS_H
#define CGAL_SURFACE_MESH_CUTTING_CONNECT_POINTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/Connection.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/internal/input/read_edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/run/read_parameters.h>
#include <CGAL/Surface_mesh_cutting/internal/run/read_run_control.h>
#include <CGAL/Surface_mesh_cutting/internal/input/read_vertices.h>
#include <CGAL/Surface_mesh_cutting/Result_status.h>
#include <CGAL/Surface_mesh_cutting/Visitor.h>

#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/connect_indexed_points.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// is the result of `connect_points()`.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
template <typename TriangleMesh>
struct Connection_result
{
  /// how the call ended.
  Result_status<TriangleMesh> status;
  /// the length of the cut without border edges.
  double length = 0;
  /// a lower bound on the weight of every cut that consists of the constrained edges, the chosen
  /// handle loops, and further edges that connect the points, borders and loops. Compare it with the
  /// length only if the weights are lengths. The further edges count zero for methods without a
  /// bound: all but `Connection::EXACT` and `Connection::BEST`.
  double lower_bound = 0;
  /// whether the cut is proven to reach this bound.
  bool is_optimal = false;
  /// the number of vertices at which the connection branches and that were not among the points.
  int number_of_auxiliary_points = 0;

  /// `true` iff everything is connected as requested.
  explicit operator bool() const { return bool(status); }
};

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// connects vertices by a short cut that leaves only topological disks.
///
/// On a closed surface of genus 0, the cut is a tree whose leaves are among the given vertices. Other surfaces lose
/// their handles first, see `cut_handles()`. The cut also connects the borders, including those that handles and
/// constrained edges leave: each counts as one point. If constrained edges separate the surface, each part is connected
/// on its own. A part that is already a disk and contains no given vertex is not cut further.
///
/// The border of a disk has at least three edges: where a single edge would suffice, the cheapest edge next to it is
/// added.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithms: `Sequential_tag` (default),
///         `Parallel_tag`, or `Parallel_if_available_tag`. The result does not depend on it.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam VertexRange a range of vertex descriptors of `TriangleMesh`, a model of `ConstRange`
/// \tparam EdgeIsCutMap a model of `WritablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface; it may have handles, borders and several components
/// \param points the vertices to connect. Each closed component of genus 0 without constrained edges must contain at
///        least two of them.
/// \param edge_is_cut_map receives `true` for the edges of the cut, including the constrained ones, and `false` for the
///        others; stays unchanged if there is no cut
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{use_published_method}
///     \cgalParamDescription{whether to connect as the paper does: greedily, without exchanging auxiliary points
///                           afterward}
///     \cgalParamType{Boolean}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{can end the run}
///     \cgalParamType{a class model of `CuttingVisitor`}
///     \cgalParamDefault{`Surface_mesh_cutting::Default_visitor`}
///     \cgalParamExtra{It is copied; pass it by `std::ref` to keep it.}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{the time in seconds after which the run ends with
///                           `Status_code::STOPPED`; 0 means no limit, and a negative value ends the run at once}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \copydetails PkgSurfaceMeshCuttingConnectionParameters
/// \copydetails PkgSurfaceMeshCuttingConstraintParameters
///
/// \return the length of the cut and a bound on it, and a status, one of
/// - `Status_code::OK`;
/// - `Status_code::BOUND_NOT_REACHED` with `Connection::EXACT` if the budget does not suffice for a proof;
/// - `Status_code::STOPPED`, with a cut that may be longer than necessary, or none if the run stopped while it cut the handles:
///   `edge_is_cut_map` then stays unchanged, and the length is 0;
/// - `Status_code::INFEASIBLE_CONSTRAINTS`, with edges that are both constrained and forbidden, with the forbidden
///   edges that keep a part from becoming a disk, or with the vertices reachable only through forbidden edges;
/// - `Status_code::WRONG_PARAMETER`, with the edges of invalid weight, or with the faces of a closed part that holds
///   fewer than two of the points, or for another parameter out of its range;
/// - `Status_code::EMPTY_MESH`, `Status_code::NOT_TRIANGULATED`, `Status_code::NON_MANIFOLD` or
///   `Status_code::INVALID_POINT` for an unsupported mesh.
///
/// \sa `CGAL::steiner_tree()`
/// \sa `cut_handles()`
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename VertexRange,
          typename EdgeIsCutMap, typename NamedParameters = parameters::Default_named_parameters>
Connection_result<TriangleMesh>
connect_points(const TriangleMesh& tmesh, const VertexRange& points, EdgeIsCutMap edge_is_cut_map,
               const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter_reference;

  Default_visitor default_visitor;
  internal::Visitor_reference<NamedParameters> visitor
    = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);
  internal::Run_control control = internal::read_run_control(visitor, np);
  const auto adapter = internal::make_mesh_adapter(tmesh, np);
  const internal::Cutting_parameters parameters = internal::read_cutting_parameters(np);
  internal::Edge_constraints constraints;
  internal::Indexed_status status = adapter.status();
  if(status)
    status.finding = internal::check_parameters(parameters).finding;
  if(status)
    status.finding = internal::read_edge_constraints(adapter, np, constraints).finding;

  Connection_result<TriangleMesh> result;
  if(status)
  {
    status.warnings = adapter.warnings();
    const internal::Indexed_mesh& mesh = adapter.mesh();
    const internal::Connected_cut connected = internal::connect_indexed_points(
      mesh, constraints, internal::read_vertices(tmesh, adapter, points), parameters,
      Surface_mesh_parameterization::internal::execution_of<ConcurrencyTag>(), control);
    status.finding = control.is_stopped() ? internal::stopped_status().finding : connected.status.finding;
    if(connected.has_cut())
    {
      adapter.write_cut(connected.cut, edge_is_cut_map);
      result.length = adapter.to_original_scale(internal::cut_length(mesh, connected.cut));
      result.lower_bound = adapter.to_original_scale(connected.lower_bound);
      result.is_optimal = connected.is_optimal;
      result.number_of_auxiliary_points = connected.number_of_auxiliary_points;
    }
  }
  result.status = adapter.translate(status);
  return result;
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_CONNECT_POINTS_H
