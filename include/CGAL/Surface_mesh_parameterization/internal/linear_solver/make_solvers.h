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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_MAKE_SOLVERS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_MAKE_SOLVERS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/adapted_solvers.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Go_further.h>

#include <CGAL/Default.h>

#include <memory>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

using CGAL::internal::Graph_kernel::Go_further;
using CGAL::internal::Graph_kernel::always_go_further;

Solvers default_solvers(const Go_further& go_further = always_go_further, Execution execution = Execution::SEQUENTIAL);

// From what a program gives: nothing but `Default`, or a solver. Each system has an object of its own: a copy of a
// solver with the interface of Eigen's; of a model of CGAL's concept, whose copies may share what they hold as those of
// `Eigen_solver_traits` do, a new one. Only factorizations without a given solver ask `go_further()`.
template <typename Solver>
Solvers make_solvers(const Solver& given, const Go_further& go_further = always_go_further,
                     Execution execution = Execution::SEQUENTIAL)
{
  if constexpr(std::is_same_v<Solver, Default>)
    return default_solvers(go_further, execution);
  else if constexpr(Has_eigen_interface<Solver>::value)
  {
    static_assert(std::is_copy_constructible_v<Solver>,
                  "Give a solver of Eigen, which cannot be copied, as CGAL::Eigen_solver_traits of its type.");
    return {[given] { return adapt(std::make_shared<Solver>(given)); }, execution, true};
  }
  else
  {
    static_assert(std::is_default_constructible_v<Solver>,
                  "Give a solver with the interface of Eigen's, or a model of SparseLinearAlgebraWithFactorTraits_d.");
    return {[] { return adapt(std::make_shared<Solver>()); }, execution, true};
  }
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_MAKE_SOLVERS_H
