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

#include <CGAL/Surface_mesh_cutting/Effort.h>
#include <CGAL/Surface_mesh_cutting/internal/cut_through_points.h>
#include <CGAL/Surface_mesh_cutting/internal/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/internal/read_edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/read_parameters.h>
#include <CGAL/Surface_mesh_cutting/internal/read_run_control.h>
#include <CGAL/Surface_mesh_cutting/Status.h>
#include <CGAL/Surface_mesh_cutting/Visitor.h>

#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

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
  Status<TriangleMesh> status;
  /// the length of the cut, border edges not counted.
  double length = 0;
  /// a lower bound of the weight of all cuts that consist of the constrained edges, the loops that
  /// were chosen to cut handles, and other edges that connect all that is to be connected. It can
  /// be compared with the length unless other weights than lengths are given. What the methods
  /// other than `Connection::EXACT` and `Connection::BEST` do not prove counts zero.
  double lower_bound = 0;
  /// whether the cut is proven to reach this bound.
  bool is_optimal = false;
  /// the number of vertices where the edges that connect branch and that were not to be connected.
  int number_of_auxiliary_points = 0;

  /// `true` iff all is connected as asked for.
  explicit operator bool() const { return bool(status); }
};

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// connects vertices by a short cut after which each part of the surface is a disk.
///
/// On a closed surface of genus 0, the cut is a tree whose leaves are among the given vertices. On
/// other surfaces, handles are cut first, see `cut_handles()`. The borders, those that handles and
/// constrained edges leave included, are connected as well: each counts as one point. If
/// constrained edges separate the surface, each part is connected on its own. A part that is a disk
/// already and contains none of the given vertices is not cut further.
///
/// The border of a disk has at least three edges: where a single edge would be enough, the cheapest
/// edge next to it is added.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithm. Possible values are
///         `Sequential_tag`, `Parallel_tag`, and `Parallel_if_available_tag`. The result is the
///         same.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam VertexRange a range of vertex descriptors of `TriangleMesh`, a model of `ConstRange`
/// \tparam EdgeIsCutMap a model of `ReadWritePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value
///         type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface; it may have handles, borders and several components
/// \param points the vertices to connect. Each closed component of genus 0 in which no edge is
///        constrained must contain at least two of them.
/// \param edge_is_cut_map is set to `true` for the edges of the cut, the constrained ones included,
///        and to `false` for the others; unchanged if there is no cut
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
///        listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
///                    `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{connection}
///     \cgalParamDescription{how the points are connected}
///     \cgalParamType{`Surface_mesh_cutting::Connection`}
///     \cgalParamDefault{`Connection::BEST`, and `Connection::GREEDY` with `faithful(true)`}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{edge_weight_map}
///     \cgalParamDescription{what it costs to cut an edge: the sum of the weights is minimized.
///                           Weights are not negative; an edge of infinite weight is not cut.}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and
///                    a number type as value type}
///     \cgalParamDefault{the lengths of the edges}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{minimum_length_decrease}
///     \cgalParamDescription{by how much an auxiliary point must shorten the cut to be added, as a
///                           fraction of the length of the bounding box diagonal. Used by
///                           `Connection::GREEDY` with `faithful(true)` only.}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0.01`}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{faithful}
///     \cgalParamDescription{whether to connect as the paper does: greedily, and without exchanging
///                           auxiliary points in the end}
///     \cgalParamType{Boolean}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{maximum_number_of_states}
///     \cgalParamDescription{the budget of the search for a shortest tree; it counts states, not
///                           seconds, so that results are reproducible}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{`20000000`}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{marks edges that are part of the cut from the start}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool`
///                    as value type}
///     \cgalParamDefault{no edge is constrained}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{edge_is_forbidden_map}
///     \cgalParamDescription{marks edges that must not be cut}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool`
///                    as value type}
///     \cgalParamDefault{no edge is forbidden}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{can end the run}
///     \cgalParamType{a class model of `CuttingVisitor`}
///     \cgalParamDefault{`Surface_mesh_cutting::Default_visitor`}
///     \cgalParamExtra{pass it by `std::ref` if it is not to be copied}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{the time in seconds after which the run ends with
///                           `Status_code::STOPPED`; 0 means no limit}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return what is known about the cut, and a status: `Status_code::OK`;
///         `Status_code::BOUND_NOT_REACHED` with `Connection::EXACT` where the budget does not
///         suffice for a proof; `Status_code::STOPPED`, with a cut that may be longer than
///         necessary; `Status_code::INFEASIBLE_CONSTRAINTS` with edges that are constrained and
///         forbidden, the forbidden edges that keep a part from becoming a disk, or the vertices
///         that only such edges lead to; `Status_code::WRONG_PARAMETER` with the edges of
///         invalid weight or the faces of a closed part with less than two of the points, or where
///         another parameter is out of its range; or, for a surface that the package does not take,
///         `Status_code::EMPTY_MESH`, `Status_code::NOT_TRIANGULATED`, `Status_code::NON_MANIFOLD`
///         or `Status_code::INVALID_POINT`.
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
  using parameters::get_parameter;
  using parameters::get_parameter_reference;

  Default_visitor default_visitor;
  auto&& visitor
    = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);
  internal::Run_control control = internal::read_run_control(visitor, np);
  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type Vertex_point_map;
  const internal::Mesh_adapter<TriangleMesh, Vertex_point_map> adapter(
    tmesh, choose_parameter(get_parameter(np, internal_np::vertex_point),
                            get_const_property_map(CGAL::vertex_point, tmesh)));
  const internal::Request request = internal::read_request(np);
  internal::Edge_constraints constraints;
  internal::Flat_status status = adapter.status();
  if(status)
    status.finding = internal::check_parameters(request.parameters).finding;
  if(status)
    status.finding = internal::read_edge_constraints(adapter, np, constraints).finding;

  Connection_result<TriangleMesh> result;
  if(status)
  {
    const internal::Flat_mesh& mesh = adapter.mesh();
    const internal::Connected_cut connected = internal::cut_through_points<ConcurrencyTag>(
      mesh, constraints, internal::read_vertices(tmesh, adapter, points), request,
      [&control] { return control.go_further(); });
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
