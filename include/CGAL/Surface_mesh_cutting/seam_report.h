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

#ifndef CGAL_SURFACE_MESH_CUTTING_SEAM_REPORT_H
#define CGAL_SURFACE_MESH_CUTTING_SEAM_REPORT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/Seam_measures.h>
#include <CGAL/Surface_mesh_cutting/Result_status.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/tags.h>

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/measure_indexed_seams.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// is the result of `seam_report()`.
template <typename TriangleMesh>
struct Seam_report : public Seam_measures
{
  Result_status<TriangleMesh> status; ///< how the call ended.

  /// `true` iff the measures were computed.
  explicit operator bool() const { return bool(status); }
};

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// measures how natural the seams of a map look: how straight they are, whether they run where a person would put them, and
/// the shapes of the charts. The map may come from any method and have flips.
///
/// The time is \f$ O(n + (b + n) \log n) \f$ on most surfaces, for \f$ b \f$ edges of the cut.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithms: `Sequential_tag` (default),
///         `Parallel_tag`, or `Parallel_if_available_tag`. The result does not depend on it.
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
///   across an edge that is not cut;
/// - `Status_code::EMPTY_MESH`, `Status_code::NOT_TRIANGULATED`, `Status_code::NON_MANIFOLD` or
///   `Status_code::INVALID_POINT` for an unsupported mesh.
///
/// \sa `distortion_report()`
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename EdgeIsCutMap, typename HalfedgeUVMap,
          typename NamedParameters = parameters::Default_named_parameters>
Seam_report<TriangleMesh> seam_report(const TriangleMesh& tmesh, EdgeIsCutMap edge_is_cut_map, HalfedgeUVMap halfedge_uv_map,
                                      const NamedParameters& np = parameters::default_values())
{
  const auto adapter = internal::make_mesh_adapter(tmesh, np);
  Seam_report<TriangleMesh> report;
  internal::Indexed_status status = adapter.status();
  if(status)
    status.finding = internal::measure_indexed_seams(
      adapter.mesh(), adapter.read_cut(edge_is_cut_map), adapter.read_uvs(halfedge_uv_map),
      Surface_mesh_parameterization::internal::execution_of<ConcurrencyTag>(), report).finding;
  report.status = adapter.translate(status);
  return report;
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_SEAM_REPORT_H
