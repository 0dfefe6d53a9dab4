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
#include <CGAL/Surface_mesh_cutting/internal/run/Several_starts.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Start_run.h>
#include <CGAL/Surface_mesh_cutting/internal/run/detect_features.h>
#include <CGAL/Surface_mesh_cutting/internal/run/early_result.h>
#include <CGAL/Surface_mesh_cutting/internal/run/rank_of_result.h>
#include <CGAL/Surface_mesh_cutting/internal/run/set_effort.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {


// The whole method for one connected surface (paper, Section 3): handles, features, connection and,
// on request, refinement and UVs. The features of a large surface are found on a coarser version
// of it, at a cost that no longer grows with the surface, and connected on the surface itself.
class Component_cutter
{
public:
  // Nothing is mandatory yet. The references that the context holds are kept.
  Component_cutter(Problem problem, const Context& context)
    : m_problem(std::move(problem)), m_context(context)
  {}

  Component_result detect()
  {
    Component_result result;
    result.status = open_handles(m_problem, m_context);
    if(!result.status)
      return result;
    Cutting_parameters parameters = m_context.parameters;
    parameters.number_of_starts = 1; // what is asked for is what the paper detects
    parameters = parameters.adapted_to_size(m_problem.mesh.number_of_faces());
    Detected_features detected
      = detect_features(m_problem, 0, Context{parameters, m_context.control, m_context.clock, m_context.execution});
    result.status = detected.status;
    result.number_of_candidates = detected.number_of_candidates;
    result.features = std::move(detected.features);
    return result;
  }

  // Runs as often as the effort says, and on where a bound was missed or takes too much; the best result is returned,
  // with the cuts that any run has seen.
  Component_result run(bool needs_uv)
  {
    const bool has_seeds = m_problem.is_sphere && !m_problem.initial.is_given(); // that lead to other first cuts
    std::vector<Cutting_parameters> runs = portfolio(m_context.parameters, has_seeds);
    Component_result failed;
    failed.status = open_handles(m_problem, m_context);
    if(!failed.status)
      return failed;
    std::vector<Component_result> results;
    Done done;
    constexpr double others = 0.25; // runs that may follow
    double left = 1;                // of the work
    for(std::size_t i = 0; i < runs.size() && m_context.control.go_further(); ++i)
    {
      const double share = left / (double(runs.size() - i) + (m_context.parameters.has_bound() ? others : 0));
      Run_control control(m_context.control, share);
      left -= share;
      if(i > 0 && runs[i].effort != runs[i - 1].effort)
        done = Done();
      for(Component_result& result : results_of(runs[i], has_seeds, needs_uv || runs.size() > 1, control, done))
        if(result.has_cut || results.empty())
          results.push_back(std::move(result));
      if(!results.front().has_cut)
        return results.front();
      if(runs.size() == 1 && goes_on_after(results))
        for(const Cutting_parameters& other : portfolio(with_effort(Effort::BEST, m_context.parameters), has_seeds))
          runs.push_back(other);
      else if(runs.size() == 1 && !done.features.empty() && lacks_room(results))
        add_further_runs(further_runs(m_context.parameters, has_seeds), done, results);
    }
    if(m_problem.initial.is_given())
      add_given_cut(results);
    if(results.empty())
    {
      failed.status = failure(m_context.control);
      return failed;
    }
    if(m_context.parameters.effort == Effort::BEST && m_context.parameters.has_bound() && !m_problem.is_opened)
      go_on_from_best(results);
    return best_of(results);
  }

  // What is returned of a stopped run that found no map, or no cut if that is what is asked for.
  Component_result completed_early(Component_result found, bool needs_map) const
  {
    complete_early(m_problem, needs_map, m_context, found);
    return found;
  }

private:
  // What runs with the same effort have done: the features that they led to, but for several starts that are finished, and
  // the seeds of the last one's starts, if it had several.
  struct Done
  {
    std::vector<std::vector<int>> features;
    std::vector<unsigned int> seeds;
  };

  // Nothing of what has been done already.
  std::vector<Component_result> results_of(const Cutting_parameters& parameters, bool has_seeds, bool needs_map,
                                           Run_control& control, Done& done) const
  {
    const Context context{m_context.parameters, control, m_context.clock, m_context.execution};
    std::vector<Component_result> results;
    const Several_starts several(m_problem, context);
    const bool finishes_several = has_seeds && several.serve(parameters);
    std::vector<unsigned int> seeds = finishes_several ? several.seeds(parameters.random_seed)
                                                       : seeds_of_compared_starts(m_problem, parameters);
    const bool is_new = seeds.empty() || seeds != done.seeds;
    done.seeds = std::move(seeds);
    if(!is_new)
      return results;
    if(finishes_several)
      return several.run(parameters);
    results.push_back(Start_run(m_problem, parameters, context)(0, needs_map, done.features));
    done.features.push_back(results.front().detected_features);
    return results;
  }

  // Side by side: a run from one start seldom has work for many threads.
  void add_further_runs(const std::vector<Cutting_parameters>& further, const Done& done,
                        std::vector<Component_result>& results) const
  {
    std::deque<Start_run> runs; // which do not move
    for(const Cutting_parameters& parameters : further)
      runs.emplace_back(m_problem, parameters, m_context);
    std::vector<Detected_features> detected(runs.size());
    execute(m_context.execution, int(runs.size()), [&](int i)
    {
      if(m_context.control.go_further())
        detected[i] = runs[i].detect(0);
    });
    const std::vector<int> others = places_of_other_features(detected, done.features);
    std::vector<Component_result> found(others.size());
    execute(m_context.execution, int(others.size()), [&](int i)
    {
      const int place = others[i];
      if(m_context.control.go_further())
        found[i] = runs[place].finished(runs[place].begun(std::move(detected[place]), true));
    });
    for(Component_result& result : found)
      if(result.has_cut)
        results.push_back(std::move(result));
  }

  // As from a given cut, as long as that shortens it: on the chart of the best cut, other features show.
  void go_on_from_best(std::vector<Component_result>& results) const
  {
    constexpr int maximum_number_of_rounds = 4;
    const Cutting_parameters parameters = with_effort(Effort::DEFAULT, m_context.parameters);
    for(int round = 0; round < maximum_number_of_rounds && m_context.control.go_further(); ++round)
    {
      const Component_result& best = *best_among(results);
      if(!best.has_map)
        return;
      Problem problem = m_problem;
      problem.constraints.mandatory = Cut(m_problem.mesh.number_of_edges(), 0); // other loops may follow that cut
      problem.initial = Initial_cut(best.cut);
      if(!open_handles(problem, m_context))
        return;
      Component_result next = Start_run(problem, parameters, m_context)(0, true);
      const bool goes_on = next.has_map && is_better(next, best);
      if(next.has_cut)
        results.push_back(std::move(next));
      if(!goes_on)
        return;
    }
  }

  // A tree through the ends of a given cut and through further features may be worse than that cut.
  void add_given_cut(std::vector<Component_result>& results) const
  {
    if(!m_context.control.go_further())
      return;
    for(Component_result& result : Start_run(m_problem, m_context.parameters, m_context).from_given_cut())
    {
      if(!results.empty())
        result.number_of_candidates = results.front().number_of_candidates;
      results.push_back(std::move(result));
    }
  }

  // On coarse surfaces, where starts differ most, another one may reach the bound, and takes little time.
  bool goes_on_after(const std::vector<Component_result>& results) const
  {
    constexpr int largest = 2000; // faces
    return m_context.parameters.has_bound() && !m_context.parameters.use_published_method &&
           m_problem.mesh.number_of_faces() <= largest &&
           std::all_of(results.begin(), results.end(), [&](const Component_result& r)
                       { return r.has_map && m_context.parameters.excess(r.energy) > 0; });
  }

  // Where it takes much of the cut to keep parts of the chart out of each other's way, a start that leads to another chart
  // may need far less.
  bool lacks_room(const std::vector<Component_result>& results) const
  {
    constexpr double much = 0.1; // of the cost
    return m_context.parameters.opens_slits_first &&
           std::all_of(results.begin(), results.end(),
                       [&](const Component_result& r) { return r.cost_of_room > much * r.cost; });
  }

  Component_result best_of(std::vector<Component_result>& results) const
  {
    Component_result& best = *best_among(results);
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

  std::vector<Component_result>::iterator best_among(std::vector<Component_result>& results) const
  {
    return std::min_element(results.begin(), results.end(), [this](const auto& a, const auto& b) { return is_better(a, b); });
  }

  bool is_better(const Component_result& a, const Component_result& b) const
  {
    return rank_of_result(a, m_context.parameters) < rank_of_result(b, m_context.parameters);
  }

  Problem m_problem;
  const Context m_context;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_COMPONENT_CUTTER_H
