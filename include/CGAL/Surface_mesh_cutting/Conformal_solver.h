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

#ifndef CGAL_SURFACE_MESH_CUTTING_CONFORMAL_SOLVER_H
#define CGAL_SURFACE_MESH_CUTTING_CONFORMAL_SOLVER_H

#include <CGAL/license/Surface_mesh_cutting.h>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// how to compute the conformal maps that yield the candidates for feature points; the value of the
/// named parameter `conformal_solver`.
enum class Conformal_solver
{
  KP_NEWTON, ///< minimizes the MIPS energy, as in the paper
  SPECTRAL   ///< spectral conformal parameterization, repaired where it flips triangles; a single factorization
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_CONFORMAL_SOLVER_H
