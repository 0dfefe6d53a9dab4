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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_RUN_PLAN_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_RUN_PLAN_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Effort.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Cutting_parameters.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>

#include <algorithm>
#include <cmath>


namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The work of a run, decided once from the parameters and the size of the surface. Solves are of the whole surface on which
// the cut is searched for.
struct Run_plan
{
  int number_of_faces = 0;       // of the coarser version on which a cut is searched for; 0: the surface itself
  int number_of_starts = 1;      // whose features are detected, connected, and mapped
  int number_of_solves = 0;      // at most, for shortening each of them
  int rounds_of_moved_ends = 0;  // at most
  int corrective_solves = 0;     // at most, on the surface itself if the search was on a coarser version

  int number_of_prepared() const { return (number_of_starts + 1) / 2; }    // the better half, brought to the bound
  int number_of_refined() const { return (number_of_prepared() + 1) / 2; } // the better half of these, refined further
  int number_of_finalists() const { return (std::min)(number_of_prepared(), 4); } // at most, finished where room is short

  bool is_coarsened() const { return number_of_faces > 0; }
  bool refines() const { return number_of_solves > 0; }
};

inline Run_plan make_plan(Effort effort, const Cutting_parameters& parameters, const Problem& problem)
{
  constexpr double least_ratio = 1.25; // a mesh only little larger than the target would not become much simpler
  const int all_faces = problem.mesh.number_of_faces();
  const bool has_bound = parameters.has_bound(), is_given = problem.initial.is_given();
  Run_plan plan;
  const int target = parameters.given_coarse_number_of_faces.value_or(parameters.use_published_method ? 0 : 5000);
  if(target > 0 && !is_given && !problem.is_opened && all_faces > least_ratio * target)
    plan.number_of_faces = target;
  if(parameters.use_published_method)
    return plan;
  const int faces = plan.is_coarsened() ? plan.number_of_faces : all_faces;
  const auto affordable = [faces](int most, int work) { return std::clamp(work / faces, 1, most); };
  constexpr int most_starts = 24;
  const int length_of_way = has_bound ? 3 : 1; // without a bound, a cut is near its optimum from the start
  switch(effort)
  {
  case Effort::FAST:
    plan.number_of_solves = !has_bound && parameters.needs_optimal_tree ? 0 : affordable(24, 20000 * length_of_way);
    break;
  case Effort::DEFAULT:
    plan.number_of_starts = std::clamp(int(400 / std::sqrt(double(faces))), 1, most_starts); // small ones vary more
    plan.number_of_solves = affordable(60, 100000 * length_of_way);
    plan.rounds_of_moved_ends = has_bound ? 2 : 1;
    break;
  case Effort::BEST:
    plan.number_of_starts = most_starts;
    plan.number_of_solves = affordable(200, 500000 * length_of_way);
    plan.rounds_of_moved_ends = 3;
    break;
  }
  if(is_given || problem.is_opened)
    plan.number_of_starts = 1;
  if(problem.is_opened || problem.has_many_handles) // too many ends
    plan.rounds_of_moved_ends = 0;
  if(has_bound || effort == Effort::BEST)
    plan.corrective_solves = 8;
  return plan;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_RUN_PLAN_H
