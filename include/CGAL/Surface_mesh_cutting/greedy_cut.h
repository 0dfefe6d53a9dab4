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

#ifndef CGAL_SURFACE_MESH_CUTTING_GREEDY_CUT_H
#define CGAL_SURFACE_MESH_CUTTING_GREEDY_CUT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/Cut_result.h>
#include <CGAL/Surface_mesh_cutting/internal/run/run_pipeline.h>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// finds a short cut that leaves only topological disks, which flatten with low isometric distortion.
/// Detects feature points and connects them by a short tree \cgalCite{cgal:zycf-gccp-20}. The surface may have any
/// number of handles, borders and components; border edges are already open and never marked.
///
/// Solving sparse linear systems dominates the cost: a few dozen for the candidates, and one or two for each
/// candidate that small windows do not decide. With \f$ n \f$ vertices, a system takes \f$ O(n^{1.5}) \f$ time
/// and \f$ O(n \log n) \f$ memory on usual meshes. Large surfaces get their feature points on a coarser version, see
/// `coarse_number_of_faces`; then only a few systems have the size of the surface. Connecting the feature points takes
/// memory linear in the size of the surface for each of them; `maximum_number_of_states` bounds the search for a
/// shortest tree.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithms: `Sequential_tag` (default),
///         `Parallel_tag`, or `Parallel_if_available_tag`. The result does not depend on it.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsCutMap a model of `WritablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface; it is not modified
/// \param edge_is_cut_map receives `true` or `false` for each edge if `Cut_result::has_result`, and stays unchanged
///        otherwise. See `make_seam_mesh()`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \copydetails PkgSurfaceMeshCuttingQualityParameters
/// \copydetails PkgSurfaceMeshCuttingConstraintParameters
/// \copydetails PkgSurfaceMeshCuttingFeatureParameters
/// \copydetails PkgSurfaceMeshCuttingConnectionParameters
/// \copydetails PkgSurfaceMeshCuttingRunParameters
///
/// \return the length of the cut, its feature points, and more. Its `status` is one of
/// - `Status_code::OK`;
/// - `Status_code::BOUND_NOT_REACHED` if no cut was found that keeps the bounds on the distortion, with the faces above those on faces
///   and charts, or, with `Connection::EXACT`, if the budget does not suffice for a proof;
/// - `Status_code::EMPTY_MESH`, `Status_code::NOT_TRIANGULATED`, `Status_code::NON_MANIFOLD` or
///   `Status_code::INVALID_POINT` for an unsupported mesh;
/// - `Status_code::WRONG_PARAMETER`, with the edges of invalid weight if there are any;
/// - `Status_code::INFEASIBLE_CONSTRAINTS`, with the edges or vertices in conflict;
/// - `Status_code::NUMERICAL_FAILURE`;
/// - `Status_code::STOPPED`.
///
/// \sa `unwrap()`
/// \sa `detect_feature_points()`
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename EdgeIsCutMap,
          typename NamedParameters = parameters::Default_named_parameters>
Cut_result<TriangleMesh> greedy_cut(const TriangleMesh& tmesh, EdgeIsCutMap edge_is_cut_map,
                                    const NamedParameters& np = parameters::default_values())
{
  return internal::run_pipeline<ConcurrencyTag, Cut_result<TriangleMesh> >(
    tmesh, internal::Output_kind::CUT,
    [&](const auto& adapter, const internal::Mesh_result& result) { adapter.write_cut(result.cut, edge_is_cut_map); },
    np);
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_GREEDY_CUT_H
