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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_LINEAR_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_LINEAR_SOLVER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <atomic>
#include <functional>
#include <memory>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

using Sparse_matrix = Eigen::SparseMatrix<double>;

// Solves positive definite systems whose upper triangle is stored, and whose unknowns come in an order that keeps the
// factors sparse: `analyze()` once per pattern, `factorize()` once per matrix, `solve()` as often as wanted. The matrix
// has to stay as it is until the last `solve()`.
class Linear_solver
{
public:
  virtual ~Linear_solver() = default;

  virtual void analyze(const Sparse_matrix& upper) = 0;
  // False unless the matrix is positive definite, as far as the solver can tell.
  virtual bool factorize(const Sparse_matrix& upper) = 0;
  // Not finite if the solver fails.
  virtual Eigen::VectorXd solve(const Eigen::VectorXd& right) = 0;
};

// How the systems of a run are solved. Several threads may use it at a time.
struct Solvers
{
  // A solver for one pattern.
  std::function<std::unique_ptr<Linear_solver>()> make;
  // Whether these solvers, and the loops that assemble systems, may use several threads.
  Execution execution = Execution::SEQUENTIAL;
  // Whether the program gave a solver, which then solves all systems.
  bool is_given = false;
  // Receives the numbers of unknowns of all factorizations: a measure of cost that does not depend on the machine.
  std::atomic<long long>* factorized_unknowns = nullptr;

  void count(Eigen::Index unknowns) const
  {
    if(factorized_unknowns != nullptr)
      *factorized_unknowns += unknowns;
  }
  bool factorize(Linear_solver& solver, const Sparse_matrix& upper) const
  {
    count(upper.cols());
    return solver.factorize(upper);
  }
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_LINEAR_SOLVER_H
