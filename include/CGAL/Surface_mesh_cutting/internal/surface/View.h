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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_VIEW_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_VIEW_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <Eigen/Core>

#include <limits>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// From where an edge is looked at.
struct View
{
  int number_of_rays = 64;
  unsigned int random_seed = 0;
  // The rays fill the hemisphere around this axis or, if it is zero, around the normal of the edge.
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  // Otherwise their density is the cosine of the angle with the axis.
  bool is_uniform = false;
  // How far the surface blocks the view, in bounding box diagonals.
  double radius = std::numeric_limits<double>::infinity();
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_VIEW_H
