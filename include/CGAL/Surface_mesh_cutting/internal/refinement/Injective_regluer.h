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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_INJECTIVE_REGLUER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_INJECTIVE_REGLUER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/connection/Initial_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/final_map.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Chart_regluing.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Cut_refiner.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Injective_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Length_at_bound.h>

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Lets the parts of a chart lie elsewhere where they are in each other's way, see `Chart_regluing`, for maps without overlaps.
template <typename ConcurrencyTag>
class Injective_regluer
{
  using Refiner = Cut_refiner<ConcurrencyTag>;

public:
  // The references to the problem and to what the context holds are kept.
  Injective_regluer(const Problem& problem, const Context& context) : m_problem(problem), m_context(context) {}

  // Takes another arrangement if that is likely to cost less at an energy of `goal`. `overlapping`: the best map of the cut
  // that may overlap.
  void reglue(const Open_chart& overlapping, double goal, Injective_cut& cut) const
  {
    constexpr double costs_of_overlap[] = {1, 0.3}; // both happen; where little is asked for, less is moved
    Cut former;
    for(double cost_of_overlap : costs_of_overlap)
    {
      const Cut rearranged = Chart_regluing(m_problem, overlapping, cost_of_overlap).cut();
      if(rearranged == overlapping.cut || rearranged == former || !m_context.control.go_further())
        continue;
      former = rearranged;
      Refiner refiner(m_problem, m_context);
      if(!refiner.start(ends_and_forks(m_problem.mesh, rearranged), rearranged))
        continue;
      const double energy = take_if_better(refiner, goal, cut);
      if(m_context.parameters.has_bound() && energy < std::numeric_limits<double>::infinity())
      {
        shorten(energy, goal, refiner);
        take_if_better(refiner, goal, cut);
      }
    }
  }

private:
  // Returns the energy of the map without overlaps.
  double take_if_better(const Refiner& refiner, double goal, Injective_cut& cut) const
  {
    Injective_cut other;
    const Newton_result newton = final_map(m_problem, refiner.cut().chart(), m_context, other.map.uv);
    if(newton.outcome == Newton_outcome::FAILED)
      return std::numeric_limits<double>::infinity();
    other.map.energy = newton.energy;
    const Length_at_bound length(goal);
    if(length(refiner.cut().cost(), newton.energy) < length(cut_cost(m_problem.constraints, cut.cut), cut.map.energy))
    {
      other.cut = refiner.cut().cut();
      other.chart = refiner.cut().chart().chart;
      other.ends = refiner.cut().features();
      cut = std::move(other);
    }
    return newton.energy;
  }

  // As if the map without overlaps stayed as much above the other one as it is.
  void shorten(double energy, double goal, Refiner& refiner) const
  {
    constexpr int number_of_solves = 20;
    Refinement_limits limits;
    limits.number_of_solves = number_of_solves;
    limits.energy = goal - (std::max)(0., energy - refiner.cut().energy());
    refiner.reduce_distortion_to(limits.energy);
    refiner.shorten(limits);
  }

  const Problem& m_problem;
  const Context m_context;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_INJECTIVE_REGLUER_H
