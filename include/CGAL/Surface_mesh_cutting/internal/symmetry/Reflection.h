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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_REFLECTION_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_REFLECTION_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <Eigen/Core>

#include <cmath>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The reflection at the plane of the points p with normal . p = offset.
struct Reflection
{
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX(); // a unit vector
  double offset = 0;

  double signed_distance(const Point& p) const { return normal.dot(p) - offset; }
  Point operator()(const Point& p) const { return p - 2 * signed_distance(p) * normal; }

  // The same plane with the normal of which the largest coordinate is positive.
  Reflection oriented() const
  {
    int largest = 0;
    for(int i = 1; i < 3; ++i)
      if(std::abs(normal[i]) > std::abs(normal[largest]))
        largest = i;
    return normal[largest] < 0 ? Reflection{-normal, -offset} : *this;
  }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_REFLECTION_H
