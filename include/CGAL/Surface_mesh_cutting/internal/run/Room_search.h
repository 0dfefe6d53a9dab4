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
#include <utility>


namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Makes room for a map without overlaps where the one of a given cut is too much worse than that with overlaps. Two remedies:
// slits, so that parts can bend apart, and several charts; the objective decides.
class Room_search
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

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
    Component_result crowded = result;
    crowded.trade_offs.clear();
    constexpr double much = 0.05; // relative
    const double limit = (1 + much) * m_objective(refiner.cut().cost(), running.energy);
    open_slits(crowded, running, goal, result);
    if(!keeps_bound(result) || value(result) > limit)
      divide(crowded, running, goal, result);
  }

private:
  // Without a bound that the map with overlaps keeps, about its energy: more room gains nothing.
  double goal(const Open_chart& running) const
  {
    return m_objective.has_bound() && m_objective.keeps_bound(running.energy) ? m_objective.bound()
                                                                              : running.energy + Cut_parameterizer::tolerance;
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
  void open_slits(Component_result relieved, const Open_chart& overlapping, double goal, Component_result& result) const
  {
    m_parameterizer.relieve(overlapping, goal, relieved);
    if(keeps_bound(relieved) && m_parameters.widens_search())
      shorten(goal, relieved);
    take_better(std::move(relieved), result);
  }

  // Slits gain in whole paths, and other branches contribute less then. Several charts stay as they are.
  void shorten(double goal, Component_result& result) const
  {
    if(result.chart.border_loops().size() > 1)
      return;
    m_parameterizer.trim(m_objective, result);
    if(m_moves_ends && m_parameterizer.move_ends_and_ways(m_objective, goal, result))
      m_parameterizer.trim(m_objective, result); // that may have left some room below the bound
  }

  void divide(Component_result divided, const Open_chart& overlapping, double goal, Component_result& result) const
  {
    if(overlapping.energy <= goal && m_context.control.go_further() && m_parameterizer.divide(overlapping, goal, divided))
      take_better(std::move(divided), result);
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
