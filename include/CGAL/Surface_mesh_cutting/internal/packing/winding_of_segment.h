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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_WINDING_OF_SEGMENT_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_WINDING_OF_SEGMENT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <Eigen/Core>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// What a segment adds to the winding number of a polygon around a point: how often it passes at the right, from below to
// above.
inline int winding_of_segment(const Eigen::Vector2d& source, const Eigen::Vector2d& target, const Eigen::Vector2d& p)
{
  if((source.y() <= p.y()) == (target.y() <= p.y()))
    return 0;
  const Eigen::Vector2d d = target - source, q = p - source;
  const double area = d.x() * q.y() - d.y() * q.x();
  return d.y() > 0 && area > 0 ? 1 : d.y() < 0 && area < 0 ? -1 : 0;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_WINDING_OF_SEGMENT_H
