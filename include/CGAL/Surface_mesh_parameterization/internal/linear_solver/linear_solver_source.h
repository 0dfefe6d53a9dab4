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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_LINEAR_SOLVER_SOURCE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_LINEAR_SOLVER_SOURCE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/library.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/adapted_solvers.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Go_further.h>

#include <CGAL/Default.h>

#include <atomic>
#include <functional>
#include <memory>
#include <type_traits>

#ifndef CGAL_SURFACE_MESH_CUTTING_USE_LIBRARY
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/default_linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/wrapped_solvers.h>
#endif

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

using CGAL::internal::Graph_kernel::Go_further;
using CGAL::internal::Graph_kernel::always_go_further;

// A source of solvers that are all made by `make_solver()`, each for a system of its own.
CGAL_SURFACE_MESH_CUTTING_INLINE
std::shared_ptr<const Linear_solver_source> given_solvers(std::function<std::unique_ptr<Linear_solver>()> make_solver,
                                                          Execution execution);

// A source that lends one solver to one system at a time.
CGAL_SURFACE_MESH_CUTTING_INLINE
std::shared_ptr<const Linear_solver_source> lent_solver(std::unique_ptr<Linear_solver> solver, Execution execution);

// The solvers of another source, which count in `unknowns` what they factorize.
CGAL_SURFACE_MESH_CUTTING_INLINE
std::shared_ptr<const Linear_solver_source> counted_solvers(std::shared_ptr<const Linear_solver_source> source,
                                                            std::atomic<long long>& unknowns);

// From what a program gives: nothing but `Default`, a reference to a solver, or a solver. Copies of models of
// CGAL's concept may share what they hold, as `Eigen_solver_traits` does: such a model is lent. Only factorizations
// without a given solver end early, as if they failed, once `go_further()` does not want more.
CGAL_SURFACE_MESH_CUTTING_INLINE
std::shared_ptr<const Linear_solver_source> make_linear_solver_source(const Default&,
                                                                      const Go_further& go_further = always_go_further,
                                                                      Execution execution = Execution::SEQUENTIAL);

template <typename Solver>
std::shared_ptr<const Linear_solver_source> make_linear_solver_source(const std::reference_wrapper<Solver>& solver,
                                                                      const Go_further& = always_go_further,
                                                                      Execution execution = Execution::SEQUENTIAL)
{
  static_assert(!std::is_const<Solver>::value, "Pass a solver that cannot be copied by std::ref().");
  const std::shared_ptr<void> no_owner;
  return lent_solver(adapt(std::shared_ptr<Solver>(no_owner, &solver.get())), execution);
}

template <typename Solver>
std::shared_ptr<const Linear_solver_source> make_linear_solver_source(const Solver& solver,
                                                                      const Go_further& = always_go_further,
                                                                      Execution execution = Execution::SEQUENTIAL)
{
  if constexpr(Has_eigen_interface<Solver>::value)
    return given_solvers([solver] { return adapt(std::make_shared<Solver>(solver)); }, execution);
  else
    return lent_solver(adapt(std::make_shared<Solver>(solver)), execution);
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_LINEAR_SOLVER_SOURCE_H
