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
#include <CGAL/Surface_mesh_cutting/internal/detection/Coarse_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/Feature_detector.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/Local_filter.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/coarse_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/run/open_handles.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <algorithm>
#include <utility>
#include <vector>


namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Asks for no more than a coarse map resolves: it misses part of what a slit gains around its end. With this factor, the
// energy at full resolution is as low as that of features found there.
inline Cutting_parameters parameters_on_coarse_mesh(Cutting_parameters parameters)
{
  constexpr double resolved_gain = 0.85;
  parameters.minimum_distortion_decrease *= resolved_gain;
  parameters.decrease_per_cost *= resolved_gain;
  return parameters;
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

inline Coarse_mesh coarser_version(const Problem& fine, int number_of_faces, const Context& context)
{
  const Phase_clock::Measurement measurement(context.clock, Phase::CANDIDATES);
  return Coarse_mesh(fine.mesh, number_of_faces / 2, fine.terminals, context.parameters.linear_solvers->execution);
}

// The same problem on a coarser version, without what cuts handles.
inline Problem coarse_problem(const Problem& fine, const Coarse_mesh& coarse)
{
  const std::vector<int> terminals = coarse.find(fine.terminals);
  return {coarse.mesh, coarse.shapes(), coarse_constraints(fine.mesh, fine.constraints, coarse, terminals),
          terminals, Initial_cut(), fine.is_sphere};
}

// The features of a surface that is opened to a disk, found on a coarser version of that disk.
inline Detected_features detect_features_of_disk(const Problem& fine, const Context& context)
{
  constexpr int faces = 5000, faces_per_handle = 100; // of the coarser version: enough to show its part of the surface
  const Phase_clock::Measurement measurement(context.clock, Phase::FILTER);
  const int handles = 1 - Corner_table(fine.mesh.triangles(), fine.mesh.opposites(),
                                       fine.mesh.number_of_vertices()).euler_characteristic() / 2;
  const int number_of_faces
    = (std::max)(context.parameters.given_coarse_number_of_faces.value_or(faces), faces_per_handle * handles);
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

// The features of a coarser version. Its trade-offs tell too little about the surface.
inline Detected_features detect_coarse_features(const Problem& fine, int number_of_faces, const Context& context)
{
  const Coarse_mesh coarse = coarser_version(fine, number_of_faces, context);
  Problem problem = coarse_problem(fine, coarse);
  Detected_features detected;
  if(!problem.is_sphere)
    detected.status = cut_handles_of(problem, context);
  if(!detected.status)
    return detected;
  const Cutting_parameters parameters = parameters_on_coarse_mesh(context.parameters);
  detected = Feature_detector(problem, Context{parameters, context.control, context.clock, context.execution}).run();
  detected.features = lifted(fine, coarse, detected.features);
  detected.chart = Open_chart();
  detected.trade_offs.clear();
  return detected;
}

// The features of a surface (paper, Section 3.1), on a version of at most about `number_of_faces` (0: on the surface itself).
inline Detected_features detect_features(const Problem& problem, int number_of_faces, const Context& context)
{
  if(problem.is_opened)
    return detect_features_of_disk(problem, context);
  if(number_of_faces > 0 && !problem.initial.is_given() && number_of_faces < problem.mesh.number_of_faces())
  {
    Detected_features detected = detect_coarse_features(problem, number_of_faces, context);
    const std::size_t enough = problem.is_sphere ? 2 : 0; // a tree of one point opens nothing
    if(!detected.status || detected.features.size() >= enough)
      return detected;
  }
  return Feature_detector(problem, context).run();
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_DETECT_FEATURES_H
