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

#ifndef CGAL_SURFACE_MESH_CUTTING_IS_CUT_TO_DISKS_H
#define CGAL_SURFACE_MESH_CUTTING_IS_CUT_TO_DISKS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/certify_cut.h>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// tells whether a surface, opened along the marked edges, consists only of topological disks.
/// The time is linear in the size of the surface.
///
/// The parameters are those of `certify_cut()`.
///
/// \return whether `certify_cut()` returns `Status_code::OK`; `false` for an unsupported mesh
template <typename TriangleMesh, typename EdgeIsCutMap,
          typename NamedParameters = parameters::Default_named_parameters>
bool is_cut_to_disks(const TriangleMesh& tmesh, EdgeIsCutMap edge_is_cut_map,
                     const NamedParameters& np = parameters::default_values())
{
  return bool(certify_cut(tmesh, edge_is_cut_map, np));
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_IS_CUT_TO_DISKS_H
