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

#ifndef CGAL_SURFACE_MESH_CUTTING_DETECT_FEATURE_POINTS_H
#define CGAL_SURFACE_MESH_CUTTING_DETECT_FEATURE_POINTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/Cut_result.h>
#include <CGAL/Surface_mesh_cutting/internal/run/run_pipeline.h>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// finds the points that a cut must reach so that the surface flattens with low isometric distortion.
/// They are local maximizers of the distortion of a conformal map, filtered greedily by their gains
/// \cgalCite{cgal:zycf-gccp-20} (Section 3.1).
///
/// Solving sparse linear systems dominates the cost: a few dozen for the candidates, and one or two for each
/// candidate that small windows do not decide. With \f$ n \f$ vertices, a system takes \f$ O(n^{1.5}) \f$ time
/// and \f$ O(n \log n) \f$ memory on usual meshes. Large surfaces get their feature points on a coarser version, see
/// `coarse_number_of_faces`; then \f$ n \f$ is bounded.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithms: `Sequential_tag` (default),
///         `Parallel_tag`, or `Parallel_if_available_tag`. The result does not depend on it.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam VertexOutputIterator a model of `OutputIterator` that accepts
///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface; it is not modified
/// \param out receives the feature points, ordered by their position in `vertices(tmesh)`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// The function improves no cut, so that `effort` and `maximum_average_distortion` have no effect. The connection matters
/// only if the surface has handles or borders: a tree opens it before candidates are judged.
///
/// \copydetails PkgSurfaceMeshCuttingConnectionParameters
/// \copydetails PkgSurfaceMeshCuttingConstraintParameters
/// \copydetails PkgSurfaceMeshCuttingFeatureParameters
/// \copydetails PkgSurfaceMeshCuttingRunParameters
///
/// \return the numbers of candidates and feature points; the members about the cut are not set. Its `status` is
///         `Status_code::OK` or an error of `greedy_cut()`. After an error, nothing is written to `out`.
///
/// \sa `greedy_cut()`
/// \sa `connect_points()`
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename VertexOutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
Cut_result<TriangleMesh> detect_feature_points(const TriangleMesh& tmesh, VertexOutputIterator out,
                                               const NamedParameters& np = parameters::default_values())
{
  const Cut_result<TriangleMesh> result
    = internal::run_pipeline<ConcurrencyTag, Cut_result<TriangleMesh> >(tmesh, internal::Output_kind::FEATURES,
                                                                        internal::Ignore_result(), np);
  if(result)
    for(auto v : result.feature_points)
      *out++ = v;
  return result;
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_DETECT_FEATURE_POINTS_H
