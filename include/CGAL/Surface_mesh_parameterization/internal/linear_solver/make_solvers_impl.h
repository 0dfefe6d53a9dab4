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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_MAKE_SOLVERS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_MAKE_SOLVERS_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Direct_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers.h>

#include <CGAL/boost/graph/internal/Graph_kernel/separate_implementation.h>

namespace CGAL::Surface_mesh_parameterization::internal {

// Those of programs that give no solver.
CGAL_INLINE_UNLESS_SEPARATE
Solvers default_solvers(const Go_further& go_further, Execution execution)
{
  return {[=] { return std::make_unique<Direct_solver>(go_further, execution); }, execution};
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_MAKE_SOLVERS_IMPL_H
