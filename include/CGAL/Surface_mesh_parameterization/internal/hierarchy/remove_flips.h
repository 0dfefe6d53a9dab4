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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_REMOVE_FLIPS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_REMOVE_FLIPS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/exact_flips.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/energies.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Chart_hierarchy.h>

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Makes a map with a few flipped triangles flip-free, by progressive embedding [SJZP19]: vertices
// around the flips are collapsed and put back, each where it is as conformal as possible. `points`
// holds the position of each chart vertex on the surface. False if flips remain, or would take more
// collapses; then `uv` is not valid. About linear in the size of the chart.
inline bool remove_flips(const Corner_table& chart, const std::vector<Eigen::Vector3d>& points,
                         std::vector<Eigen::Vector2d>& uv,
                         int maximum_number_of_collapses = (std::numeric_limits<int>::max)())
{
  Chart_hierarchy hierarchy(chart, points);
  return hierarchy.collapse_flips(uv, maximum_number_of_collapses) &&
         hierarchy.refine_to<MIPS_energy>(chart.number_of_vertices(), uv) &&
         count_flips(chart.triangles(), uv) == 0;
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_REMOVE_FLIPS_H
