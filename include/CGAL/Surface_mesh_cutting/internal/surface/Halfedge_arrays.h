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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_HALFEDGE_ARRAYS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_HALFEDGE_ARRAYS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The halfedges of the faces of a manifold. Those of the border, if they are numbered, have no next one and nothing else.
struct Halfedge_arrays
{
  std::vector<int> next, previous;
  std::vector<int> opposite; // -1 at the border
  std::vector<int> target;   // vertex
  std::vector<Eigen::Vector3d> points;

  int number_of_halfedges() const { return int(next.size()); }
  int source(int h) const { return target[previous[h]]; }
  double length(int h) const { return (points[target[h]] - points[source(h)]).norm(); }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_HALFEDGE_ARRAYS_H
