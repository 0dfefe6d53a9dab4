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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_DISTORTION_TREE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_DISTORTION_TREE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/connection/connect_terminals.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The cheapest tree through these points if a way costs less where the map is distorted, by this share for a place as
// distorted as the surface is on average. It is somewhat longer than the shortest one, but a cut lowers the distortion
// all along its way. `distortion`: per vertex; `energy`: its average.
inline Connected_cut distortion_tree(const Problem& problem, const std::vector<int>& points,
                                     const std::vector<double>& distortion, double energy, double share,
                                     const CGAL::internal::Steiner_tree::Options& options, Execution execution,
                                     const Go_further& go_further)
{
  constexpr double ideal = Surface_mesh_parameterization::internal::Symmetric_Dirichlet_energy::ideal;
  constexpr double least_excess = 1e-6; // of a surface that is distorted at all
  const double average_excess = (std::max)(energy - ideal, least_excess);
  const Indexed_mesh& mesh = problem.mesh;
  Edge_constraints constraints = problem.constraints;
  for(int e = 0; e < mesh.number_of_edges(); ++e)
  {
    const int h = mesh.halfedge(e);
    const double excess = (std::max)(0., (distortion[mesh.source(h)] + distortion[mesh.target(h)]) / 2 - ideal);
    constraints.weights[e] /= 1 + share * excess / average_excess;
  }
  return connect_terminals(mesh, constraints, points, options, execution, go_further);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_DISTORTION_TREE_H
