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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_ROOM_SEARCH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_ROOM_SEARCH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/refinement/Cut_refiner.h>
#include <CGAL/Surface_mesh_cutting/internal/result/Component_result.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Cut_parameterizer.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A map without overlaps may miss a bound that the map with overlaps keeps; then the cut has to make room. Parts that are in
// each other's way are glued elsewhere, slits let them turn aside, seams divide several charts; and since cuts of about the
// same length can be rearranged to charts that need far more room or far less, longer ones are rearranged as well.
class Room_search
{
  static constexpr double ideal = Symmetric_Dirichlet_energy::ideal, infinity = std::numeric_limits<double>::infinity();
  static constexpr double share_before_longer_cuts = 0.5; // of the work for room, to show
  static constexpr double little = 0.02, much = 0.1;      // of the cost

public:
  // The references are kept. `moves_ends`: whether the ends of cuts that have room are moved.
  Room_search(const Problem& problem, const Context& context, const Cut_parameterizer& parameterizer,
              bool moves_ends)
    : m_problem(problem), m_context(context), m_parameters(context.parameters), m_parameterizer(parameterizer),
      m_bound(m_parameters.maximum_average_distortion), m_objective(m_parameters), m_moves_ends(moves_ends)
  {}

  // `result`: the map without overlaps of the refiner's cut.
  void operator()(const Cut_refiner& refiner, Component_result& result) const
  {
    if(!m_parameters.has_bound() || !m_parameters.do_bijective || !(result.energy > m_bound) || // nor if it is not a number
       !m_context.control.go_further())
      return;
    const double cost_with_overlaps = result.cost;
    Crowded given = {result, refiner.cut().chart()};
    given.result.trade_offs.clear();
    std::optional<Component_result> with_slits = slits_of_near_cut(given);
    if(with_slits && keeps_bound(*with_slits) && with_slits->cost <= (1 + little) * cost_with_overlaps)
      take_better(std::move(*with_slits), result);
    else
      make_room(refiner, std::move(given), std::move(with_slits), result);
    result.cost_of_room = result.cost - cost_with_overlaps;
  }

private:
  // A map without overlaps that has too little room, and the best one of the same cut that may overlap.
  struct Crowded
  {
    Component_result result;
    Open_chart overlapping;
  };

  // Near the bound, slits alone may cost little; then no other arrangement is tried. None if it is not near.
  std::optional<Component_result> slits_of_near_cut(const Crowded& given) const
  {
    constexpr double near = 0.1; // above the bound, relative to what that leaves above the ideal
    if(!given.result.has_map || given.result.energy - m_bound > near * (m_bound - ideal))
      return std::nullopt;
    Component_result with_slits = given.result;
    open_slits(given, with_slits);
    return with_slits;
  }

  // `with_slits`: the given cut with slits, if they were tried.
  void make_room(const Cut_refiner& refiner, Crowded given, std::optional<Component_result> with_slits,
                 Component_result& result) const
  {
    std::vector<Crowded> crowded;
    crowded.push_back(std::move(given));
    const double enough_cost = (1 + little) * result.cost, high_cost = (1 + much) * result.cost;
    const auto costs_more_than = [&](double cost) { return !keeps_bound(result) || result.cost > cost; };
    if(auto overlapping = reglue(crowded[0].overlapping, true, result))
      crowded.push_back({result, std::move(*overlapping)});
    const bool is_rearranged = crowded.size() > 1;
    if(with_slits)
      take_better(std::move(*with_slits), result); // whether they were tried is still known
    if(is_rearranged || (m_parameters.opens_slits_first() && !with_slits))
      open_slits(crowded.back(), result);
    m_context.control.report(Phase::PARAMETERIZE, share_before_longer_cuts);
    if(!costs_more_than(enough_cost))
      return;
    const bool needs_seams = !keeps_bound(result); // so that it is known what longer cuts must not cost
    if(needs_seams)
      divide(crowded, result);
    Component_result longer = lengthened(refiner, crowded, keeps_bound(result) ? result.cost : infinity);
    take_better(longer, result);
    if(!needs_seams && costs_more_than(high_cost))
      divide(crowded, result);
    if(is_rearranged && m_parameters.opens_slits_first() && !with_slits && costs_more_than(high_cost))
      open_slits(crowded[0], result);
    if(keeps_bound(result))
      return;
    // Slits for what its own map with overlaps has no room for were not enough: now those for what is above that of the shorter
    // cut, which lower the distortion as well.
    relieve(refiner.cut().chart(), longer);
    take_better(std::move(longer), result);
  }

  bool keeps_bound(const Component_result& result) const { return result.has_map && result.energy <= m_bound; }

  void take_better(Component_result other, Component_result& result) const
  {
    const auto rank = [this](const Component_result& r) { return m_objective.rank(r.cost, r.has_map ? r.energy : infinity); };
    if(rank(other) < rank(result))
      std::swap(other, result);
    result.add(other.trade_offs);
  }

  std::optional<Open_chart> reglue(const Open_chart& overlapping, bool shortens, Component_result& result) const
  {
    const Phase_clock::Measurement measurement(m_context.clock, Phase::PARAMETERIZE);
    return m_parameterizer.reglue(overlapping, m_bound, shortens, result);
  }

  void relieve(const Open_chart& overlapping, Component_result& result) const
  {
    const Phase_clock::Measurement measurement(m_context.clock, Phase::PARAMETERIZE);
    m_parameterizer.relieve(overlapping, m_bound, result);
  }

  // The effort decides whether the cut is shortened after slits.
  void open_slits(const Crowded& crowded, Component_result& result) const
  {
    Component_result relieved = crowded.result;
    relieve(crowded.overlapping, relieved);
    if(keeps_bound(relieved) && m_parameters.opens_slits_first())
      shorten(relieved);
    if(keeps_bound(relieved))
      take_better(std::move(relieved), result);
  }

  // Slits gain in whole paths, and other branches contribute less then. Several charts stay as they are.
  void shorten(Component_result& result) const
  {
    if(result.chart.border_loops().size() > 1)
      return;
    const Phase_clock::Measurement measurement(m_context.clock, Phase::PARAMETERIZE);
    m_parameterizer.trim(m_bound, result);
    if(m_moves_ends && m_parameterizer.move_ends_and_ways(m_bound, result))
      m_parameterizer.trim(m_bound, result); // that may have left some room below the bound
  }

  void divide(const std::vector<Crowded>& crowded, Component_result& result) const
  {
    const Phase_clock::Measurement measurement(m_context.clock, Phase::PARAMETERIZE);
    for(const Crowded& c : crowded)
    {
      Component_result divided = c.result;
      if(c.overlapping.energy <= m_bound && m_context.control.go_further() &&
         m_parameterizer.divide(c.overlapping, m_bound, divided))
        take_better(std::move(divided), result);
    }
  }

  // The cheapest of longer cuts whose bijective maps, rearranged, keep the bound: bisection over what is asked of the map with
  // overlaps, between what failed and what did not. At first that is lowered by half of what is missing: a longer cut lowers
  // the energy of the map without overlaps, too. Cuts that cost as much as `limit` are not mapped. If none keeps the bound, the
  // one nearest to it.
  Component_result lengthened(const Cut_refiner& start, const std::vector<Crowded>& crowded,
                              double limit) const
  {
    constexpr int maximum_number_of_rounds = 6, solves = 10;
    // In maps of longer cuts. As long as nothing is known to be enough, about twenty seconds, after which none has been seen to
    // keep the bound; with what is known, they become hardly shorter.
    constexpr double maximum_number_of_solved_faces = 5e6, enough_solved_faces = 1e7;
    const auto seen_before = std::ptrdiff_t(start.cut().trade_offs().size());
    double number_of_solved_faces = 0;
    // Of what the bound leaves above the ideal: how precisely the target is found, and the shortest step to it.
    constexpr double relative_precision = 0.02, shortest_step = 0.1;
    const double excess = m_bound - ideal;
    // Down by what is missing, and not by more than half of what is left.
    const auto lowered = [&](double former, double by)
    { return (std::max)(former - (std::max)(by, shortest_step * excess), (former + ideal) / 2); };
    Component_result best = crowded[0].result;
    double failed = m_bound, kept = ideal, target = lowered(m_bound, (crowded.back().result.energy - m_bound) / 2);
    for(int round = 0; round < maximum_number_of_rounds && failed - kept > relative_precision * excess &&
                       m_context.control.go_further(); ++round)
    {
      if(number_of_solved_faces > (kept == ideal ? maximum_number_of_solved_faces : enough_solved_faces))
        break;
      Cut_refiner refiner = start;
      lower(refiner, {Objective(target, 0), solves});
      const std::vector<Trade_off>& all = refiner.cut().trade_offs();
      number_of_solved_faces += double(all.size() - seen_before) * m_problem.mesh.number_of_faces();
      best.add({all.begin() + seen_before, all.end()});
      double energy = ideal; // of the rearranged map: as if it were enough where the cut costs too much
      if(refiner.cut().cost() < limit)
      {
        Component_result result = crowded[0].result;
        energy = map_with_room(refiner, result);
        if(keeps_bound(result))
          limit = (std::min)(limit, result.cost);
        take_better(std::move(result), best);
      }
      m_context.control.report(Phase::PARAMETERIZE,
                               share_before_longer_cuts * (1 + double(round + 1) / maximum_number_of_rounds));
      (energy <= m_bound ? kept : failed) = target;
      target = kept > ideal ? (kept + failed) / 2 : lowered(target, energy - m_bound);
    }
    if(keeps_bound(best) && m_parameters.opens_slits_first())
      shorten(best);
    return best;
  }

  void lower(Cut_refiner& refiner, const Refinement_goal& goal) const
  {
    const Phase_clock::Measurement measurement(m_context.clock, Phase::REFINE);
    refiner.refine(goal);
  }

  // Returns the energy before slits: they are for what little is missing then.
  double map_with_room(const Cut_refiner& refiner, Component_result& result) const
  {
    m_parameterizer(refiner.cut(), result);
    if(!result.has_map)
      return infinity;
    if(result.energy <= m_bound)
      return result.energy;
    const std::optional<Open_chart> rearranged = reglue(refiner.cut().chart(), false, result);
    const double energy = result.energy;
    if(rearranged && energy > m_bound)
      relieve(*rearranged, result);
    return energy;
  }

  const Problem& m_problem;
  const Context m_context;
  const Cutting_parameters& m_parameters;
  const Cut_parameterizer& m_parameterizer;
  const double m_bound;
  const Objective m_objective;
  const bool m_moves_ends;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_ROOM_SEARCH_H
