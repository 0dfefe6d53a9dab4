// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

// Cuts through given points, and cuts of handles.

#ifndef SURFACE_MESH_CUTTING_PYTHON_CONNECT_H
#define SURFACE_MESH_CUTTING_PYTHON_CONNECT_H

#include "Named_surface.h"
#include "Run_monitor.h"

#include <CGAL/Surface_mesh_cutting/Connection.h>
#include <CGAL/Surface_mesh_cutting/Interpretation.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace binding {

// What cuts that are found without maps have in common.
struct Found_cut
{
  Result_status status;
  std::vector<SMC::Interpretation> interpreted;
  bool has_result = false;
  std::vector<Edge> cut_edges; // ordered
  double length = 0;
};

struct Connection_options
{
  SMC::Connection connection = SMC::Connection::BEST;
  std::size_t maximum_number_of_states = 20000000;
};

struct Connected_points : public Found_cut
{
  double lower_bound = 0;
  bool is_optimal = false;
  int number_of_auxiliary_points = 0;
};

// Connects the terminals.
Connected_points connect_points(const Surface_arguments& arguments, const Connection_options& options, Run_monitor& monitor);

struct Cut_handles : public Found_cut
{
  std::vector<std::vector<std::int64_t> > loops; // the points that each of them passes
};

Cut_handles cut_handles(const Surface_arguments& arguments, Run_monitor& monitor);

} // namespace binding

#endif // SURFACE_MESH_CUTTING_PYTHON_CONNECT_H
