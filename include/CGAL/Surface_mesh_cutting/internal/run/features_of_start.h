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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_FEATURES_OF_START_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_FEATURES_OF_START_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/detection/Coarse_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/coarse_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/Feature_detector.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/refine.h>
#include <CGAL/Surface_mesh_cutting/internal/run/open_handles.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sort_unique.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Whether features are found on a coarser version. A mesh only little larger than the target would not become much
// simpler. A given cut lies on the surface itself.
inline bool is_coarsened(const Problem& problem, const Cutting_parameters& parameters)
{
  constexpr double least_ratio = 1.25;
  return parameters.coarse_number_of_faces > 0 && !problem.initial.is_given() &&
         problem.mesh.number_of_faces() > least_ratio * parameters.coarse_number_of_faces;
}

// Whether a connected cut is refined where its features were found.
inline bool refines(const Problem& problem, const Cutting_parameters& parameters)
{
  return parameters.has_bound() || problem.initial.is_given() || parameters.number_of_shortening_solves > 0;
}

// Asks for no more than a coarse map resolves.
inline Cutting_parameters parameters_on_coarse_mesh(const Cutting_parameters& parameters)
{
  Cutting_parameters result = parameters;
  result.minimum_distortion_decrease *= parameters.resolved_gain;
  result.decrease_per_cost *= parameters.resolved_gain;
  return result;
}

// Keeps those of the features that a cut through them needs once it is refined.
inline void refine_features(const Problem& problem, const Context& context, Detected_features& detected)
{
  const Phase_clock::Measurement measurement(context.clock, Phase::REFINE);
  const Cutting_parameters& parameters = context.parameters;
  Cut_refiner refiner(problem, context);
  if(refiner.connect(detected.features, !detected.is_hopeless) && refiner.map())
  {
    constexpr bool keeps_tree = true; // only the features are handed on
    constexpr int rounds_of_moved_ends = 3;
    Refinement_goal goal{parameters.maximum_average_distortion, detected.repair_threshold,
                         parameters.number_of_shortening_solves, keeps_tree, rounds_of_moved_ends};
    if(parameters.moves_ends && parameters.has_bound())
    {
      if(prepare_to_move_ends(refiner, goal))
        detected.prepared_cost = refiner.cut().cost();
      goal.is_prepared = true;
    }
    refine(refiner, goal, parameters);
    detected.features = refiner.cut().features();
    detected.cost = refiner.cut().cost();
    detected.energy = refiner.cut().energy();
  }
  detected.trade_offs.insert(detected.trade_offs.end(), refiner.cut().trade_offs().begin(), refiner.cut().trade_offs().end());
  if(context.control.is_stopped())
    detected.status = failure(context.control);
}

// The features on the surface itself that are reachable there, and its terminals.
inline std::vector<int> lifted(const Problem& fine, const Coarse_mesh& coarse, const std::vector<int>& features)
{
  const std::vector<char> is_reachable = reachable_vertices(fine.mesh, fine.constraints);
  std::vector<int> result = fine.terminals;
  for(int v : features)
    if(is_reachable[coarse.vertices[v]])
      result.push_back(coarse.vertices[v]);
  CGAL::internal::Graph_kernel::sort_unique(result);
  return result;
}

inline Coarse_mesh coarser_version(const Problem& fine, const Context& context)
{
  const Phase_clock::Measurement measurement(context.clock, Phase::CANDIDATES);
  return Coarse_mesh(fine.mesh, context.parameters.coarse_number_of_faces / 2, fine.terminals,
                     context.parameters.linear_solvers->execution);
}

// What `find(problem, context)` finds on a coarser version. Unreachable features are removed when lifted.
template <typename Find>
Detected_features find_on_coarse_mesh(const Problem& fine, const Coarse_mesh& coarse, const Context& context,
                                      const Find& find)
{
  const std::vector<int> terminals = coarse.find(fine.terminals);
  Problem problem{coarse.mesh, coarse.shapes(), coarse_constraints(fine.mesh, fine.constraints, coarse, terminals),
                  terminals, Initial_cut(), fine.is_sphere};
  Detected_features detected;
  if(!problem.is_sphere)
    detected.status = cut_handles_of(problem, context);
  if(!detected.status)
    return detected;
  detected = find(problem, context);
  detected.features = lifted(fine, coarse, detected.features);
  detected.chart = Open_chart();
  return detected;
}

// Features from one start on a coarser version, where refining them is cheap.
inline Detected_features refined_features(const Problem& problem, int start, const Context& context)
{
  const Cutting_parameters parameters = parameters_on_coarse_mesh(context.parameters);
  Detected_features detected
    = Feature_detector(problem, Context{parameters, context.control, context.clock, context.execution}).run(start);
  if(detected.status && refines(problem, context.parameters))
    refine_features(problem, context, detected);
  return detected;
}

// The same on a coarser version of the problem's surface.
inline Detected_features coarse_features(const Problem& problem, const Coarse_mesh& coarse, int start, const Context& context)
{
  return find_on_coarse_mesh(problem, coarse, context, [start](const Problem& p, const Context& c)
                             { return refined_features(p, start, c); });
}

inline Detected_features coarse_features(const Problem& problem, int start, const Context& context)
{
  return coarse_features(problem, coarser_version(problem, context), start, context);
}

// Those of so coarse a version that its trade-offs tell too little about the surface.
inline Detected_features rough_features(const Problem& problem, const Coarse_mesh& coarse, int start, const Context& context)
{
  Detected_features detected = coarse_features(problem, coarse, start, context);
  detected.trade_offs.clear();
  return detected;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_FEATURES_OF_START_H
