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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_ENERGY_DERIVATIVES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_ENERGY_DERIVATIVES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Value and derivatives of an energy of the two numbers x = |f_z|^2 and y = |f_z̄|^2 of an affine
// map; the determinant is x - y, the squared Frobenius norm 2 (x + y).
struct Energy_derivatives
{
  double value, x, y, xx, xy, yy;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_ENERGY_DERIVATIVES_H
