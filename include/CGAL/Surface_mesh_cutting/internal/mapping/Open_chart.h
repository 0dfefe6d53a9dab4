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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_OPEN_CHART_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_OPEN_CHART_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A surface opened along a cut that leaves one disk, and its isometric map.
struct Open_chart
{
  Cut cut;
  Corner_table chart;
  std::vector<Eigen::Vector2d> uv;
  double energy = 0; // area-averaged, converged
  double precision = std::numeric_limits<double>::infinity(); // the decrement that was reached, of the energy
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_OPEN_CHART_H
