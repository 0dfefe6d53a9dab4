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

#ifndef CGAL_SURFACE_MESH_CUTTING_SYMMETRY_H
#define CGAL_SURFACE_MESH_CUTTING_SYMMETRY_H

#include <CGAL/license/Surface_mesh_cutting.h>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// tells at which plane a surface is mirrored.
enum class Symmetry
{
  NONE = 0,  ///< at none.
  AUTOMATIC, ///< at the best plane that there is.
  X,         ///< at a plane with normal \f$ (1, 0, 0) \f$; it need not pass through the origin.
  Y,         ///< at a plane with normal \f$ (0, 1, 0) \f$.
  Z          ///< at a plane with normal \f$ (0, 0, 1) \f$.
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_SYMMETRY_H
