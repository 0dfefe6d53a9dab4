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
/// how much work to spend on a short cut, and on a packing that fills the square; the value of the named parameter `effort`.
enum class Effort
{
  FAST,    ///< feature detection and connection only, unless a bound or an initial cut requires more, or the connected
           ///< cut is twice as distorted as that of the detection
  DEFAULT, ///< a small search: a few starts, the best of which is shortened; without a bound, at about the same
           ///< distortion
  BEST     ///< a large search: more starts, also combined with each other, and all that the smaller efforts find from
           ///< several seeds; the best result wins
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_EFFORT_H
