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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_LENGTH_AT_BOUND_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_LENGTH_AT_BOUND_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/energies.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// What a cut is likely to cost once it has been brought to a bound of the energy: the excess of the energy above the
// ideal falls with a power of the length. On average that is the third; how much a surface gives for length shows
// while its cut is worked on. The power also keeps cuts near the bound, since it is larger, and length counts more,
// as long as the bound leaves room.
class Length_at_bound
{
  static constexpr double ideal = Surface_mesh_parameterization::internal::Symmetric_Dirichlet_energy::ideal;

public:
  explicit Length_at_bound(double bound) : m_bound(bound) {}

  // Call before cuts are compared with one of this energy.
  void compare_with(double energy)
  {
    constexpr double pull = 6, least = 1, largest = 30;
    m_power = between(least, m_usual_power * std::exp(pull * room(energy)), largest);
  }

  double operator()(double cost, double energy) const
  {
    return cost * std::pow((std::max)(0., 1 - room(energy)), 1 / m_power);
  }

  // Whether a cut is so near to the bound that what it costs there can be told.
  bool can_tell(double energy) const
  {
    constexpr double largest_excess = 0.15;
    return room(energy) > -largest_excess;
  }

  // Learns from a cut that was taken.
  void adapt(double energy)
  {
    constexpr double least = 1.5, largest = 12;
    m_usual_power = between(least, m_usual_power * std::exp(room(energy)), largest);
  }

private:
  // What the bound leaves, relative to its excess above the ideal; negative above the bound.
  double room(double energy) const { return (m_bound - energy) / (m_bound - ideal); }

  static double between(double least, double value, double largest)
  {
    return (std::min)((std::max)(least, value), largest);
  }

  double m_bound;
  double m_usual_power = 3;
  double m_power = m_usual_power;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_LENGTH_AT_BOUND_H
