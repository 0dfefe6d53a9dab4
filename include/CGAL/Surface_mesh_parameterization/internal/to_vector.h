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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_TO_VECTOR_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_TO_VECTOR_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// The coordinates of a point of any kernel, rounded to `double`.
template <typename Point_2>
Eigen::Vector2d to_vector_2(const Point_2& p)
{
  return Eigen::Vector2d(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
}

template <typename Point_3>
Eigen::Vector3d to_vector_3(const Point_3& p)
{
  return Eigen::Vector3d(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_TO_VECTOR_H
