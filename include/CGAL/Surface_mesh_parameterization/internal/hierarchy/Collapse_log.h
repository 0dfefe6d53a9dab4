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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_COLLAPSE_LOG_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_COLLAPSE_LOG_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Half-edge collapses in their order, with all that it takes to undo them.
struct Collapse_log
{
  struct Collapse
  {
    int vertex, first_corner, first_halfedge;
    int triangles[2]; // that went, or -1
  };

  int size() const { return int(collapses.size()); }

  std::vector<Collapse> collapses;
  std::vector<int> moved_corners;
  std::vector<std::pair<int, int> > former_halfedges; // of vertices
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_COLLAPSE_LOG_H
