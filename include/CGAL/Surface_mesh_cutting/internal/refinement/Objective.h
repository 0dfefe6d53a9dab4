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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_OBJECTIVE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_OBJECTIVE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Cutting_parameters.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The quantity that all stages minimize. Without a bound, it is the energy above the ideal plus `energy_per_cost` times the
// cost of the cut. With a bound, it is the cost that a cut is expected to have once its energy has been brought to the bound:
// the excess above the ideal falls with a power of the length, which is three on average and learned from the cuts that
// are taken. Below the bound, the power is raised, so that spare distortion is spent on length.
class Objective
{
  static constexpr double ideal = Surface_mesh_parameterization::internal::Symmetric_Dirichlet_energy::ideal;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  // `bound` on the area-averaged energy, infinite without a bound.
  Objective(double bound, double energy_per_cost) : m_bound(bound), m_energy_per_cost(energy_per_cost) {}
  explicit Objective(const Cutting_parameters& parameters)
    : Objective(parameters.maximum_average_distortion, parameters.decrease_per_cost)
  {}

  bool has_bound() const { return m_bound < infinity; }
  double bound() const { return m_bound; }
  double energy_per_cost() const { return m_energy_per_cost; }
  // False if the energy is not a number.
  bool keeps_bound(double energy) const { return energy <= m_bound; }

  // Call before cuts are compared with one of this energy.
  void compare_with(double energy)
  {
    constexpr double pull = 6, least = 1, largest = 30;
    if(has_bound())
      m_power = between(least, m_usual_power * std::exp(pull * room(energy)), largest);
  }

  // The smaller, the better.
  double operator()(double cost, double energy) const
  {
    return has_bound() ? cost * std::pow((std::max)(0., 1 - room(energy)), 1 / m_power)
                       : energy - ideal + m_energy_per_cost * cost;
  }

  // Whether a cut is so near to the bound that its cost there can be predicted.
  bool can_tell(double energy) const
  {
    constexpr double largest_excess = 0.15;
    return !has_bound() || room(energy) > -largest_excess;
  }

  // Whether a cut would have to become so much longer that the bound is most likely out of reach.
  bool is_far(double cost, double energy) const
  {
    constexpr double much_longer = 6;
    return has_bound() && !((*this)(cost, energy) <= much_longer * cost);
  }

  // Learns from a cut that was taken.
  void adapt(double energy)
  {
    constexpr double least = 1.5, largest = 12;
    if(has_bound())
      m_usual_power = between(least, m_usual_power * std::exp(room(energy)), largest);
  }

  // The most energy that a cut may have in exchange for `saved` cost. A cut that misses the bound may not get worse.
  double largest_energy(double energy, double saved) const
  {
    return has_bound() ? (std::max)(m_bound, energy) : energy + m_energy_per_cost * saved;
  }

  // Least gain of energy per cost for which a slit is opened.
  double least_gain_per_cost() const { return has_bound() ? 0 : m_energy_per_cost; }

  // Orders final cuts: first by what exceeds the bound, then by cost, or by the sum without a bound.
  std::pair<double, double> rank(double cost, double energy) const
  {
    if(!has_bound())
      return {std::isfinite(energy) ? 0 : infinity, (*this)(cost, energy)};
    const double excess = keeps_bound(energy) ? 0 : energy > m_bound ? energy - m_bound : infinity;
    return {excess, cost};
  }

private:
  // Energy left below the bound, relative to what the bound allows above the ideal; negative above the bound.
  double room(double energy) const { return (m_bound - energy) / (m_bound - ideal); }

  static double between(double least, double value, double largest)
  {
    return (std::min)((std::max)(least, value), largest);
  }

  double m_bound, m_energy_per_cost;
  double m_usual_power = 3;
  double m_power = m_usual_power;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_OBJECTIVE_H
