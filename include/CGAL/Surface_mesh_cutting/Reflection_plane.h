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

#ifndef CGAL_SURFACE_MESH_CUTTING_REFLECTION_PLANE_H
#define CGAL_SURFACE_MESH_CUTTING_REFLECTION_PLANE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <array>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// is a plane at which a surface is symmetric.
struct Reflection_plane
{
  std::array<double, 3> normal = {{1, 0, 0}}; ///< a unit vector, of which the largest coordinate is positive.
  double offset = 0;     ///< the scalar product of the normal with points of the plane.
  /// share of the vertices that the reflection brings within 0.4 % of the bounding box diagonal of the surface.
  double matched = 0;
  bool is_exact = false; ///< whether the reflection also maps vertices to vertices and edges to edges.
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_REFLECTION_PLANE_H
