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

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Embedded_hermitian_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Lent_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Reordering_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/adapted_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/library.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Go_further.h>

#include <CGAL/Default.h>

#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#ifndef CGAL_SURFACE_MESH_CUTTING_USE_LIBRARY
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/default_linear_solver.h>
#endif

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

using CGAL::internal::Graph_kernel::Go_further;
using CGAL::internal::Graph_kernel::always_go_further;

// Where the solvers come from if the program gives one: that one solves all systems.
class Given_solver_source : public Linear_solver_source
{
public:
  using Linear_solver_source::Linear_solver_source;

  std::unique_ptr<Symmetric_solver> make_symmetric_solver() const override
  {
    return std::make_unique<Reordering_solver>(make_solver());
  }
  std::unique_ptr<Hermitian_solver> make_hermitian_solver() const override
  {
    return std::make_unique<Embedded_hermitian_solver>(make_solver());
  }
};

// Each system has a copy of the given solver.
template <typename Solver>
class Copied_solver_source : public Given_solver_source
{
public:
  Copied_solver_source(const Solver& solver, Execution execution) : Given_solver_source(execution), m_solver(solver) {}
  std::unique_ptr<Linear_solver> make_solver() const override { return adapt(std::make_shared<Solver>(m_solver)); }

private:
  const Solver m_solver;
};

// The given solver is lent to one system at a time.
class Lent_solver_source : public Given_solver_source
{
public:
  Lent_solver_source(std::unique_ptr<Linear_solver> solver, Execution execution)
    : Given_solver_source(execution), m_lending(std::make_shared<Lending>(std::move(solver)))
  {}
  std::unique_ptr<Linear_solver> make_solver() const override { return std::make_unique<Lent_solver>(m_lending); }

private:
  const std::shared_ptr<Lending> m_lending;
};

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
  return std::make_shared<Lent_solver_source>(adapt(std::shared_ptr<Solver>(no_owner, &solver.get())), execution);
}

template <typename Solver>
std::shared_ptr<const Linear_solver_source> make_linear_solver_source(const Solver& solver,
                                                                      const Go_further& = always_go_further,
                                                                      Execution execution = Execution::SEQUENTIAL)
{
  if constexpr(Has_eigen_interface<Solver>::value)
    return std::make_shared<Copied_solver_source<Solver> >(solver, execution);
  else
    return std::make_shared<Lent_solver_source>(adapt(std::make_shared<Solver>(solver)), execution);
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_LINEAR_SOLVER_SOURCE_H
