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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_IS_FINITE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_IS_FINITE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <Eigen/Core>

#include <cmath>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

inline bool is_finite(const Eigen::Vector2d& p)
{
  return std::isfinite(p.x()) && std::isfinite(p.y());
}

inline bool is_finite(const Eigen::Vector3d& p)
{
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_IS_FINITE_H
