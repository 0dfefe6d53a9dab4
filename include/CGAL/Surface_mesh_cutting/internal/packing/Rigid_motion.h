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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_RIGID_MOTION_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_RIGID_MOTION_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <Eigen/Core>

#include <cmath>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Turns about the origin, then translates.
class Rigid_motion
{
public:
  Rigid_motion() : Rigid_motion(0, 1, 0, Eigen::Vector2d::Zero()) {}

  // `direction`: of length 1, where that of the x-axis is turned to.
  Rigid_motion(const Eigen::Vector2d& direction, const Eigen::Vector2d& translation)
    : Rigid_motion(std::atan2(direction.y(), direction.x()), direction.x(), direction.y(), translation)
  {}

  Rigid_motion(double angle, const Eigen::Vector2d& translation)
    : Rigid_motion(angle, std::cos(angle), std::sin(angle), translation)
  {}

  double angle() const { return m_angle; }
  const Eigen::Vector2d& translation() const { return m_translation; }

  Eigen::Vector2d turned(const Eigen::Vector2d& v) const
  { return {m_cosine * v.x() - m_sine * v.y(), m_sine * v.x() + m_cosine * v.y()}; }

  Eigen::Vector2d turned_back(const Eigen::Vector2d& v) const
  { return {m_cosine * v.x() + m_sine * v.y(), m_cosine * v.y() - m_sine * v.x()}; }

  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const { return turned(p) + m_translation; }

  Eigen::Vector2d undone(const Eigen::Vector2d& p) const { return turned_back(p - m_translation); }

  // This motion, followed by the inverse of the other one.
  Rigid_motion relative_to(const Rigid_motion& other) const
  {
    return Rigid_motion(m_angle - other.m_angle, m_cosine * other.m_cosine + m_sine * other.m_sine,
                        m_sine * other.m_cosine - m_cosine * other.m_sine,
                        other.turned_back(m_translation - other.m_translation));
  }

private:
  Rigid_motion(double angle, double cosine, double sine, const Eigen::Vector2d& translation)
    : m_angle(angle), m_cosine(cosine), m_sine(sine), m_translation(translation)
  {}

  double m_angle, m_cosine, m_sine;
  Eigen::Vector2d m_translation;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_RIGID_MOTION_H
