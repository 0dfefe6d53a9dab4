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

#include <CGAL/Surface_mesh_cutting/internal/result/Component_result.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Cut_parameterizer.h>
#include <CGAL/Surface_mesh_cutting/internal/run/detect_features.h>
#include <CGAL/Surface_mesh_cutting/internal/run/rank_of_result.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Detects, connects, refines and parameterizes a surface without handles, from one start.
template <typename ConcurrencyTag>
class Start_run
{
  using Refiner = Cut_refiner<ConcurrencyTag>;

  static constexpr double ideal = Symmetric_Dirichlet_energy::ideal;
  static constexpr double share_before_longer_cuts = 0.5; // of the work for room, to show

public:
  // The references are kept, but that to the parameters of the context: `parameters`, adapted to the size of the surface,
  // take their place.
  Start_run(const Problem& problem, const Cutting_parameters& parameters, const Context& context)
    : m_problem(problem), m_parameters(parameters.adapted_to_size(problem.mesh.number_of_faces())),
      m_context{m_parameters, context.control, context.clock}, m_control(context.control),
      m_parameterizer(problem, m_context), m_is_coarsened(is_coarsened(problem, m_parameters))
  {}

  Start_run(const Start_run&) = delete; // the context refers to the parameters
  Start_run& operator=(const Start_run&) = delete;

  // A start on its way: what is known of it, and its mapped cut, if there is more to do.
  struct Begun
  {
    Component_result result;
    std::unique_ptr<Refiner> refiner;
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

  Detected_features detect(int start) const { return detect_features<ConcurrencyTag>(m_problem, start, m_context); }

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
    Refiner refiner(m_problem, m_context);
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
    start.refiner = std::make_unique<Refiner>(std::move(refiner));
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
    start.result.add(start.refiner->cut().trade_offs());
    start.result.keep_undominated_trade_offs();
    return std::move(start.result);
  }

  // The given cut, completed, and the same shortened; features play no part. None without a map.
  std::vector<Component_result> from_given_cut() const
  {
    std::vector<Component_result> results;
    const Connected_cut given = m_problem.initial.template connected<ConcurrencyTag>(m_problem.mesh, m_problem.constraints,
                                                                                     m_problem.terminals, m_control);
    if(!given.status)
      return results;
    Refiner refiner(m_problem, m_context);
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

  bool connect(Refiner& refiner, const Detected_features& detected, Component_result& result) const
  {
    const Phase_clock::Measurement measurement(m_context.clock, Phase::CONNECT);
    m_control.report(Phase::CONNECT, 0);
    result.status = refiner.connect(detected.features, !detected.is_hopeless);
    if(m_control.is_stopped())
      result.status = failure(m_control);
    if(!result.status)
      return false;
    m_parameterizer.take_cut(refiner.cut(), refiner.cut().tree().cut, result);
    m_control.report(Phase::CONNECT, 1);
    return true;
  }

  bool map(Refiner& refiner, Component_result& result) const
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

  // A bijective map may miss a bound that the running map keeps; then the cut has to be longer.
  void make_room(const Refiner& refiner, double repair_threshold, Component_result& result) const
  {
    if(m_parameters.has_bound() && m_parameters.do_bijective && result.energy > m_parameters.maximum_average_distortion &&
       m_control.go_further())
    {
      const double cost_with_overlaps = result.cost;
      lower_without_overlaps(refiner, repair_threshold, result);
      result.cost_of_room = result.cost - cost_with_overlaps;
    }
    say_if_missed(result);
  }

  void say_if_missed(Component_result& result) const
  {
    if(result.status && result.energy > m_parameters.maximum_average_distortion)
      result.status = bound_missed();
  }

  // Where parts of the chart are in each other's way, they are glued elsewhere, slits let them turn aside, or seams divide
  // several charts. If all that does not suffice, or costs much where not all was tried, slits are opened that lower the
  // running map's energy, of which only some make room.
  void lower_without_overlaps(const Refiner& refiner, double repair_threshold, Component_result& result) const
  {
    constexpr double little = 0.05, much = 0.1; // of the cost
    const Component_result given = result;
    const Open_chart& running = refiner.cut().chart();
    const auto keeps_it_within = [&](double share, const Component_result& r)
    { return keeps_bound(r) && r.cost <= (1 + share) * given.cost; };
    const double enough_cost = (1 + little) * given.cost;
    if(const auto other = reglue(running, result))
      make_room_in(*other, true, enough_cost, result);
    m_control.report(Phase::PARAMETERIZE, share_before_longer_cuts);
    if(keeps_it_within(little, result))
      return;
    Component_result alternative = given;
    make_room_in(running, m_parameters.opens_slits_first, enough_cost, alternative);
    take_better(std::move(alternative), result);
    if(m_parameters.opens_slits_first ? keeps_bound(result) : keeps_it_within(much, result))
      return;
    alternative = given;
    lower_by_longer_cuts(refiner, repair_threshold, alternative);
    take_better(std::move(result), alternative); // if both cost the same, one chart is better
    result = std::move(alternative);
  }

  // By slits or, where they cost more than is enough, seams.
  void make_room_in(const Open_chart& overlapping, bool opens_slits, double enough_cost, Component_result& result) const
  {
    Component_result divided = result;
    if(opens_slits)
      relieve(overlapping, result);
    if((keeps_bound(result) && result.cost <= enough_cost) || !m_control.go_further() ||
       overlapping.energy > m_parameters.maximum_average_distortion)
      return;
    const Phase_clock::Measurement measurement(m_context.clock, Phase::PARAMETERIZE);
    if(m_parameterizer.divide(overlapping, m_parameters.maximum_average_distortion, divided))
      take_better(std::move(divided), result);
  }

  void take_better(Component_result other, Component_result& result) const
  {
    if(rank_of_result(other, m_parameters) < rank_of_result(result, m_parameters))
      std::swap(other, result);
    result.add(other.trade_offs);
  }

  bool keeps_bound(const Component_result& result) const
  { return result.has_map && result.energy <= m_parameters.maximum_average_distortion; }

  std::optional<Open_chart> reglue(const Open_chart& overlapping, Component_result& result) const
  {
    const Phase_clock::Measurement measurement(m_context.clock, Phase::PARAMETERIZE);
    return m_parameterizer.reglue(overlapping, m_parameters.maximum_average_distortion, result);
  }

  // By slits where room is missing; whether they are worth moving ends, the effort says.
  void relieve(const Open_chart& overlapping, Component_result& result) const
  {
    const Phase_clock::Measurement measurement(m_context.clock, Phase::PARAMETERIZE);
    const double bound = m_parameters.maximum_average_distortion;
    Component_result relieved = result;
    m_parameterizer.relieve(overlapping, bound, relieved);
    if(!keeps_bound(relieved))
      return;
    if(m_parameters.opens_slits_first)
      shorten_without_overlaps(relieved);
    result = std::move(relieved);
  }

  void lower_by_longer_cuts(const Refiner& refiner, double repair_threshold, Component_result& result) const
  {
    tighten(refiner, repair_threshold, result);
    const Phase_clock::Measurement measurement(m_context.clock, Phase::PARAMETERIZE);
    m_parameterizer.relieve(refiner.cut().chart(), m_parameters.maximum_average_distortion, result);
  }

  // Slits gain in whole paths, and other branches contribute less then.
  void shorten_without_overlaps(Component_result& result) const
  {
    const double bound = m_parameters.maximum_average_distortion;
    m_parameterizer.trim(bound, result);
    if(!m_parameters.moves_ends || rounds_of_moved_ends() == 0)
      return;
    m_parameterizer.move_ends_and_ways(bound, result);
    m_parameterizer.trim(bound, result); // that may have left some room below the bound
  }

  void refine_and_parameterize(Refiner& refiner, const Refinement_goal& goal, Component_result& result) const
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
    make_room(refiner, goal.repair_threshold, result);
    m_control.report(Phase::PARAMETERIZE, 1);
  }

  // Looks for the shortest cut whose bijective map keeps the bound: bisection over what is asked of
  // the running map, between what failed and what did not.
  void tighten(const Refiner& start, double repair_threshold, Component_result& best) const
  {
    constexpr int maximum_number_of_rounds = 6, solves = 10;
    // As long as no round keeps the bound: about twenty seconds, after which none has been seen to keep it.
    constexpr double maximum_number_of_solved_faces = 5e6;
    double number_of_solved_faces = 0;
    // Of what the bound leaves above the ideal: how precisely the target is found, and the shortest step to it.
    constexpr double relative_precision = 0.02, shortest_step = 0.1;
    const double bound = m_parameters.maximum_average_distortion, precision = relative_precision * (bound - ideal);
    // Down by what is missing, and not by more than half of what is left.
    const auto lowered = [&](double former, double missing)
    { return (std::max)(former - (std::max)(missing, shortest_step * (bound - ideal)), (former + ideal) / 2); };
    double failed = bound, kept = ideal, target = lowered(bound, best.energy - bound);
    for(int round = 0; round < maximum_number_of_rounds && failed - kept > precision && best.status; ++round)
    {
      if(kept == ideal && number_of_solved_faces > maximum_number_of_solved_faces)
        return;
      Refiner refiner = start;
      Component_result result = best;
      {
        const Phase_clock::Measurement measurement(m_context.clock, Phase::REFINE);
        refine(refiner, {target, repair_threshold, solves}, m_parameters);
      }
      m_parameterizer(refiner.cut(), result);
      m_control.report(Phase::PARAMETERIZE, share_before_longer_cuts * (1 + double(round) / maximum_number_of_rounds));
      number_of_solved_faces += double(refiner.cut().trade_offs().size()) * m_problem.mesh.number_of_faces();
      result.add(refiner.cut().trade_offs());
      const bool is_kept = keeps_bound(result);
      (is_kept ? kept : failed) = target;
      target = kept > ideal ? (kept + failed) / 2 : lowered(target, result.energy - bound);
      if(is_kept ? best.energy > bound || result.cost < best.cost
                 : result.has_map && result.energy < best.energy && best.energy > bound)
        best = std::move(result);
      else
        best.trade_offs = std::move(result.trade_offs);
    }
  }

  const Problem& m_problem;
  const Cutting_parameters m_parameters;
  const Context m_context;
  Run_control& m_control;
  const Cut_parameterizer<ConcurrencyTag> m_parameterizer;
  const bool m_is_coarsened;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_START_RUN_H
