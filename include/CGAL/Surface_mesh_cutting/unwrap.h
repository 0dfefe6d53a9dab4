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

#ifndef CGAL_SURFACE_MESH_CUTTING_UNWRAP_H
#define CGAL_SURFACE_MESH_CUTTING_UNWRAP_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/Unwrap_result.h>
#include <CGAL/Surface_mesh_cutting/internal/run/run_pipeline.h>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// cuts a surface as `greedy_cut()` does and flattens it without flips and with low isometric distortion.
/// Exact predicates check the map with the coordinates that `halfedge_uv_map` holds, also if they are of type `float`
/// or of an exact number type. If rounding spoils the map, the function repairs it.
///
/// The cost is that of `greedy_cut()` plus that of the final map: a few sparse linear systems of the size of
/// the surface.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithms: `Sequential_tag` (default),
///         `Parallel_tag`, or `Parallel_if_available_tag`. The result does not depend on it.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsCutMap a model of `WritablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
/// \tparam HalfedgeUVMap a model of `WritablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and a value type that
///         can be constructed from two numbers and has members `x()` and `y()`, such as `%Point_2` of any kernel
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface; it is not modified
/// \param edge_is_cut_map receives `true` or `false` for each edge
/// \param halfedge_uv_map receives, at each halfedge `h` that is not on the border, the UV of the corner
///        of `face(h, tmesh)` at `target(h, tmesh)`, at the scale of the surface; charts
///        lie side by side, aligned with the axes
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// Both maps stay unchanged unless `Cut_result::has_result`.
///
/// \cgalNamedParamsBegin{Optional Named Parameters: Map}
///   \cgalParamNBegin{do_bijective}
///     \cgalParamDescription{whether the map must also be injective up to contact: no two triangles overlap, in the same
///                           chart or in different ones}
///     \cgalParamType{Boolean}
///     \cgalParamDefault{`false`}
///     \cgalParamExtra{If a chart lacks room in the plane, the method opens slits or divides the chart, see
///                     \ref smc_bijective. With a bound, this can take most of the time.}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \copydetails PkgSurfaceMeshCuttingQualityParameters
/// \copydetails PkgSurfaceMeshCuttingConstraintParameters
/// \copydetails PkgSurfaceMeshCuttingFeatureParameters
/// \copydetails PkgSurfaceMeshCuttingConnectionParameters
/// \copydetails PkgSurfaceMeshCuttingRunParameters
///
/// \return the distortion, the length of the cut, and more. Its `status` is one of those of `greedy_cut()`, or
///         `Status_code::NOT_CUT_TO_DISKS` or `Status_code::NOT_CERTIFIED` if the result fails the exact check.
///
/// \sa `greedy_cut()`
/// \sa `certify_unwrap()`
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename EdgeIsCutMap,
          typename HalfedgeUVMap, typename NamedParameters = parameters::Default_named_parameters>
Unwrap_result<TriangleMesh> unwrap(const TriangleMesh& tmesh, EdgeIsCutMap edge_is_cut_map,
                                   HalfedgeUVMap halfedge_uv_map,
                                   const NamedParameters& np = parameters::default_values())
{
  using UV = typename boost::property_traits<HalfedgeUVMap>::value_type;
  return internal::run_pipeline<ConcurrencyTag, Unwrap_result<TriangleMesh>, UV>(
    tmesh, internal::Output_kind::MAP,
    [&](const auto& adapter, const internal::Mesh_result& result)
    {
      adapter.write_cut(result.cut, edge_is_cut_map);
      adapter.write_uvs(result.chart, result.uv, halfedge_uv_map);
    },
    np);
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_UNWRAP_H
