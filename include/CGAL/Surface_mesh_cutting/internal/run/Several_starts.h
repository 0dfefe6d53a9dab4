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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_SEVERAL_STARTS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_SEVERAL_STARTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/refinement/Length_at_bound.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Start_run.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sort_by_key.h>

#include <algorithm>
#include <deque>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {


// Of those that were detected: where each set of features comes first, without the known ones.
inline std::vector<int> places_of_other_features(const std::vector<Detected_features>& detected,
                                                 std::vector<std::vector<int>> known)
{
  std::vector<int> places;
  for(int i = 0; i < int(detected.size()); ++i)
  {
    if(!detected[i].status || std::find(known.begin(), known.end(), detected[i].features) != known.end())
      continue;
    known.push_back(detected[i].features);
    places.push_back(i);
  }
  return places;
}

// Many starts of a small surface at a bound, of which the most promising are finished: what a cut costs when it has come
// to the bound tells much about what it will cost, and is known after a third of the time.
class Several_starts
{
  using Run = Start_run;
  using Begun = typename Run::Begun;

public:
  // The references are kept.
  Several_starts(const Problem& problem, const Context& context) : m_problem(problem), m_context(context) {}

  // On small surfaces, starts differ most, and each takes little time; on large ones, features of coarser versions do.
  bool serve(const Cutting_parameters& parameters) const
  {
    return parameters.effort == Effort::DEFAULT && parameters.moves_ends && number_of_starts() > 1 &&
           !is_coarsened(m_problem, parameters);
  }

  // The given one and the first ones: few runs depend on the given one. The same for all of these first ones.
  std::vector<unsigned int> seeds(unsigned int given) const
  {
    const unsigned int last = number_of_starts() - 1;
    std::vector<unsigned int> result;
    for(unsigned int seed = 0; seed < last; ++seed)
      result.push_back(seed);
    result.push_back((std::max)(given, last));
    return result;
  }

  // The finished ones, the most promising first. Some have no cut if the run was stopped.
  std::vector<Component_result> run(const Cutting_parameters& parameters) const
  {
    constexpr int number_of_finalists = 2;
    std::deque<Run_control> controls; // which runs refer to
    std::deque<Run> runs;             // which starts refer to
    const std::vector<unsigned int> seeds = this->seeds(parameters.random_seed);
    for(unsigned int seed : seeds)
    {
      controls.emplace_back(m_context.control, 1. / double(seeds.size()));
      runs.emplace_back(m_problem, of_start(parameters, int(runs.size()), seed),
                        Context{m_context.parameters, controls.back(), m_context.clock, m_context.execution});
    }
    std::vector<Begun> starts = prepared(runs);
    std::vector<double> costs;
    for(const Begun& start : starts)
      costs.push_back(expected_cost(start));
    const std::vector<int> order = CGAL::internal::Graph_kernel::ascending_places(costs);
    std::vector<Component_result> results((std::min)(int(order.size()), number_of_finalists));
    execute(m_context.execution, int(results.size()), [&](int i)
    {
      if(i == 0 || m_context.control.go_further())
        results[i] = runs[order[i]].finished(std::move(starts[order[i]]));
    });
    return results;
  }

private:
  // As many as are brought to the bound in about the time that the rest takes.
  int number_of_starts() const
  {
    constexpr int most = 8, enough_faces = 25000; // of all starts
    return (std::min)(most, enough_faces / m_problem.mesh.number_of_faces());
  }

  // Every other one asks features for more gain: fewer ones, which others join on the way to the bound.
  static Cutting_parameters of_start(Cutting_parameters parameters, int place, unsigned int seed)
  {
    constexpr double more = 2;
    parameters.random_seed = seed;
    if(place % 2 == 1)
      parameters.minimum_distortion_decrease *= more;
    return parameters;
  }

  // At the bound. If the run was stopped, some have not come there.
  double expected_cost(const Begun& start) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if(!start.refiner)
      return infinity;
    const Working_cut& cut = start.refiner->cut();
    if(m_context.control.is_stopped() && m_context.parameters.excess(cut.energy()) > 0)
      return std::numeric_limits<double>::max();
    return Length_at_bound(m_context.parameters.maximum_average_distortion)(cut.cost(), cut.energy());
  }

  // One start for each set of features, brought to the bound; the first one before others are looked for, so that a run
  // that is stopped soon has a cut.
  std::vector<Begun> prepared(const std::deque<Run>& runs) const
  {
    std::vector<Detected_features> detected(runs.size());
    std::vector<Begun> starts(runs.size());
    const auto detect = [&](int i)
    {
      if(i == 0 || m_context.control.go_further())
        detected[i] = runs[i].detect(0);
    };
    const auto prepare = [&](int i)
    {
      if(i > 0 && !m_context.control.go_further())
        return;
      starts[i] = runs[i].begun(detected[i], true);
      runs[i].prepare(starts[i]);
    };
    detect(0);
    prepare(0);
    execute(m_context.execution, int(runs.size()) - 1, [&](int i) { detect(i + 1); });
    const std::vector<int> others = places_of_other_features(detected, {detected[0].features});
    execute(m_context.execution, int(others.size()), [&](int i) { prepare(others[i]); });
    return starts;
  }

  const Problem& m_problem;
  const Context& m_context;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_SEVERAL_STARTS_H
