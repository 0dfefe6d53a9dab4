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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_FINISHER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_FINISHER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/detection/Feature_detector.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Cut_refiner.h>
#include <CGAL/Surface_mesh_cutting/internal/result/Component_result.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Cut_parameterizer.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Room_search.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Run_plan.h>

#include <algorithm>
#include <utility>
#include <vector>


namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The last steps of a run, on the surface itself: connects features that were found on a coarser version, corrects the cut,
// and maps it as asked for.
class Finisher
{
public:
  // The references are kept.
  Finisher(const Problem& problem, const Context& context, const Run_plan& plan)
    : m_problem(problem), m_parameters(context.parameters), m_context(context), m_control(context.control), m_plan(plan),
      m_objective(context.parameters),
      m_parameterizer(problem, context), m_room_search(context, m_parameterizer, plan.rounds_of_moved_ends > 0)
  {}

  // Where features are all that is known of a cut.
  Component_result from_features(const Detected_features& detected, bool needs_map) const
  {
    Component_result result = result_without_cut(detected);
    Cut_refiner refiner(m_problem, m_context);
    if(!result.status || !connect(refiner, detected, result) || !(needs_map || corrects()) || !map(refiner, result))
      return result;
    if(corrects())
      refine(refiner, {m_objective, m_plan.corrective_solves, false, (std::min)(m_plan.rounds_of_moved_ends, 1)});
    finish(refiner, result);
    return result;
  }

  // The mapped cut of a runner.
  Component_result from_cut(const Detected_features& detected, const Cut_refiner& refiner) const
  {
    Component_result result = result_without_cut(detected);
    finish(refiner, result);
    return result;
  }

  // The given cut, completed, and the same refined; features play no part. None without a map.
  std::vector<Component_result> from_given_cut() const
  {
    std::vector<Component_result> results;
    const Connected_cut given = m_problem.initial.connected(m_problem.mesh, m_problem.constraints,
                                                                  m_problem.terminals, m_context.execution, m_control);
    Cut_refiner refiner(m_problem, m_context);
    if(!given.status || !refiner.start(given.cut))
      return results;
    Component_result completed, shortened;
    m_control.report(Phase::PARAMETERIZE, 0);
    map(refiner, completed, false);
    m_control.report(Phase::PARAMETERIZE, 1);
    say_if_missed(completed);
    if(completed.has_map)
      results.push_back(std::move(completed));
    if(!m_control.go_further())
      return results;
    refine(refiner, {m_objective, m_plan.number_of_solves, false, m_plan.rounds_of_moved_ends});
    finish(refiner, shortened);
    if(shortened.has_map)
      results.push_back(std::move(shortened));
    return results;
  }

  static Component_result result_without_cut(const Detected_features& detected)
  {
    Component_result result;
    result.status = detected.status;
    result.number_of_candidates = detected.number_of_candidates;
    result.features = detected.features;
    result.add(detected.trade_offs);
    return result;
  }

private:
  // The published method has a bound only here.
  bool corrects() const { return m_objective.has_bound() || m_plan.corrective_solves > 0; }

  bool connect(Cut_refiner& refiner, const Detected_features& detected, Component_result& result) const
  {
    const Phase_clock::Measurement measurement(m_context.clock, Phase::CONNECT);
    m_control.report(Phase::CONNECT, 0);
    // On its way to a bound, a cut does not remain the tree through these features.
    result.status = refiner.connect(detected.features, !detected.is_hopeless && !corrects());
    if(m_control.is_stopped())
      result.status = failure(m_control);
    if(!result.status)
      return false;
    m_parameterizer.take_cut(refiner.cut(), refiner.cut().tree().cut, result);
    m_control.report(Phase::CONNECT, 1);
    return true;
  }

  bool map(Cut_refiner& refiner, Component_result& result) const
  {
    const Phase_clock::Measurement measurement(m_context.clock, Phase::PARAMETERIZE);
    // At full resolution a second solve costs more than the precision that refinement does not need.
    if(corrects() ? refiner.map() : refiner.map(mapping_policy(m_parameters).final_precision))
      return true;
    result.status = failure(m_control);
    result.has_cut = false;
    return false;
  }

  void refine(Cut_refiner& refiner, const Refinement_goal& goal) const
  {
    const Phase_clock::Measurement measurement(m_context.clock, Phase::REFINE);
    m_control.report(Phase::REFINE, 0);
    refiner.prepare(goal);
    refiner.refine(goal);
    m_control.report(Phase::REFINE, 1);
  }

  void finish(const Cut_refiner& refiner, Component_result& result) const
  {
    m_control.report(Phase::PARAMETERIZE, 0);
    map(refiner, result, true);
    result.loss_for_room = m_objective(result.cost, result.energy) /
                             m_objective(refiner.cut().cost(), refiner.cut().running_energy()) - 1;
    say_if_missed(result);
    result.add(refiner.cut().trade_offs());
    result.keep_undominated_trade_offs();
    m_control.report(Phase::PARAMETERIZE, 1);
  }

  void map(const Cut_refiner& refiner, Component_result& result, bool makes_room) const
  {
    const Phase_clock::Measurement measurement(m_context.clock, Phase::PARAMETERIZE);
    m_parameterizer(refiner.cut(), result);
    if(makes_room)
      m_room_search(refiner, result);
    if(!result.has_map && !m_control.is_stopped())
      m_parameterizer.map_in_any_case(refiner.cut().chart(), result);
    if(!result.has_map || m_control.is_stopped())
      result.status = failure(m_control);
    else
      result.status.finding = Finding(); // even if another cut had no map
  }

  void say_if_missed(Component_result& result) const
  {
    if(result.status && result.energy > m_parameters.maximum_average_distortion)
      result.status = bound_missed(result.energy, m_parameters.maximum_average_distortion);
  }

  const Problem& m_problem;
  const Cutting_parameters& m_parameters;
  const Context m_context;
  Run_control& m_control;
  const Run_plan m_plan;
  const Objective m_objective;
  const Cut_parameterizer m_parameterizer;
  const Room_search m_room_search;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_FINISHER_H
