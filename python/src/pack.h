// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

// Packing of charts, and the proof that a map is valid.

#ifndef SURFACE_MESH_CUTTING_PYTHON_PACK_H
#define SURFACE_MESH_CUTTING_PYTHON_PACK_H

#include "Named_surface.h"
#include "Run_monitor.h"
#include "cut_surface.h"

#include <CGAL/Surface_mesh_cutting/internal/packing/Indexed_packing.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <Eigen/Core>

#include <vector>

namespace binding {

// Moves the charts of a surface, whose halfedges have these UVs at their sources, into the unit square.
SMC::internal::Indexed_packing pack(const Soup_adapter& adapter, const SMC::internal::Corner_table& chart,
                                    const std::vector<Eigen::Vector2d>& corner_uv, const Packing_options& options,
                                    bool do_bijective, Run_monitor& monitor);

struct Packed_surface
{
  Result_status status;
  bool has_result = false;
  std::vector<double> corner_uv; // two per corner of the soup
  double scale = 0, fill = 0;
  std::vector<double> page_fills;
  int number_of_charts = 0;
};

// `corner_uv`: two numbers per corner of the soup. The surface is cut where the UVs of neighbors differ.
Packed_surface pack_surface(const Surface_arguments& arguments, const Numbers& corner_uv, const Packing_options& options,
                            bool do_bijective, Run_monitor& monitor);
Result_status certify_surface(const Surface_arguments& arguments, const Numbers& corner_uv, bool do_bijective);

} // namespace binding

#endif // SURFACE_MESH_CUTTING_PYTHON_PACK_H
