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

#include <array>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// is the symmetric Dirichlet energy of the faces of a chart, at the scale of the whole layout.
struct Chart_distortion
{
  double average = 0; ///< over the area.
  double largest = 0; ///< of a face that has an area.
  int number_of_faces = 0;
};

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
  /// pairs of a share of the area, 0.5, 0.9, 0.99, 0.999 and 1, and the least energy that the faces of so much area do not exceed.
  std::vector<std::array<double, 2> > distortion_quantiles;
  std::vector<Chart_distortion> charts; ///< in the order of their first faces.
  /// number of faces not strictly counterclockwise, decided exactly; 0 if there is a result.
  int flips = 0;
  /// number of overlaps, decided exactly; empty without `do_bijective`, and 0 if there is a result.
  std::optional<int> overlaps;
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_UNWRAP_RESULT_H
