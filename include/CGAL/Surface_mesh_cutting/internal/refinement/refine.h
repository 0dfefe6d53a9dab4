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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_REFINE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_REFINE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/refinement/Cut_refiner.h>

#include <algorithm>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// What refinement aims at.
struct Refinement_goal
{
  double bound;            // of the running map's energy, if there is a bound at all
  double repair_threshold; // see `Detected_features`; without a bound
  int number_of_solves;    // at most, for shortening
  bool keeps_tree = false; // see `Refinement_limits`
  int rounds_of_moved_ends = 0; // at most, if the parameters say that ends move
  double least_limit = 0;  // of the energy, without a bound: so much is allowed in any case
  bool is_prepared = false; // by prepare_to_move_ends()

  // Before and after ends move, which takes the rest.
  int share_of_solves() const
  {
    constexpr int share = 3;
    return number_of_solves / share;
  }
};

// The first part of refine() where ends move at a bound. It takes about a third of the time, and tells which of several
// cuts are worth the rest. False if the bound is not reached.
inline bool prepare_to_move_ends(Cut_refiner& refiner, const Refinement_goal& goal)
{
  if(!refiner.reduce_distortion_to(goal.bound))
    return false;
  Refinement_limits limits;
  limits.keeps_tree = goal.keeps_tree;
  limits.number_of_solves = goal.share_of_solves();
  limits.energy = goal.bound;
  refiner.shorten(limits);
  return true;
}

// Where edges have weights, cheap slits make room for the loss of expensive branches, whose ends move.
inline void use_cheap_places(Cut_refiner& refiner, Refinement_limits limits, double energy_per_cost)
{
  constexpr int number_of_branches = 2; // whose ends move
  limits.energy_per_cost = energy_per_cost;
  refiner.open_cheap_slits(energy_per_cost);
  refiner.move_ends(limits, number_of_branches);
}

// Lowers the energy to the bound if there is one, then shortens, and moves ends on request. Without a bound, what the
// tree through the features loses against the filter's cut, or a given one, is gained back where it pays.
inline void refine(Cut_refiner& refiner, const Refinement_goal& goal, const Cutting_parameters& parameters)
{
  Refinement_limits limits;
  limits.keeps_tree = goal.keeps_tree;
  limits.number_of_solves = goal.number_of_solves;
  if(parameters.has_bound())
  {
    if(!goal.is_prepared)
      refiner.reduce_distortion_to(goal.bound);
    limits.energy = (std::max)(goal.bound, refiner.cut().chart().energy);
  }
  else
  {
    refiner.reduce_distortion_to(goal.repair_threshold, parameters.decrease_per_cost);
    limits.energy = (std::max)(goal.least_limit,
                               refiner.cut().chart().energy + parameters.minimum_distortion_decrease);
    limits.energy_per_cost = parameters.decrease_per_cost;
  }
  if(parameters.has_weights && goal.number_of_solves > 0)
    use_cheap_places(refiner, limits, parameters.decrease_per_cost);
  if(goal.rounds_of_moved_ends > 0 && parameters.moves_ends && refiner.cut().energy() <= goal.bound)
  {
    constexpr int least_solves = 8; // after: moved ends leave some room below the bound
    limits.number_of_solves = goal.share_of_solves();
    if(!goal.is_prepared)
      refiner.shorten(limits);
    refiner.move_ends_at_bound(goal.keeps_tree, goal.rounds_of_moved_ends);
    limits.number_of_solves = (std::max)(limits.number_of_solves, least_solves);
  }
  refiner.shorten(limits);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_REFINE_H
