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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_CONNECT_INDEXED_POINTS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_CONNECT_INDEXED_POINTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/connection/connect_terminals.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/handles/Handle_loops.h>
#include <CGAL/Surface_mesh_cutting/internal/input/restrict_to_feasible_component.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/lengths.h>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

CGAL_INLINE_UNLESS_SEPARATE
Connected_cut connect_indexed_points(const Indexed_mesh& mesh, Edge_constraints constraints,
                                     const std::vector<int>& terminals, const Cutting_parameters& parameters,
                                     Execution execution, const Go_further& go_further)
{
  Connected_cut result;
  result.status = check_no_edge_is_mandatory_and_forbidden(mesh, constraints);
  if(result.status)
    result.status = restrict_to_feasible_components(mesh, terminals, constraints);
  if(!result.status)
    return result;
  const Handle_loops handles = cut_handles_of_components(mesh, constraints, go_further);
  result.status = handles.status;
  if(!result.status)
    return result;
  constraints.mandatory = handles.cut;
  CGAL::internal::Steiner_tree::Options options = parameters.connection;
  options.minimum_length_decrease = parameters.minimum_length_decrease * bounding_box_diagonal(mesh);
  result = connect_terminals(mesh, constraints, terminals, options, execution, go_further);
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    if(constraints.mandatory[e])
    {
      result.weight += constraints.weights[e];
      result.lower_bound += constraints.weights[e];
    }
  if(result.status && parameters.needs_optimal_tree && !result.is_optimal)
    result.status = Indexed_status(Status_code::BOUND_NOT_REACHED,
                                   "the connection is not proven shortest");
  return result;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_CONNECT_INDEXED_POINTS_H
