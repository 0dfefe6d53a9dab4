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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_WELDING_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_WELDING_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Which vertices of a soup count as one.
struct Welding
{
  enum Mode { OFF, ON, AUTO }; // AUTO: as `is_welding_meant()` says

  static constexpr double maximal_tolerance = 0.01;

  Mode mode = OFF;
  double tolerance = 0;   // share of the diagonal of the bounding box; 0: at exactly the same point
  std::vector<int> parts; // per vertex, only those of the same part are welded; empty if there is one part

  // Rejects NaN, too.
  static bool is_tolerance(double tolerance) { return tolerance >= 0 && tolerance <= maximal_tolerance; }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_WELDING_H
