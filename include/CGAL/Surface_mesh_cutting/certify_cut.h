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

#ifndef CGAL_SURFACE_MESH_CUTTING_CERTIFY_CUT_H
#define CGAL_SURFACE_MESH_CUTTING_CERTIFY_CUT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/internal/result/check_disks.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/Result_status.h>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// proves that a surface, opened along the marked edges, consists only of topological disks, or names a part that
/// is not a disk. The time is linear in the size of the surface.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsCutMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value
///         type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface
/// \param edge_is_cut_map marks the edges of the cut; marks on border edges are ignored
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
/// \cgalNamedParamsEnd
///
/// \return `Status_code::OK`; or `Status_code::NOT_CUT_TO_DISKS`, with all faces of one part that is
///         not a disk; or, for an unsupported mesh, `Status_code::EMPTY_MESH`,
///         `Status_code::NOT_TRIANGULATED`, `Status_code::NON_MANIFOLD` or
///         `Status_code::INVALID_POINT`.
///
/// \sa `is_cut_to_disks()`
/// \sa `certify_unwrap()`
template <typename TriangleMesh, typename EdgeIsCutMap,
          typename NamedParameters = parameters::Default_named_parameters>
Result_status<TriangleMesh> certify_cut(const TriangleMesh& tmesh, EdgeIsCutMap edge_is_cut_map,
                                        const NamedParameters& np = parameters::default_values())
{
  const auto adapter = internal::make_mesh_adapter(tmesh, np);

  internal::Indexed_status status = adapter.status();
  if(!status)
    return adapter.translate(status);
  const internal::Cut cut = adapter.read_cut(edge_is_cut_map);
  status.finding = internal::check_disks(internal::make_chart(adapter.mesh(), cut)).finding;
  return adapter.translate(status);
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_CERTIFY_CUT_H
