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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BOUNDING_BOX_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BOUNDING_BOX_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <Eigen/Core>

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Of the points added; inside out while there are none.
template <int Dimension>
struct Bounding_box
{
  using Vector = Eigen::Matrix<double, Dimension, 1>;

  Vector low = Vector::Constant(std::numeric_limits<double>::infinity());
  Vector high = Vector::Constant(-std::numeric_limits<double>::infinity());

  void add(const Vector& point)
  {
    for(int i = 0; i < Dimension; ++i)
    {
      low[i] = (std::min)(low[i], point[i]);
      high[i] = (std::max)(high[i], point[i]);
    }
  }

  Vector size() const { return high - low; }

  double longest_side() const
  {
    double longest = high[0] - low[0];
    for(int i = 1; i < Dimension; ++i)
      longest = (std::max)(longest, high[i] - low[i]);
    return longest;
  }

  // Moves all sides outwards.
  void grow(double margin)
  {
    for(int i = 0; i < Dimension; ++i)
    {
      low[i] -= margin;
      high[i] += margin;
    }
  }
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BOUNDING_BOX_H
