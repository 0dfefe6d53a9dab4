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

#ifndef CGAL_SURFACE_MESH_CUTTING_EFFORT_H
#define CGAL_SURFACE_MESH_CUTTING_EFFORT_H

#include <CGAL/license/Surface_mesh_cutting.h>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// how much work to spend on a short cut, or on a packing that fills the square; the value of the named parameter `effort`.
enum class Effort
{
  FAST,    ///< one start, whose cut is improved a little
  DEFAULT, ///< a few starts, the best of which are improved further
  BEST     ///< many starts, and all of the smaller efforts; the best result wins, and is then straightened
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_EFFORT_H
