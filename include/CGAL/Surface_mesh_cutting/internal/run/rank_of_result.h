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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_RANK_OF_RESULT_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_RANK_OF_RESULT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Cutting_parameters.h>
#include <CGAL/Surface_mesh_cutting/internal/result/Component_result.h>

#include <limits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The smaller, the better: the cheaper one that keeps the bound; without a bound, cost counts as much as where features are
// accepted, so that no other result is better in both.
inline std::pair<double, double> rank_of_result(const Component_result& result, const Cutting_parameters& parameters)
{
  return {result.has_map ? parameters.excess(result.energy) : std::numeric_limits<double>::infinity(),
          parameters.has_bound() ? result.cost : result.energy + parameters.decrease_per_cost * result.cost};
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_RANK_OF_RESULT_H
