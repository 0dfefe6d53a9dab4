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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CROSS_PRODUCT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CROSS_PRODUCT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <Eigen/Core>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Eigen's own comes with its rotations, transformations and dense decompositions, which all programs would compile.
inline Eigen::Vector3d cross_product(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return Eigen::Vector3d(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x());
}

inline double determinant(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

// Twice the area of a triangle, negative if it is clockwise.
inline double doubled_area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  return determinant(b - a, c - a);
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CROSS_PRODUCT_H
