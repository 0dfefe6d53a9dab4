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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_INDEXED_PACKING_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_INDEXED_PACKING_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Chart_rotation.h>
#include <CGAL/Surface_mesh_cutting/Effort.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Packing_margin.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

struct Packing_parameters
{
  Packing_margin margin;
  bool do_bijective; // whether it is also to be proven that no chart overlaps itself
  Effort effort = Effort::DEFAULT;
  Chart_rotation rotation = Chart_rotation::AUTOMATIC;
  int most_pages = 1;         // at a given scale, 0 stands for as many as are needed
  double texels_per_unit = 0; // of the former UVs; 0 for as many as fit
  bool allow_flips = false;   // charts may be mirrored or folded, and stay so
};

// What packing found, in terms of the indexed chart.
struct Indexed_packing
{
  Indexed_status status;
  bool has_result = false;
  std::vector<Eigen::Vector2d> uv; // of chart vertices
  double scale = 0;                // from the former UVs
  double fill = 0;                 // mean of those of the pages
  std::vector<double> page_fills;  // area of the charts on each one
  int number_of_charts = 0;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_INDEXED_PACKING_H
