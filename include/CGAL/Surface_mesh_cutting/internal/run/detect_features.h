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
#include <CGAL/Surface_mesh_cutting/internal/detection/threads.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Cut_search.h>
#include <CGAL/Surface_mesh_cutting/internal/run/features_of_start.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sort_unique.h>

#include <algorithm>
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
  Local_filter filter(coarse.problem(), Context{parameters, context.control, context.clock});
  Detected_features detected;
  if(!filter.run())
    detected.status = context.control.is_stopped() ? failure(context.control) : Indexed_status();
  detected.number_of_candidates = filter.number_of_candidates();
  detected.features = coarse.lifted(filter.features());
  CGAL::internal::Graph_kernel::add_unique(fine.terminals, detected.features);
  detected.trade_offs = filter.trade_offs();
  return detected;
}

// With a bound, one start in about ten leads to a cut far longer than those of others. A second start on a still coarser
// version is so unlike the first that hardly ever both do, and takes little time. Cuts of so coarse a version are longer:
// the second one takes the place of the first only where that is bad.
template <typename ConcurrencyTag>
Detected_features cheaper_features_of_two_starts(const Problem& problem, int first_start, const Context& context)
{
  constexpr double relative_size = 0.5; // of the second version, in faces
  Cutting_parameters still_coarser = context.parameters;
  still_coarser.coarse_number_of_faces = int(relative_size * still_coarser.coarse_number_of_faces);
  Detected_features first, second;
  for_each_index_in_isolation<ConcurrencyTag>(2, [&](int i)
  {
    if(i == 0)
      first = coarse_features<ConcurrencyTag>(problem, first_start, context);
    else
      second = rough_features<ConcurrencyTag>(problem, first_start + 1,
                                              Context{still_coarser, context.control, context.clock});
  });
  const auto rank = [&](const Detected_features& f)
  { return std::make_pair(context.parameters.excess(f.energy), f.cost); };
  return first.status && second.status && rank(second) < rank(first) ? second : first;
}

// The features that the parameters ask for, found on coarser versions.
template <typename ConcurrencyTag>
Detected_features detect_coarse_features(const Problem& problem, int start, const Context& context)
{
  if(searches(problem, context.parameters))
    return find_on_coarse_mesh(problem, context, [start](const Problem& coarse, const Context& c)
                               { return Cut_search<ConcurrencyTag>(coarse, c, true).run(start); });
  if(context.parameters.moves_ends && problem.is_sphere)
    return cheaper_features_of_two_starts<ConcurrencyTag>(problem, start, context);
  return coarse_features<ConcurrencyTag>(problem, start, context);
}

// From one start, or from as many as the parameters say.
template <typename ConcurrencyTag>
Detected_features detect_features(const Problem& problem, int start, const Context& context)
{
  if(problem.is_opened)
    return detect_features_of_disk(problem, context);
  if(is_coarsened(problem, context.parameters))
  {
    Detected_features detected = detect_coarse_features<ConcurrencyTag>(problem, start, context);
    const std::size_t enough = problem.is_sphere ? 2 : 0; // a tree of one point opens nothing
    if(!detected.status || detected.features.size() >= enough)
      return detected;
  }
  else if(searches(problem, context.parameters))
    return Cut_search<ConcurrencyTag>(problem, context, false).run(start);
  return Feature_detector<ConcurrencyTag>(problem, context).run(start);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_DETECT_FEATURES_H
