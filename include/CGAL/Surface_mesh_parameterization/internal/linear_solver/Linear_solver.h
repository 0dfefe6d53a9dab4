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

#include <complex>
#include <memory>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

using Sparse_matrix = Eigen::SparseMatrix<double>;

// Solves symmetric systems whose upper triangle is stored, with sorted columns, and whose unknowns come in
// an order that keeps the factors sparse: `analyze()` once per pattern, `factorize()` once per matrix, `solve()` as
// often as wanted. The matrix has to stay as it is until the last `solve()`.
class Linear_solver
{
public:
  virtual ~Linear_solver() = default;

  virtual void analyze(const Sparse_matrix& upper) = 0;
  // False unless the matrix is positive definite, as far as the solver can tell.
  virtual bool factorize(const Sparse_matrix& upper) = 0;
  // Not finite if the solver fails.
  virtual Eigen::VectorXd solve(const Eigen::VectorXd& right) = 0;
  // The factors are not needed any more: a solver that is shared can serve another system.
  virtual void release() {}
};

// Solves one positive definite system whose lower triangle is stored, with all diagonal entries, and
// whose unknowns come in any order; symmetric or, with complex numbers, Hermitian.
template <typename Scalar>
class Unordered_solver
{
public:
  using Matrix = Eigen::SparseMatrix<Scalar>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  virtual ~Unordered_solver() = default;

  virtual bool factorize(const Matrix& lower) = 0;
  virtual Vector solve(const Vector& right) = 0;
};

using Symmetric_solver = Unordered_solver<double>;
using Hermitian_solver = Unordered_solver<std::complex<double> >;

// Where the solvers of all systems come from, and whether these and the loops that assemble systems may use several
// threads. May be asked by several threads at a time.
class Linear_solver_source
{
public:
  explicit Linear_solver_source(Execution execution = Execution::SEQUENTIAL) : m_execution(execution) {}
  virtual ~Linear_solver_source() = default;

  Execution execution() const { return m_execution; }

  virtual std::unique_ptr<Linear_solver> make_solver() const = 0;
  virtual std::unique_ptr<Symmetric_solver> make_symmetric_solver() const = 0;
  virtual std::unique_ptr<Hermitian_solver> make_hermitian_solver() const = 0;

private:
  const Execution m_execution;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_LINEAR_SOLVER_H
