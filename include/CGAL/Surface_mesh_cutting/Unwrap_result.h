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

#ifndef CGAL_SURFACE_MESH_CUTTING_UNWRAP_RESULT_H
#define CGAL_SURFACE_MESH_CUTTING_UNWRAP_RESULT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Cut_result.h>

#include <optional>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// is the result of `unwrap()`, besides the cut and the UVs.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
template <typename TriangleMesh>
struct Unwrap_result : public Cut_result<TriangleMesh>
{
  /// area-averaged symmetric Dirichlet energy of the UVs as the map holds them; 4 is ideal. Faces without area do not
  /// count. Faces with nearly no area are mapped as if they were thicker, but measured as they are.
  double average_distortion = 0;
  double largest_face_distortion = 0; ///< largest symmetric Dirichlet energy of a face that has an area.
  /// number of faces not strictly counterclockwise, decided exactly; 0 if there is a result.
  int flips = 0;
  /// number of overlaps, decided exactly; empty without `do_bijective`, and 0 if there is a result.
  std::optional<int> overlaps;
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_UNWRAP_RESULT_H
