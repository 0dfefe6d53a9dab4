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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_COMPONENT_CUTTER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_COMPONENT_CUTTER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_component.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Finisher.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Peak_lowering.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Race.h>
#include <CGAL/Surface_mesh_cutting/internal/run/detect_features.h>
#include <CGAL/Surface_mesh_cutting/internal/run/early_result.h>
#include <CGAL/Surface_mesh_cutting/internal/straightening/Seam_straightener.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>


namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Cuts one connected part of a surface that is not a disk.
class Component_cutter
{
public:
  // Nothing is mandatory yet. The references that the context holds are kept.
  Component_cutter(Problem problem, const Context& context)
    : m_problem(std::move(problem)), m_context(context), m_objective(context.parameters)
  {}

  // The features alone: what the paper detects.
  Component_result detect()
  {
    Component_result result;
    result.status = open_handles(m_problem, m_context);
    if(!result.status)
      return result;
    const Run_plan plan = make_plan(Effort::FAST, m_context.parameters, m_problem);
    const Detected_features detected = detect_features(m_problem, plan.number_of_faces, m_context);
    return Finisher::result_without_cut(detected);
  }

  // Runs with the plan of the effort. The best effort runs with those of the smaller ones first, so that it is no worse; where
  // a bound is missed, the next larger one may follow. The best result is returned, with the cuts that any run has seen.
  Component_result run(bool needs_map)
  {
    Component_result failed;
    failed.status = open_handles(m_problem, m_context);
    if(!failed.status)
      return failed;
    std::vector<Component_result> results;
    std::vector<Effort> efforts = this->efforts();
    for(std::size_t i = 0; i < efforts.size() && (i == 0 || m_context.control.go_further()); ++i)
    {
      Run_control control(m_context.control, 1. / double(efforts.size()));
      const Context context{m_context.parameters, control, m_context.clock, m_context.execution};
      for(Component_result& result : results_of(make_plan(efforts[i], m_context.parameters, m_problem), context, needs_map))
        if(result.has_cut || results.empty())
          results.push_back(std::move(result));
      if(!results.front().has_cut)
        return std::move(results.front());
      if(i + 1 == efforts.size() && efforts[i] != Effort::BEST && needs_more_starts(results))
        efforts.push_back(efforts[i] == Effort::FAST ? Effort::DEFAULT : Effort::BEST);
    }
    if(m_problem.initial.is_given())
      add_given_cut(results);
    return finished(best_of(results));
  }

  // What is returned of a stopped run that found no map, or no cut if that is what is asked for.
  Component_result completed_early(Component_result found, bool needs_map) const
  {
    complete_early(m_problem, needs_map, m_context, found);
    return found;
  }

private:
  std::vector<Effort> efforts() const
  {
    if(m_context.parameters.effort == Effort::BEST)
      return {Effort::FAST, Effort::DEFAULT, Effort::BEST};
    return {m_context.parameters.effort};
  }

  std::vector<Component_result> results_of(const Run_plan& plan, const Context& context, bool needs_map) const
  {
    const Finisher finisher(m_problem, context, plan);
    if(!plan.refines() && plan.number_of_starts == 1)
      return {finisher.from_features(detect_features(m_problem, plan.number_of_faces, context), needs_map)};
    return plan.is_coarsened() ? results_by_coarser_version(plan, finisher, context, needs_map)
                               : results_of_race(Race(m_problem, context, plan, false), plan, context, [&](const Runner& runner)
                                                 { return finisher.from_cut(runner.detected, *runner.refiner); });
  }

  // Races on a coarser version, of which only features are handed on.
  std::vector<Component_result> results_by_coarser_version(const Run_plan& plan, const Finisher& finisher, const Context& context,
                                                           bool needs_map) const
  {
    const Coarse_mesh coarse = coarser_version(m_problem, plan.number_of_faces, context);
    Problem problem = coarse_problem(m_problem, coarse);
    Component_result failed;
    if(!problem.is_sphere)
      failed.status = cut_handles_of(problem, context);
    if(!failed.status)
      return {failed};
    const Race race(problem, context, plan, true);
    return results_of_race(race, plan, context, [&](const Runner& runner)
    {
      Detected_features detected = runner.detected;
      detected.features = lifted(m_problem, coarse, runner.refiner->cut().features());
      detected.trade_offs = runner.refiner->cut().trade_offs();
      return finisher.from_features(detected, needs_map);
    });
  }

  // Finishes the best one; another one where it misses the bound or pays much for room: its chart may lie otherwise.
  template <typename Finish>
  std::vector<Component_result> results_of_race(const Race& race, const Run_plan& plan, const Context& context,
                                                const Finish& finish) const
  {
    std::vector<Runner> runners = race.run();
    if(!runners.front().refiner)
      return {Finisher::result_without_cut(runners.front().detected)};
    std::vector<Component_result> results(1, finish(runners[0]));
    const int number = (std::min)(int(runners.size()), plan.number_of_finalists());
    for(int i = 1; i < number && runners[i].refiner && goes_on_after(results) && context.control.go_further(); ++i)
    {
      if(i >= plan.number_of_refined())
        race.refine(runners[i]);
      results.push_back(finish(runners[i]));
    }
    return results;
  }

  bool goes_on_after(const std::vector<Component_result>& results) const
  {
    constexpr double much = 0.03; // of the objective
    return std::all_of(results.begin(), results.end(), [&](const Component_result& r)
                       { return !r.has_map || !m_objective.keeps_bound(r.energy) || r.loss_for_room > much; });
  }

  // On coarse surfaces, where starts differ most, another one may reach the bound, and takes little time.
  bool needs_more_starts(const std::vector<Component_result>& results) const
  {
    constexpr int largest = 2000; // faces
    return m_problem.mesh.number_of_faces() <= largest && !m_context.parameters.use_published_method &&
           std::all_of(results.begin(), results.end(), [&](const Component_result& r)
                       { return r.has_map && !m_objective.keeps_bound(r.energy); });
  }

  // A tree through the ends of a given cut and through further features may be worse than that cut.
  void add_given_cut(std::vector<Component_result>& results) const
  {
    if(!m_context.control.go_further())
      return;
    const Run_plan plan = make_plan(m_context.parameters.effort, m_context.parameters, m_problem);
    for(Component_result& result : Finisher(m_problem, m_context, plan).from_given_cut())
    {
      result.number_of_candidates = results.front().number_of_candidates;
      results.push_back(std::move(result));
    }
  }

  // With straight seams, unless these leave faces above a bound that the seams as they were would not.
  Component_result finished(Component_result best) const
  {
    std::optional<Component_result> former; // where it may be needed: it can be large
    if(m_context.parameters.has_local_bounds())
      former = best;
    Seam_straightener(m_problem, m_context, best).run();
    const bool is_straightened = former && best.cut != former->cut;
    const Peak_lowering lower(m_problem, m_context);
    lower(best);
    if(!is_straightened || best.status || !m_context.control.go_further())
      return best;
    lower(*former);
    return former->status ? std::move(*former) : best;
  }

  Component_result best_of(std::vector<Component_result>& results) const
  {
    Component_result& best = *std::min_element(results.begin(), results.end(), [this](const auto& a, const auto& b)
                                               { return a.rank(m_objective) < b.rank(m_objective); });
    if(results.size() == 1)
      return std::move(best);
    std::vector<Trade_off> seen;
    for(const Component_result& r : results)
    {
      seen.insert(seen.end(), r.trade_offs.begin(), r.trade_offs.end());
      if(r.has_map)
        seen.push_back({r.length, r.cost, r.energy});
    }
    best.trade_offs = std::move(seen);
    best.keep_undominated_trade_offs();
    return std::move(best);
  }

  Problem m_problem;
  const Context m_context;
  const Objective m_objective;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_COMPONENT_CUTTER_H
