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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_START_RUN_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_START_RUN_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/refinement/refine.h>
#include <CGAL/Surface_mesh_cutting/internal/result/Component_result.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Cut_parameterizer.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Room_search.h>
#include <CGAL/Surface_mesh_cutting/internal/run/detect_features.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Detects, connects, refines and parameterizes a surface without handles, from one start.
class Start_run
{
  static constexpr double ideal = Symmetric_Dirichlet_energy::ideal;

public:
  // The references are kept, but that to the parameters of the context: `parameters`, adapted to the size of the surface,
  // take their place.
  Start_run(const Problem& problem, const Cutting_parameters& parameters, const Context& context)
    : m_problem(problem), m_parameters(parameters.adapted_to_size(problem.mesh.number_of_faces())),
      m_context{m_parameters, context.control, context.clock}, m_control(context.control),
      m_parameterizer(problem, m_context), m_is_coarsened(is_coarsened(problem, m_parameters)),
      m_room_search(problem, m_context, m_parameterizer, rounds_of_moved_ends() > 0)
  {}

  Start_run(const Start_run&) = delete; // the context refers to the parameters
  Start_run& operator=(const Start_run&) = delete;

  // A start on its way: what is known of it, and its mapped cut, if there is more to do.
  struct Begun
  {
    Component_result result;
    std::unique_ptr<Cut_refiner> refiner;
    double repair_threshold = ideal;
    bool is_refined = false, is_prepared = false;
  };

  // There is no cut if the features are among the `known` ones, which other starts with the same parameters led to.
  Component_result operator()(int start, bool needs_map, const std::vector<std::vector<int>>& known = {}) const
  {
    Detected_features detected = detect(start);
    if(std::find(known.begin(), known.end(), detected.features) != known.end())
      return result_without_cut(detected);
    return finished(begun(std::move(detected), needs_map));
  }

  Detected_features detect(int start) const { return detect_features(m_problem, start, m_context); }

  // Connects the features and maps the cut.
  Begun begun(Detected_features detected, bool needs_map) const
  {
    Begun start;
    start.result = result_without_cut(detected);
    start.repair_threshold = detected.repair_threshold;
    if(!start.result.status)
    {
      if(detected.is_refined && !m_is_coarsened) // the search was stopped, and had a cut
        take_found(std::move(detected), start.result);
      return start;
    }
    Cut_refiner refiner(m_problem, m_context);
    if(!connect(refiner, detected, start.result) || !(needs_map || refines()))
      return start;
    start.is_refined = detected.is_refined && !m_is_coarsened;
    if(start.is_refined)
      refiner.replace_tree(std::move(detected.chart));
    else if(!map(refiner, start.result))
      return start;
    // Where connecting the features loses too much, the filter's own cut is better.
    else if(refiner.cut().chart().energy > detected.repair_threshold && !m_problem.initial.is_given() && !m_is_coarsened)
      refiner.replace_tree(std::move(detected.chart));
    start.refiner = std::make_unique<Cut_refiner>(std::move(refiner));
    return start;
  }

  // With a bound: brings the cut there. What it costs then tells how promising it is.
  void prepare(Begun& start) const
  {
    if(!start.refiner)
      return;
    const Phase_clock::Measurement measurement(m_context.clock, Phase::REFINE);
    prepare_to_move_ends(*start.refiner, goal(start.repair_threshold, number_of_solves()));
    start.is_prepared = true;
  }

  Component_result finished(Begun start) const
  {
    if(!start.refiner)
      return std::move(start.result);
    Refinement_goal goal = this->goal(start.repair_threshold, start.is_refined ? 0 : number_of_solves());
    goal.is_prepared = start.is_prepared;
    refine_and_parameterize(*start.refiner, goal, start.result);
    start.result.keep_undominated_trade_offs();
    return std::move(start.result);
  }

  // The given cut, completed, and the same shortened; features play no part. None without a map.
  std::vector<Component_result> from_given_cut() const
  {
    std::vector<Component_result> results;
    const Connected_cut given = m_problem.initial.connected(m_problem.mesh, m_problem.constraints,
                                                                  m_problem.terminals, m_context.execution, m_control);
    if(!given.status)
      return results;
    Cut_refiner refiner(m_problem, m_context);
    if(!refiner.start(given.cut))
      return results;
    Component_result completed, shortened;
    m_control.report(Phase::PARAMETERIZE, 0);
    m_parameterizer(refiner.cut(), completed);
    m_control.report(Phase::PARAMETERIZE, 1);
    say_if_missed(completed);
    if(completed.has_map)
      results.push_back(std::move(completed));
    if(!m_control.go_further())
      return results;
    const double repair_threshold = refiner.cut().energy() + m_parameters.minimum_distortion_decrease;
    refine_and_parameterize(refiner, goal(repair_threshold, number_of_solves()), shortened);
    if(shortened.has_map)
      results.push_back(std::move(shortened));
    return results;
  }

private:
  static Component_result result_without_cut(const Detected_features& detected)
  {
    Component_result result;
    result.status = detected.status;
    result.number_of_candidates = detected.number_of_candidates;
    result.detected_features = detected.features;
    result.add(detected.trade_offs);
    return result;
  }

  // What was found when the run was stopped. Its map may overlap.
  void take_found(Detected_features detected, Component_result& result) const
  {
    result.has_cut = true;
    result.has_map = !m_parameters.do_bijective;
    result.features = std::move(detected.features);
    result.cut = std::move(detected.chart.cut);
    result.length = cut_length(m_problem.mesh, result.cut);
    result.cost = cut_cost(m_problem.constraints, result.cut);
    result.chart = std::move(detected.chart.chart);
    result.uv = std::move(detected.chart.uv);
    result.energy = detected.chart.energy;
    result.keep_undominated_trade_offs();
  }

  // Where features are found on a coarser version, refinement without a bound or a given cut happens there.
  bool refines() const
  {
    return m_is_coarsened ? m_parameters.has_bound() : internal::refines(m_problem, m_parameters);
  }

  // A coarser version showed about where ends belong; a whole cut to one disk has too many.
  int rounds_of_moved_ends() const
  {
    return m_problem.is_opened || m_problem.has_many_handles ? 0 : m_is_coarsened ? 1 : 3;
  }

  int number_of_solves() const
  {
    return m_is_coarsened ? m_parameters.number_of_corrective_solves : m_parameters.number_of_shortening_solves;
  }

  bool connect(Cut_refiner& refiner, const Detected_features& detected, Component_result& result) const
  {
    const Phase_clock::Measurement measurement(m_context.clock, Phase::CONNECT);
    m_control.report(Phase::CONNECT, 0);
    // On its way to a bound, a cut does not remain the tree through these features.
    result.status = refiner.connect(detected.features, !detected.is_hopeless && !m_parameters.has_bound());
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
    if(refines() ? refiner.map() : refiner.map(mapping_policy(m_parameters).final_precision))
      return true;
    result.status = failure(m_control);
    result.has_cut = false;
    return false;
  }

  Refinement_goal goal(double repair_threshold, int number_of_solves) const
  {
    return {m_parameters.maximum_average_distortion, repair_threshold, number_of_solves, false, rounds_of_moved_ends()};
  }

  void say_if_missed(Component_result& result) const
  {
    if(result.status && result.energy > m_parameters.maximum_average_distortion)
      result.status = bound_missed(result.energy, m_parameters.maximum_average_distortion);
  }

  void refine_and_parameterize(Cut_refiner& refiner, const Refinement_goal& goal, Component_result& result) const
  {
    if(refines() || refiner.cut().chart().energy > goal.repair_threshold)
    {
      const Phase_clock::Measurement measurement(m_context.clock, Phase::REFINE);
      m_control.report(Phase::REFINE, 0);
      refine(refiner, goal, m_parameters);
      m_control.report(Phase::REFINE, 1);
    }
    m_control.report(Phase::PARAMETERIZE, 0);
    m_parameterizer(refiner.cut(), result);
    m_room_search(refiner, goal.repair_threshold, result);
    say_if_missed(result);
    result.add(refiner.cut().trade_offs());
    m_control.report(Phase::PARAMETERIZE, 1);
  }

  const Problem& m_problem;
  const Cutting_parameters m_parameters;
  const Context m_context;
  Run_control& m_control;
  const Cut_parameterizer m_parameterizer;
  const bool m_is_coarsened;
  const Room_search m_room_search;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_START_RUN_H
