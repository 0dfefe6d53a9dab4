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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_MIPS_ENERGY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_MIPS_ENERGY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/Energy_derivatives.h>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

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

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_ENERGY_MIPS_ENERGY_H
