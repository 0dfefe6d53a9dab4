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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_POWER_OF_TWO_SCALE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_POWER_OF_TWO_SCALE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Bounding_box.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// The e for which the box has an extent in [1, 2) after division by 2^e; 0 for
// a point. Scaling by a power of two loses no bit, and at this scale products of lengths neither
// overflow nor underflow.
inline int scale_exponent(const Bounding_box<3>& box)
{
  // Halves, as the difference of two finite numbers may be infinite.
  double half_extent = 0;
  for(int i = 0; i < 3; ++i)
    half_extent = (std::max)(half_extent, 0.5 * box.high[i] - 0.5 * box.low[i]);
  return half_extent > 0 ? std::ilogb(half_extent) + 1 : 0;
}

// `vector` times 2^e.
template <typename Vector>
Vector scaled(Vector vector, int e)
{
  for(Eigen::Index i = 0; i < vector.size(); ++i)
    vector[i] = std::ldexp(vector[i], e);
  return vector;
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_POWER_OF_TWO_SCALE_H
