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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_SET_EFFORT_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_SET_EFFORT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Effort.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Cutting_parameters.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The sizes and budgets were found by measuring (see benchmark/constants); all count work, not seconds.
inline void set_effort(Effort effort, Cutting_parameters& p)
{
  const bool has_bound = p.has_bound();
  p.coarse_number_of_faces = p.given_coarse_number_of_faces.value_or(5000);
  p.is_coarser_where_small = effort == Effort::FAST && !has_bound && !p.given_coarse_number_of_faces;
  p.number_of_corrective_solves = has_bound ? 8 : 0;
  p.moves_ends = false;
  p.opens_slits_first = has_bound && effort != Effort::FAST;
  p.ends_early_in_room = !has_bound && effort == Effort::FAST;
  p.effort = effort;
  switch(effort)
  {
  case Effort::FAST:
    p.number_of_starts = 1;
    p.number_of_combinations = 0;
    p.number_of_shortening_solves = has_bound ? 20 : 0;
    break;
  case Effort::DEFAULT:
    p.number_of_starts = has_bound ? 1 : 3; // at a bound, moving ends takes the solves
    p.number_of_combinations = 0;
    p.number_of_shortening_solves = has_bound ? 60 : 8;
    p.moves_ends = has_bound;
    break;
  case Effort::BEST:
    p.number_of_starts = 10;
    p.number_of_combinations = 7;
    p.number_of_shortening_solves = has_bound ? 300 : 60;
    p.moves_ends = has_bound;
    break;
  }
}

// The same with another effort.
inline Cutting_parameters with_effort(Effort effort, Cutting_parameters parameters)
{
  set_effort(effort, parameters);
  parameters.adapt_effort_to_weights();
  return parameters;
}

constexpr unsigned int number_of_first_seeds = 3;

// Of the first cuts that runs may begin with: the given seed, and the first ones. Where no first cut is looked for, seeds
// make no difference.
inline std::vector<unsigned int> seeds_of_runs(const Cutting_parameters& parameters, bool has_seeds)
{
  std::vector<unsigned int> seeds(1, parameters.random_seed);
  for(unsigned int seed = 0; has_seeds && seed < number_of_first_seeds; ++seed)
    if(seed != parameters.random_seed)
      seeds.push_back(seed);
  return seeds;
}

// The runs that follow one at a bound where it is not good enough. They do not depend on the given seed.
inline std::vector<Cutting_parameters> further_runs(const Cutting_parameters& parameters, bool has_seeds)
{
  std::vector<Cutting_parameters> runs;
  for(unsigned int seed = 1; has_seeds && seed < number_of_first_seeds; ++seed)
  {
    runs.push_back(parameters);
    runs.back().random_seed = seed;
    runs.back().adds_start = false;
  }
  return runs;
}

// The runs of which the best result is returned. The best effort contains the smaller ones, also from the first seeds,
// so that it is no worse than these.
inline std::vector<Cutting_parameters> portfolio(const Cutting_parameters& parameters, bool has_seeds)
{
  if(parameters.effort != Effort::BEST)
    return {parameters};
  std::vector<Cutting_parameters> runs;
  for(Effort effort : {Effort::DEFAULT, Effort::FAST})
  {
    for(unsigned int seed : seeds_of_runs(parameters, has_seeds))
    {
      runs.push_back(with_effort(effort, parameters));
      runs.back().random_seed = seed;
    }
    if(effort == Effort::DEFAULT && parameters.has_bound())
      for(const Cutting_parameters& further : further_runs(runs.back(), has_seeds))
        runs.push_back(further);
  }
  runs.push_back(parameters); // last, since it takes longest
  return runs;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_SET_EFFORT_H
