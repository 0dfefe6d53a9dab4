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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_CONTEXT_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_CONTEXT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Cutting_parameters.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Phase_clock.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Run_control.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// What all stages of a run share.
struct Context
{
  const Cutting_parameters& parameters;
  Run_control& control;
  Phase_clock& clock;
  Surface_mesh_parameterization::internal::Execution execution
    = Surface_mesh_parameterization::internal::Execution::SEQUENTIAL;
};

// Why there is no map.
inline Indexed_status failure(const Run_control& control)
{
  if(control.is_stopped())
    return stopped_status();
  return Indexed_status(Status_code::NUMERICAL_FAILURE, "no valid map of the opened surface was found");
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_CONTEXT_H
