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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_WRAPPED_SOLVERS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_WRAPPED_SOLVERS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/library.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Counted_solver_source.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Given_solver_source.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Lent_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>

#include <functional>
#include <memory>
#include <utility>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

CGAL_SURFACE_MESH_CUTTING_INLINE
std::shared_ptr<const Linear_solver_source> given_solvers(std::function<std::unique_ptr<Linear_solver>()> make_solver,
                                                          Execution execution)
{
  return std::make_shared<Given_solver_source>(std::move(make_solver), execution);
}

CGAL_SURFACE_MESH_CUTTING_INLINE
std::shared_ptr<const Linear_solver_source> lent_solver(std::unique_ptr<Linear_solver> solver, Execution execution)
{
  const auto lending = std::make_shared<Lending>(std::move(solver));
  return std::make_shared<Given_solver_source>([lending] { return std::make_unique<Lent_solver>(lending); }, execution);
}

CGAL_SURFACE_MESH_CUTTING_INLINE
std::shared_ptr<const Linear_solver_source> counted_solvers(std::shared_ptr<const Linear_solver_source> source,
                                                            Unknowns& unknowns)
{
  return std::make_shared<Counted_solver_source>(std::move(source), unknowns);
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_WRAPPED_SOLVERS_H
