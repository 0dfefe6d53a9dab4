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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_READ_RUN_CONTROL_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_READ_RUN_CONTROL_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Run_control.h>
#include <CGAL/Surface_mesh_cutting/Visitor.h>

#include <chrono>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// How the visitor is held: one that was passed by value is copied, since `get_parameter_reference()` hands out
// a temporary.
template <typename NamedParameters>
using Visitor_reference
  = typename internal_np::Lookup_named_param_def<internal_np::visitor_t, NamedParameters, Default_visitor>::reference;

// Calls the visitor, and ends the run once `maximum_running_time` has passed, unless that is 0. What is negative, or not a
// number, has passed. The time starts here: each call makes its control before it does anything else.
template <typename Visitor, typename NamedParameters>
Run_control read_run_control(Visitor& visitor, const NamedParameters& np)
{
  const double seconds = parameters::choose_parameter(
    parameters::get_parameter(np, internal_np::maximum_running_time), 0.);
  const auto start = std::chrono::steady_clock::now();
  return Run_control(
    [&visitor, start, seconds]
    {
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
      return visitor.go_further() && (seconds == 0 || elapsed.count() <= seconds);
    },
    [&visitor](Phase phase, double fraction) { visitor.progress(phase, fraction); });
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_READ_RUN_CONTROL_H
