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

#ifndef CGAL_SURFACE_MESH_CUTTING_EFFORT_H
#define CGAL_SURFACE_MESH_CUTTING_EFFORT_H

#include <CGAL/license/Surface_mesh_cutting.h>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// how much work is put into a short cut; passed by the named parameter `effort`.
enum class Effort
{
  FAST,    ///< no more than feature points and the tree through them, unless `maximum_distortion` asks for more
  DEFAULT, ///< then a few attempts to shorten the cut at about the same distortion
  BEST     ///< several starts at full resolution and many such attempts, the best result is kept
};

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// how the feature points are connected; passed by the named parameter `connection`.
/// \sa `CGAL::steiner_tree()`
enum class Connection
{
  METRIC_CLOSURE,          ///< the minimum spanning tree of the shortest paths between all points
  SHORTEST_PATH_HEURISTIC, ///< grows a tree by the path to the nearest point outside
  GREEDY,                  ///< auxiliary points, added one by one; then exchanged, except with `faithful(true)`
  EXACT,                   ///< the shortest tree, or `Status_code::BOUND_NOT_REACHED` beyond the budget
  BEST                     ///< the shortest tree within a budget, else the best one found and a lower bound
};

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// how the conformal maps are computed from which candidates for feature points are read; passed by
/// the named parameter `conformal_solver`.
enum class Conformal_solver
{
  KP_NEWTON, ///< minimizes the MIPS energy, as in the paper
  SPECTRAL   ///< spectral conformal parameterization, repaired where it flips triangles: one factorization
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_EFFORT_H
