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

#ifndef CGAL_SURFACE_MESH_CUTTING_CONNECTION_H
#define CGAL_SURFACE_MESH_CUTTING_CONNECTION_H

#include <CGAL/license/Surface_mesh_cutting.h>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// how to connect the feature points; the value of the named parameter `connection`.
/// \sa `CGAL::steiner_tree()`
enum class Connection
{
  METRIC_CLOSURE,          ///< the minimum spanning tree of the shortest paths between all points
  SHORTEST_PATH_HEURISTIC, ///< a tree that grows by the path to the nearest point outside
  GREEDY,                  ///< auxiliary points, added one by one and, except with `use_published_method(true)`, then
                           ///< exchanged
  EXACT,                   ///< a shortest tree, or `Status_code::BOUND_NOT_REACHED` beyond the budget. An improved cut need
                           ///< not be a shortest tree any more, see `Cut_result::is_optimal`
  BEST                     ///< a shortest tree within the budget, otherwise the best tree found and a lower bound
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_CONNECTION_H
