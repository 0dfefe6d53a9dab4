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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_DETECT_FEATURES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_DETECT_FEATURES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/detection/Coarse_disk.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/Local_filter.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Cut_search.h>
#include <CGAL/Surface_mesh_cutting/internal/run/features_of_start.h>
#include <CGAL/Surface_mesh_cutting/internal/run/set_effort.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sort_unique.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {


// The features of a surface without handles (paper, Section 3.1), from the given start.
// On a surface that is opened to a disk, on a coarser version of that disk.
inline Detected_features detect_features_of_disk(const Problem& fine, const Context& context)
{
  constexpr int faces_per_handle = 100; // of the coarser version: as many as show what its part of the surface looks like
  const Phase_clock::Measurement measurement(context.clock, Phase::FILTER);
  const int handles = 1 - Corner_table(fine.mesh.triangles(), fine.mesh.opposites(),
                                       fine.mesh.number_of_vertices()).euler_characteristic() / 2;
  const int number_of_faces = (std::max)(context.parameters.coarse_number_of_faces, faces_per_handle * handles);
  const Coarse_disk coarse(fine, make_chart(fine.mesh, fine.constraints.mandatory), number_of_faces, context);
  const Cutting_parameters parameters = parameters_on_coarse_mesh(context.parameters);
  Local_filter filter(coarse.problem(), Context{parameters, context.control, context.clock, context.execution});
  Detected_features detected;
  if(!filter.run())
    detected.status = context.control.is_stopped() ? failure(context.control) : Indexed_status();
  detected.number_of_candidates = filter.number_of_candidates();
  detected.features = coarse.lifted(filter.features());
  CGAL::internal::Graph_kernel::add_unique(fine.terminals, detected.features);
  detected.trade_offs = filter.trade_offs();
  return detected;
}

// A third of the work, which tells whether the rest can pay.
inline Cutting_parameters without_moved_ends(Cutting_parameters parameters)
{
  Refinement_goal goal{};
  goal.number_of_solves = parameters.number_of_shortening_solves;
  parameters.number_of_shortening_solves = goal.share_of_solves();
  parameters.moves_ends = false;
  return parameters;
}

// With a bound, one start in about ten leads to a cut far longer than those of others. Starts on a still coarser version
// are so unlike the first that hardly ever all do, and take little time. On request, all are those of the first seeds,
// whatever the given one is; if that is none of these, its start comes last.
inline std::vector<Cutting_parameters> parameters_of_starts(const Cutting_parameters& given)
{
  constexpr double relative_size = 0.5; // of the still coarser version, in faces
  Cutting_parameters still_coarser = given;
  still_coarser.coarse_number_of_faces = int(relative_size * given.coarse_number_of_faces);
  if(!given.adds_start)
    return {given, still_coarser};
  std::vector<Cutting_parameters> starts(1, given);
  starts.front().random_seed = 0;
  for(unsigned int seed = 0; seed < number_of_first_seeds; ++seed)
  {
    starts.push_back(still_coarser);
    starts.back().random_seed = seed;
  }
  if(given.random_seed >= number_of_first_seeds)
    starts.push_back(still_coarser);
  return starts;
}

// Whether several starts on coarser versions are compared.
inline bool compares_starts(const Problem& problem, const Cutting_parameters& parameters)
{
  return parameters.moves_ends && problem.is_sphere && is_coarsened(problem, parameters) && !searches(problem, parameters);
}

// The seeds of those; runs with the same ones, and otherwise the same parameters, find the same. None if there are none.
inline std::vector<unsigned int> seeds_of_compared_starts(const Problem& problem, const Cutting_parameters& parameters)
{
  std::vector<unsigned int> seeds;
  if(compares_starts(problem, parameters))
    for(const Cutting_parameters& start : parameters_of_starts(parameters))
      seeds.push_back(start.random_seed);
  return seeds;
}

// Cuts of a still coarser version are longer: the most promising one takes the place of the first only where that is bad,
// and its ends move only where it is shorter than the first before these have moved. That of the given seed is preferred
// only if it is clearly better: so few runs depend on it.
inline Detected_features cheapest_features_of_starts(const Problem& problem, int first_start, const Context& context)
{
  constexpr double clearly = 0.98; // times the cost; less may be due to the coarser version
  const std::vector<Cutting_parameters> starts = parameters_of_starts(context.parameters);
  std::vector<Detected_features> found(starts.size());
  const Coarse_mesh still_coarser
    = coarser_version(problem, Context{starts.back(), context.control, context.clock, context.execution});
  const auto found_with = [&](const Cutting_parameters& parameters, Run_control& control)
  {
    return rough_features(problem, still_coarser, first_start + 1,
                                          Context{parameters, control, context.clock, context.execution});
  };
  execute(context.execution, int(starts.size()), [&](int i)
  {
    Run_control control(context.control, Run_control::share_of_detection() / double(starts.size()));
    found[i] = i > 0 ? found_with(without_moved_ends(starts[i]), control)
                     : coarse_features(problem, first_start, Context{starts[i], control, context.clock, context.execution});
  });
  const auto rank = [&](std::size_t i)
  {
    const bool is_of_first_seeds = i <= number_of_first_seeds;
    return std::make_pair(context.parameters.excess(found[i].energy), found[i].cost / (is_of_first_seeds ? 1 : clearly));
  };
  std::size_t promising = 0;
  for(std::size_t i = 1; i < found.size(); ++i)
    if(found[i].status && found[i].cost < found[0].prepared_cost && (promising == 0 || rank(i) < rank(promising)))
      promising = i;
  if(promising == 0)
    return std::move(found[0]);
  found[promising] = found_with(starts[promising], context.control);
  const bool is_better = found[0].status && found[promising].status && rank(promising) < rank(0);
  return std::move(found[is_better ? promising : 0]);
}

// The features that the parameters ask for, found on coarser versions.
inline Detected_features detect_coarse_features(const Problem& problem, int start, const Context& context)
{
  if(searches(problem, context.parameters))
    return find_on_coarse_mesh(problem, coarser_version(problem, context), context,
                               [start](const Problem& coarse, const Context& c)
                               { return Cut_search(coarse, c, true).run(start); });
  if(compares_starts(problem, context.parameters))
    return cheapest_features_of_starts(problem, start, context);
  return coarse_features(problem, start, context);
}

// From one start, or from as many as the parameters say.
inline Detected_features detect_features(const Problem& problem, int start, const Context& context)
{
  if(problem.is_opened)
    return detect_features_of_disk(problem, context);
  if(is_coarsened(problem, context.parameters))
  {
    Detected_features detected = detect_coarse_features(problem, start, context);
    const std::size_t enough = problem.is_sphere ? 2 : 0; // a tree of one point opens nothing
    if(!detected.status || detected.features.size() >= enough)
      return detected;
  }
  else if(searches(problem, context.parameters))
    return Cut_search(problem, context, false).run(start);
  return Feature_detector(problem, context).run(start);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_DETECT_FEATURES_H
