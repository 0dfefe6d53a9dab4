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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_FLAP_MOTION_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_FLAP_MOTION_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A motion of the plane that keeps distances.
struct Flap_motion
{
  double cosine = 1, sine = 0;
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();

  Eigen::Vector2d turned(const Eigen::Vector2d& p) const
  { return {cosine * p.x() - sine * p.y(), sine * p.x() + cosine * p.y()}; }

  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const { return turned(p) + shift; }

  Eigen::Vector2d undone(const Eigen::Vector2d& p) const
  {
    const Eigen::Vector2d q = p - shift;
    return {cosine * q.x() + sine * q.y(), cosine * q.y() - sine * q.x()};
  }
};

// The one that brings points nearest to others, in the sum of squares.
inline Flap_motion best_motion(const std::vector<Eigen::Vector2d>& from, const std::vector<Eigen::Vector2d>& to)
{
  Eigen::Vector2d p = Eigen::Vector2d::Zero(), q = Eigen::Vector2d::Zero();
  for(std::size_t i = 0; i < from.size(); ++i)
  {
    p += from[i] / double(from.size());
    q += to[i] / double(from.size());
  }
  Flap_motion motion;
  double cosine = 0, sine = 0;
  for(std::size_t i = 0; i < from.size(); ++i)
  {
    const Eigen::Vector2d u = from[i] - p, v = to[i] - q;
    cosine += u.dot(v);
    sine += u.x() * v.y() - u.y() * v.x();
  }
  const double norm = std::hypot(cosine, sine);
  if(norm > 0)
  {
    motion.cosine = cosine / norm;
    motion.sine = sine / norm;
  }
  motion.shift = q - motion.turned(p);
  return motion;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_FLAP_MOTION_H
