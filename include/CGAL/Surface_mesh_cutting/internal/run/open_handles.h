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

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Makes loops mandatory that cut the handles (paper, Section 3.3), along a given cut where that is possible.
inline Indexed_status cut_handles_of(Problem& problem, const Context& context)
{
  if(problem.is_sphere)
    return Indexed_status();
  const Phase_clock::Measurement measurement(context.clock, Phase::CANDIDATES);
  Handle_loops handles = cut_handles(problem.mesh,
                                     problem.initial.is_given() ? problem.initial.guide(problem.constraints)
                                                                : problem.constraints,
                                     context.control);
  problem.constraints.mandatory = std::move(handles.cut);
  return handles.status;
}

// Whether the loops leave so many borders that no tree through them, and through features on the way, would be proven
// shortest.
inline bool has_many_borders(const Problem& problem, const Cutting_parameters& parameters)
{
  if(problem.is_sphere || problem.initial.is_given())
    return false;
  const std::size_t borders = make_chart(problem.mesh, problem.constraints.mandatory).border_loops().size();
  return borders + problem.terminals.size() > parameters.connection.maximum_number_of_terminals;
}

// Makes a cut to one disk mandatory: loops and a tree through what they leave, and then what that becomes when paths are
// exchanged for cheaper ones. Features are connected to it.
template <typename ConcurrencyTag>
Indexed_status open_to_disk(Problem& problem, const Context& context)
{
  const Phase_clock::Measurement measurement(context.clock, Phase::CONNECT);
  Connected_cut connected = connect_terminals<ConcurrencyTag>(problem.mesh, problem.constraints, problem.terminals,
                                                              context.parameters.connection, context.control);
  if(!connected.status)
    return connected.status;
  std::vector<char> is_kept(problem.mesh.number_of_vertices(), 0);
  for(int v : problem.terminals)
    is_kept[v] = 1;
  Opening_search search(problem.mesh, problem.constraints, std::move(is_kept), std::move(connected.cut));
  search.run(context.control);
  problem.constraints.mandatory = search.cut();
  problem.is_opened = true;
  return context.control.is_stopped() ? failure(context.control) : Indexed_status();
}

// What has to be open before features are looked for.
template <typename ConcurrencyTag>
Indexed_status open_handles(Problem& problem, const Context& context)
{
  const Indexed_status status = cut_handles_of(problem, context);
  return status && has_many_borders(problem, context.parameters) ? open_to_disk<ConcurrencyTag>(problem, context)
                                                                 : status;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_OPEN_HANDLES_H
