// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

// Which vertex of a chart each corner of a polygon soup has.

#ifndef SURFACE_MESH_CUTTING_PYTHON_CHART_VERTICES_H
#define SURFACE_MESH_CUTTING_PYTHON_CHART_VERTICES_H

#include "Named_surface.h"

#include <algorithm>
#include <vector>

namespace binding {

// Corners away from the surface have any vertex of it.
inline std::vector<int> chart_vertices_of_corners(const Soup_adapter& adapter, const SMC::internal::Corner_table& chart)
{
  const SMC::internal::Soup_surface& surface = adapter.surface();
  std::vector<int> of_surface(surface.polygons.vertices.size());
  for(int h = 0; h < adapter.mesh().number_of_halfedges(); ++h)
    of_surface[adapter.to_corner(h)] = chart.source(h);
  std::vector<int> result;
  result.reserve(surface.corners.size());
  for(const int c : surface.corners)
    result.push_back(of_surface[(std::max)(c, 0)]);
  return result;
}

} // namespace binding

#endif // SURFACE_MESH_CUTTING_PYTHON_CHART_VERTICES_H
