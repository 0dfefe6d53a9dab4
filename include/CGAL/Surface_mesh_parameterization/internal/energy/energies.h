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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_ENERGIES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_ENERGIES_H

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

// The conformal energy [HG00]: 0.5 |J|^2 / det J = (x + y) / (x - y), ideally 1.
struct MIPS_energy
{
  static constexpr double ideal = 1;

  static double value(double x, double y) { return (x + y) / (x - y); }

  static Energy_derivatives derivatives(double x, double y)
  {
    const double i = 1 / (x - y), i2 = 2 * i * i, i3 = i2 * i;
    return {(x + y) * i, -y * i2, x * i2, 2 * y * i3, -(x + y) * i3, 2 * x * i3};
  }
};

// The isometric energy [SS15]: |J|^2 + |J^-1|^2 = 2 (x + y) (1 + 1 / (x - y)^2),
// ideally 4.
struct Symmetric_Dirichlet_energy
{
  static constexpr double ideal = 4;

  static double value(double x, double y)
  {
    const double d = x - y;
    return 2 * (x + y) * (1 + 1 / (d * d));
  }

  static Energy_derivatives derivatives(double x, double y)
  {
    const double s = x + y, i = 1 / (x - y), i2 = i * i, i3 = i2 * i, i4 = i2 * i2;
    return {2 * s * (1 + i2),
            2 * (1 + i2) - 4 * s * i3,
            2 * (1 + i2) + 4 * s * i3,
            -8 * i3 + 12 * s * i4,
            -12 * s * i4,
            8 * i3 + 12 * s * i4};
  }
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_ENERGIES_H
