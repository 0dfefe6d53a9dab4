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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_COARSE_SLITS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_COARSE_SLITS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/detection/Coarse_disk.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/final_map.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Injective_refiner.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

constexpr int coarse_slits_number_of_faces = 2500;

// Whether a coarser version of the surface has so many triangles less that slits are found there in a fraction of the time.
inline bool has_coarse_slits(const Problem& problem, const Cutting_parameters& parameters)
{
  constexpr int least_ratio = 3;
  return !parameters.has_bound() && problem.mesh.number_of_faces() > least_ratio * coarse_slits_number_of_faces;
}

// Where slits have to end for the energy of the map without overlaps to fall by `decrease`, found on a coarser version of
// the disk `chart`; in the order in which they were opened. Where parts are in each other's way is a matter of their shape,
// which the coarser version has, too.
inline std::vector<int> coarse_slits(const Problem& problem, const Context& context, const Corner_table& chart,
                                     double decrease)
{
  constexpr double margin = 1.5; // slits gain a little less on the surface itself
  const Coarse_disk coarse(problem, chart, coarse_slits_number_of_faces, context);
  const Indexed_mesh& mesh = coarse.problem().mesh;
  Open_chart overlapping;
  overlapping.cut = coarse.problem().constraints.mandatory;
  overlapping.chart = make_chart(mesh, overlapping.cut);
  const Newton_options options = final_options(context);
  const Newton_result isometric
    = Chart_parameterizer(overlapping.chart, chart_points(mesh, overlapping.chart), coarse.problem().shapes,
                          *context.parameters.linear_solvers).isometric_map(overlapping.uv, options);
  if(isometric.outcome == Newton_outcome::FAILED)
    return {};
  overlapping.energy = isometric.energy;
  overlapping.precision = options.decrement;
  Injective_cut injective{overlapping.cut, overlapping.chart, {}, {}};
  const Newton_result newton = final_map(coarse.problem(), overlapping, context, injective.map.uv);
  if(newton.outcome == Newton_outcome::FAILED)
    return {};
  injective.map.energy = newton.energy;
  const double goal = (std::max)(newton.energy - margin * decrease, isometric.energy);
  Injective_refiner(coarse.problem(), context, overlapping).lower_to(goal, injective);
  return coarse.lifted(injective.ends);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_COARSE_SLITS_H
