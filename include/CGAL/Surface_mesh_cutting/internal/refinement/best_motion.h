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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_BEST_MOTION_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_BEST_MOTION_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/mapping/Rigid_motion.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The motion that brings points nearest to others, in the sum of squares.
inline Rigid_motion best_motion(const std::vector<Eigen::Vector2d>& from, const std::vector<Eigen::Vector2d>& to)
{
  Eigen::Vector2d p = Eigen::Vector2d::Zero(), q = Eigen::Vector2d::Zero();
  for(std::size_t i = 0; i < from.size(); ++i)
  {
    p += from[i] / double(from.size());
    q += to[i] / double(from.size());
  }
  double cosine = 0, sine = 0;
  for(std::size_t i = 0; i < from.size(); ++i)
  {
    const Eigen::Vector2d u = from[i] - p, v = to[i] - q;
    cosine += u.dot(v);
    sine += u.x() * v.y() - u.y() * v.x();
  }
  const double norm = std::hypot(cosine, sine);
  const Eigen::Vector2d direction = norm > 0 ? Eigen::Vector2d(cosine / norm, sine / norm) : Eigen::Vector2d(1, 0);
  return Rigid_motion(direction, q - Rigid_motion(direction, Eigen::Vector2d::Zero()).turned(p));
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_BEST_MOTION_H
