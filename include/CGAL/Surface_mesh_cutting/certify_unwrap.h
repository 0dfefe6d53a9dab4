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

#ifndef CGAL_SURFACE_MESH_CUTTING_CERTIFY_UNWRAP_H
#define CGAL_SURFACE_MESH_CUTTING_CERTIFY_UNWRAP_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/Result_status.h>

#include <Eigen/Core>

#include <vector>

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/certify_indexed_map.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// proves that a surface is unwrapped: opened along the marked edges, it consists of topological
/// disks; all UVs are finite; corners at a vertex that the cut does not separate have the same UV;
/// and the map takes each triangle to a strictly counterclockwise one. With `do_bijective`, it also
/// proves that the map is injective up to contact: the images of any two triangles, in the same chart or
/// in different ones, have disjoint interiors. Borders of charts may touch, and the two sides of a cut may
/// lie on top of each other.
///
/// All decisions are exact: the predicates of `Exact_predicates_inexact_constructions_kernel` make
/// them, on coordinates converted to `double` and without any tolerance.
///
/// The time is linear in the size of the surface. The test of injectivity takes
/// \f$ O(n + (b + k) \log b) \f$ time for \f$ b \f$ edges on the borders of charts and \f$ k \f$
/// pairs of intersecting bounding boxes among them.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsCutMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value
///         type
/// \tparam HalfedgeUVMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `%Point_2` as
///         value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface
/// \param edge_is_cut_map marks the edges of the cut; marks on border edges are ignored
/// \param halfedge_uv_map holds at each halfedge `h` that is not on the border the UV of the corner
///        of `face(h, tmesh)` at `target(h, tmesh)`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
///        listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{do_bijective}
///     \cgalParamDescription{whether the map must also be injective up to contact}
///     \cgalParamType{Boolean}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
///                    `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return a status, one of
/// - `Status_code::OK`;
/// - `Status_code::NOT_CUT_TO_DISKS`, with all faces of one part that is not a disk;
/// - `Status_code::NOT_CERTIFIED`, with a message that counts the defects, and the faces concerned:
///   those with an invalid UV, those that are not counterclockwise, the two at each overlap of
///   borders, and one of each chart that lies on another one;
/// - `Status_code::EMPTY_MESH`, `Status_code::NOT_TRIANGULATED`, `Status_code::NON_MANIFOLD` or
///   `Status_code::INVALID_POINT` for an unsupported mesh.
///
/// \sa `unwrap()`
/// \sa `certify_cut()`
template <typename TriangleMesh, typename EdgeIsCutMap, typename HalfedgeUVMap,
          typename NamedParameters = parameters::Default_named_parameters>
Result_status<TriangleMesh> certify_unwrap(const TriangleMesh& tmesh, EdgeIsCutMap edge_is_cut_map,
                                           HalfedgeUVMap halfedge_uv_map,
                                           const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const auto adapter = internal::make_mesh_adapter(tmesh, np);
  const bool do_bijective = choose_parameter(get_parameter(np, internal_np::do_bijective), false);

  internal::Indexed_status status = adapter.status();
  if(!status)
    return adapter.translate(status);
  const internal::Cut cut = adapter.read_cut(edge_is_cut_map);
  const internal::Corner_table chart = internal::make_chart(adapter.mesh(), cut);
  const std::vector<Eigen::Vector2d> uvs = adapter.read_uvs(halfedge_uv_map);
  status.finding = internal::certify_indexed_map(chart, uvs, do_bijective).finding;
  return adapter.translate(status);
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_CERTIFY_UNWRAP_H
