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

#ifndef CGAL_SURFACE_MESH_CUTTING_DISTORTION_REPORT_H
#define CGAL_SURFACE_MESH_CUTTING_DISTORTION_REPORT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/Distortion_measures.h>
#include <CGAL/Surface_mesh_cutting/Result_status.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>

#include <CGAL/Named_function_parameters.h>

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/measure_indexed_map.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// is the result of `distortion_report()`.
template <typename TriangleMesh>
struct Distortion_report : public Distortion_measures
{
  Result_status<TriangleMesh> status; ///< how the call ended.

  /// `true` iff the measures were computed.
  explicit operator bool() const { return bool(status); }
};

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// measures the distortion of a map from a surface to the plane, by the measures of the parameterization benchmark of Shay,
/// Solomon and Stein \cgalCite{cgal:sss-dbmp-22}. The map may come from any method and have flips. A polygon counts as the
/// triangles into which `unwrap()` divides it.
///
/// The time is \f$ O(n + (b + k) \log b) \f$ for \f$ b \f$ edges on the borders of charts and \f$ k \f$ pairs of them
/// with boxes that meet.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsCutMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
/// \tparam HalfedgeUVMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `%Point_2` as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface
/// \param edge_is_cut_map marks the edges of the cut; marks on border edges are ignored
/// \param halfedge_uv_map holds at each halfedge `h` that is not on the border the UV of the corner
///        of `face(h, tmesh)` at `target(h, tmesh)`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
///                    `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the measures and a status, one of
/// - `Status_code::OK`;
/// - `Status_code::NOT_CERTIFIED`, with the faces that have an invalid UV, or whose UVs differ from those of a neighbor
///   across an edge that is not cut, or with all faces if the map has no area;
/// - `Status_code::EMPTY_MESH`, `Status_code::NOT_TRIANGULATED`, `Status_code::NON_MANIFOLD` or
///   `Status_code::INVALID_POINT` for an unsupported mesh.
///
/// \sa `certify_unwrap()`
/// \sa `CGAL::Surface_mesh_parameterization::compute_symmetric_Dirichlet_energy()`
template <typename TriangleMesh, typename EdgeIsCutMap, typename HalfedgeUVMap,
          typename NamedParameters = parameters::Default_named_parameters>
Distortion_report<TriangleMesh> distortion_report(const TriangleMesh& tmesh, EdgeIsCutMap edge_is_cut_map,
                                                  HalfedgeUVMap halfedge_uv_map,
                                                  const NamedParameters& np = parameters::default_values())
{
  const auto adapter = internal::make_mesh_adapter(tmesh, np);
  Distortion_report<TriangleMesh> report;
  internal::Indexed_status status = adapter.status();
  if(status)
    status.finding = internal::measure_indexed_map(adapter.mesh(), adapter.read_cut(edge_is_cut_map),
                                                   adapter.read_uvs(halfedge_uv_map), report).finding;
  report.resolution = adapter.to_original_scale(report.resolution);
  report.status = adapter.translate(status);
  return report;
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_DISTORTION_REPORT_H
