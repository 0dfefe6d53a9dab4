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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_TO_PLANE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_TO_PLANE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Reflection_plane.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/Indexed_symmetry.h>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// In terms of the caller's surface.
template <typename Adapter>
Reflection_plane to_plane(const Indexed_symmetry& symmetry, const Adapter& adapter)
{
  const Eigen::Vector3d& normal = symmetry.reflection.normal;
  return {{{normal.x(), normal.y(), normal.z()}}, adapter.to_original_scale(symmetry.reflection.offset), symmetry.matched,
          symmetry.is_exact};
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_TO_PLANE_H
