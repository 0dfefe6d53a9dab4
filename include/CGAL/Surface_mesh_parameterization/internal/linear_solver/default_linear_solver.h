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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_DEFAULT_LINEAR_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_DEFAULT_LINEAR_SOLVER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/library.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Direct_solver.h>

#include <CGAL/Default.h>

#include <memory>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// The solver of programs that do not name another one.
CGAL_SURFACE_MESH_CUTTING_INLINE
std::shared_ptr<const Linear_solver_source> make_linear_solver_source(const Default&, const Go_further& go_further,
                                                                      Execution execution)
{
  return std::make_shared<Direct_solver_source>(go_further, execution);
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_DEFAULT_LINEAR_SOLVER_H
