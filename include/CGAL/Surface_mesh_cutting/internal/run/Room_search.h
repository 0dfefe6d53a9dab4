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
#include <limits>
#include <optional>
#include <utility>
#include <vector>


namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Makes room for a map without overlaps where the one of a given cut is too much worse than that with overlaps. Three remedies:
// slits so that parts can bend apart, parts glued elsewhere, and several charts; the objective decides.
class Room_search
{
  static constexpr double ideal = Symmetric_Dirichlet_energy::ideal, infinity = std::numeric_limits<double>::infinity();
  static constexpr double little = 0.02, much = 0.1; // losses of the objective, relative

public:
  // The references are kept. `moves_ends`: whether the ends of cuts that have room are moved.
  Room_search(const Context& context, const Cut_parameterizer& parameterizer, bool moves_ends)
    : m_context(context), m_parameters(context.parameters), m_parameterizer(parameterizer),
      m_objective(context.parameters), m_moves_ends(moves_ends)
  {}

  // `result`: the map without overlaps of the refiner's cut.
  void operator()(const Cut_refiner& refiner, Component_result& result) const
  {
    const Open_chart& running = refiner.cut().chart();
    const double goal = this->goal(running);
    if(!m_parameters.do_bijective || m_parameters.use_published_method || result.energy <= goal || !m_context.control.go_further())
      return;
    std::vector<Crowded> crowded{{result, running}};
    crowded[0].result.trade_offs.clear();
    const auto lacks = [&](double loss)
    { return !(keeps_bound(result) && value(result) <= (1 + loss) * m_objective(refiner.cut().cost(), running.energy)); };
    const bool is_near = result.has_map && result.energy - goal <= near * (goal - ideal);
    if(is_near)
      open_slits(crowded[0], goal, result);
    if(!lacks(little))
      return;
    if(auto overlapping = m_parameterizer.reglue(running, goal, m_objective.has_bound(), result))
      crowded.push_back({result, std::move(*overlapping)});
    if(crowded.size() > 1 || (m_parameters.widens_search() && !is_near))
      open_slits(crowded.back(), goal, result);
    if(lacks(much))
      divide(crowded, goal, result);
    if(lacks(much) && m_parameters.widens_search() && !is_near && crowded.size() > 1)
      open_slits(crowded[0], goal, result);
  }

private:
  static constexpr double near = 0.1; // above the goal, relative to what that leaves above the ideal

  // A map without overlaps that has too little room, and the best one of the same cut that may overlap.
  struct Crowded
  {
    Component_result result;
    Open_chart overlapping;
  };

  // Without a bound, about the energy of the map with overlaps: more room gains nothing.
  double goal(const Open_chart& running) const
  {
    return m_objective.has_bound() ? m_objective.bound() : running.energy + Cut_parameterizer::tolerance;
  }

  bool keeps_bound(const Component_result& result) const { return result.has_map && m_objective.keeps_bound(result.energy); }
  double value(const Component_result& result) const { return result.has_map ? m_objective(result.cost, result.energy) : infinity; }

  void take_better(Component_result other, Component_result& result) const
  {
    if(other.rank(m_objective) < result.rank(m_objective))
      std::swap(other, result);
    result.add(other.trade_offs);
  }

  // The effort decides whether the cut is shortened after slits.
  void open_slits(const Crowded& crowded, double goal, Component_result& result) const
  {
    Component_result relieved = crowded.result;
    m_parameterizer.relieve(crowded.overlapping, goal, relieved);
    if(keeps_bound(relieved) && m_parameters.widens_search())
      shorten(relieved);
    if(keeps_bound(relieved))
      take_better(std::move(relieved), result);
  }

  // Slits gain in whole paths, and other branches contribute less then. Several charts stay as they are.
  void shorten(Component_result& result) const
  {
    if(result.chart.border_loops().size() > 1)
      return;
    m_parameterizer.trim(m_objective, result);
    if(m_moves_ends && m_objective.has_bound() && m_parameterizer.move_ends_and_ways(m_objective.bound(), result))
      m_parameterizer.trim(m_objective, result); // that may have left some room below the bound
  }

  void divide(const std::vector<Crowded>& crowded, double goal, Component_result& result) const
  {
    for(const Crowded& c : crowded)
    {
      Component_result divided = c.result;
      if(c.overlapping.energy <= goal && m_context.control.go_further() && m_parameterizer.divide(c.overlapping, goal, divided))
        take_better(std::move(divided), result);
    }
  }

  const Context m_context;
  const Cutting_parameters& m_parameters;
  const Cut_parameterizer& m_parameterizer;
  const Objective m_objective;
  const bool m_moves_ends;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_ROOM_SEARCH_H
