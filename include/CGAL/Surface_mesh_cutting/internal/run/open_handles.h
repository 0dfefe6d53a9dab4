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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_OPEN_HANDLES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_OPEN_HANDLES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/connection/Opening_search.h>
#include <CGAL/Surface_mesh_cutting/internal/connection/connect_terminals.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/handles/Handle_loops.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/dihedral_angles.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Makes loops mandatory that cut the handles (paper, Section 3.3), along a given cut where that is possible.
inline Indexed_status cut_handles_of(Problem& problem, const Context& context)
{
  const Phase_clock::Measurement measurement(context.clock, Phase::CANDIDATES);
  Handle_loops handles = cut_handles(problem.mesh,
                                     problem.initial.is_given() ? problem.initial.guide(problem.constraints)
                                                                : problem.constraints,
                                     context.control);
  problem.constraints.mandatory = std::move(handles.cut);
  return handles.status;
}

// The same constraints, but edges cost less the sharper they are, down by `share` at right angles: maps lose least where
// the surface is bent anyway.
inline Edge_constraints favor_creases(const Indexed_mesh& mesh, Edge_constraints constraints, double share)
{
  constexpr double right_angle = 1.57;
  const std::vector<double> angles = dihedral_angles(mesh);
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    constraints.weights[e] *= 1 - share * (std::min)(1., std::abs(angles[e]) / right_angle);
  return constraints;
}

// Makes a cut to one disk mandatory: loops and a tree through what they leave, and then what that becomes when paths are
// exchanged for cheaper ones. Features are connected to it. Creases decide about distortion, which so many loops
// cause more of than features take back, unless the caller's weights are to be kept.
inline Indexed_status open_to_disk(Problem& problem, const Context& context)
{
  constexpr double share_for_loops = 0.5, share_for_paths = 0.2; // measured; more makes cuts longer
  const Indexed_mesh& mesh = problem.mesh;
  const double crease_factor = context.parameters.has_weights ? 0 : 1;
  Handle_loops handles;
  {
    const Phase_clock::Measurement measurement(context.clock, Phase::CANDIDATES);
    handles = cut_handles(mesh, favor_creases(mesh, problem.constraints, crease_factor * share_for_loops), context.control);
  }
  if(!handles.status)
    return handles.status;
  const Phase_clock::Measurement measurement(context.clock, Phase::CONNECT);
  Edge_constraints constraints = favor_creases(mesh, problem.constraints, crease_factor * share_for_paths);
  constraints.mandatory = std::move(handles.cut);
  Connected_cut connected = connect_terminals(mesh, constraints, problem.terminals,
                                                              context.parameters.connection, context.execution, context.control);
  if(!connected.status)
    return connected.status;
  Opening_search search(mesh, constraints, problem.terminal_marks(), std::move(connected.cut));
  search.run(context.control);
  problem.constraints.mandatory = search.cut();
  problem.is_opened = true;
  return context.control.is_stopped() ? failure(context.control) : Indexed_status();
}

// What has to be open before features are looked for.
inline Indexed_status open_handles(Problem& problem, const Context& context)
{
  if(problem.is_sphere)
    return Indexed_status();
  return problem.has_many_handles && !problem.initial.is_given() ? open_to_disk(problem, context)
                                                                 : cut_handles_of(problem, context);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_OPEN_HANDLES_H
