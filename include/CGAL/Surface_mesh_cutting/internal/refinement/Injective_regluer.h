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

#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/final_map.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Chart_regluing.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Cut_refiner.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Injective_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Objective.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Lets the parts of a chart lie elsewhere where they are in each other's way, see `Chart_regluing`, for maps without overlaps.
class Injective_regluer
{
  static constexpr double ideal = Symmetric_Dirichlet_energy::ideal;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  // The references to the problem and to what the context holds are kept. Maps without overlaps that come to an energy of
  // `hopeless` on the way are given up.
  Injective_regluer(const Problem& problem, const Context& context, double hopeless)
    : m_problem(problem), m_context(context), m_hopeless(hopeless)
  {}

  // Takes another arrangement into `cut` if that is likely to cost less at an energy of `goal`, and returns its best map that
  // may overlap; none if all stays. `overlapping`: that of the given cut. `shortens`: whether each is tried shortened as well,
  // which takes longer than all else. Cuts that are mapped are added to `seen`.
  std::optional<Open_chart> reglue(const Open_chart& overlapping, double goal, bool shortens, Injective_cut& cut,
                                   std::vector<Trade_off>& seen) const
  {
    constexpr double costs_of_overlap[] = {1, 0.3}; // both happen; where little is asked for, less is moved
    std::optional<Open_chart> result;
    if(!m_context.control.go_further())
      return result;
    const Chart_regluing regluing(m_problem, overlapping);
    Cut former = overlapping.cut;
    for(double cost_of_overlap : costs_of_overlap)
    {
      Cut rearranged = regluing.rearranged(cost_of_overlap, m_context.control).cut;
      if(rearranged == overlapping.cut || rearranged == former || !m_context.control.go_further())
        continue;
      Cut_refiner refiner(m_problem, m_context);
      if(refiner.start(rearranged))
        try_cut(refiner, goal, shortens, cut, result);
      seen.insert(seen.end(), refiner.cut().trade_offs().begin(), refiner.cut().trade_offs().end());
      former = std::move(rearranged);
    }
    return result;
  }

private:
  void try_cut(Cut_refiner& refiner, double goal, bool shortens, Injective_cut& cut, std::optional<Open_chart>& overlapping) const
  {
    const double energy = take_if_better(refiner, cut, overlapping);
    if(shortens && shorten(energy, goal, refiner))
      take_if_better(refiner, cut, overlapping);
  }

  // Returns the energy of the map without overlaps.
  double take_if_better(const Cut_refiner& refiner, Injective_cut& cut, std::optional<Open_chart>& overlapping) const
  {
    Injective_cut other;
    const Open_chart& running = refiner.cut().chart();
    const Newton_result newton = final_map(m_problem, running, m_context, other.map.uv, m_hopeless);
    if(newton.outcome == Newton_outcome::FAILED)
      return infinity;
    other.map.energy = newton.energy;
    const Objective objective(m_context.parameters);
    if(objective(refiner.cut().cost(), newton.energy) < objective(cut_cost(m_problem.constraints, cut.cut), cut.map.energy))
    {
      other.cut = refiner.cut().cut();
      other.chart = running.chart;
      other.ends = refiner.cut().features();
      cut = std::move(other);
      overlapping = running;
    }
    return newton.energy;
  }

  // As if the map without overlaps stayed as much above the other one as it is. False if that comes to nothing: where it is
  // too far above the goal, longer cuts would make room by chance only; and what takes many slits is no better than the given
  // cut with slits.
  bool shorten(double energy, double goal, Cut_refiner& refiner) const
  {
    constexpr int enough_solves = 20;
    const double gap = (std::max)(0., energy - refiner.cut().energy());
    const int solves = (std::min)(enough_solves, enough_solves_of_whole());
    if(gap >= goal - ideal || solves == 0)
      return false;
    const Objective objective((std::max)(goal - gap, (goal + ideal) / 2), 0);
    if(!refiner.open_slits(objective, enough_solves_of_whole()))
      return false;
    refiner.shorten({objective}, solves);
    return true;
  }

  // Of the whole surface: fewer on large ones, and none on the largest.
  int enough_solves_of_whole() const
  {
    constexpr int enough_solved_faces = 1000000;
    return enough_solved_faces / m_problem.mesh.number_of_faces();
  }

  const Problem& m_problem;
  const Context m_context;
  const double m_hopeless;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_INJECTIVE_REGLUER_H
