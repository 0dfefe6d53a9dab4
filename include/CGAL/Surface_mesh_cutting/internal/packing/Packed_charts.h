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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACKED_CHARTS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACKED_CHARTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A turn about the origin of the chart's outline, the scale that is common to all charts, and a translation.
struct Chart_motion
{
  double angle = 0;
  Eigen::Vector2d translation = Eigen::Vector2d::Zero();
  int page = 0; // to whose square this is relative
};

struct Packed_charts
{
  double scale = 0;
  std::vector<Chart_motion> motions;

  int number_of_pages() const
  {
    int number = 0;
    for(const Chart_motion& motion : motions)
      number = (std::max)(number, motion.page + 1);
    return number;
  }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACKED_CHARTS_H
