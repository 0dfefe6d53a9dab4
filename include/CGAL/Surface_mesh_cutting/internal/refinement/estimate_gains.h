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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_ESTIMATE_GAINS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_ESTIMATE_GAINS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/mapping/Incremental_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A path from a vertex inside the surface to the cut, and about what opening it would gain.
struct Slit
{
  int tip = -1;
  std::vector<int> edges;
  double cost = 0, gain = 0;

  double gain_per_cost() const
  {
    return cost > 0 ? gain / cost : gain > 0 ? std::numeric_limits<double>::infinity() : 0;
  }
};

// Estimates what each of the slits gains. With several threads, each works on a copy of the map, which takes far less time
// than a window.
inline void estimate_gains(Incremental_parameterization& map, std::vector<Slit>& slits)
{
  using Surface_mesh_parameterization::internal::Execution;
  constexpr int most_workers = 4; // each takes memory proportional to the surface
  std::atomic<int> next{0};
  const auto estimate_with = [&](Incremental_parameterization& worker)
  {
    for(int i = next++; i < int(slits.size()); i = next++)
      slits[i].gain = worker.estimate_gain(slits[i].edges);
  };
  const Execution execution = map.policy().linear_solvers.execution;
  const int workers = (std::min)({number_of_threads(execution), int(slits.size()), most_workers});
  if(workers < 2)
    return estimate_with(map);
  execute(execution, workers, [&](int)
  {
    if(next >= int(slits.size())) // others were faster
      return;
    Incremental_parameterization copy(map);
    estimate_with(copy);
  });
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_ESTIMATE_GAINS_H
