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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_SIMPLICIAL_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_SIMPLICIAL_SOLVER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>

#include <Eigen/SparseCholesky>

#include <complex>
#include <memory>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Always there, one thread, the same result everywhere.
class Simplicial_solver : public Linear_solver
{
public:
  void analyze(const Sparse_matrix& upper) override { m_solver.analyzePattern(upper); }
  bool factorize(const Sparse_matrix& upper) override
  {
    m_solver.factorize(upper);
    return m_solver.info() == Eigen::Success && m_solver.vectorD().minCoeff() > 0;
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& right) override { return m_solver.solve(right); }

private:
  Eigen::SimplicialLDLT<Sparse_matrix, Eigen::Upper, Eigen::NaturalOrdering<int> > m_solver;
};

template <typename Scalar>
class Simplicial_unordered_solver : public Unordered_solver<Scalar>
{
  using Matrix = typename Unordered_solver<Scalar>::Matrix;
  using Vector = typename Unordered_solver<Scalar>::Vector;

public:
  bool factorize(const Matrix& lower) override
  {
    m_solver.compute(lower);
    return m_solver.info() == Eigen::Success;
  }
  Vector solve(const Vector& right) override { return m_solver.solve(right); }

private:
  Eigen::SimplicialLDLT<Matrix> m_solver;
};

// What is used unless another solver is given.
class Simplicial_solver_source : public Linear_solver_source
{
public:
  std::unique_ptr<Linear_solver> make_solver() const override { return std::make_unique<Simplicial_solver>(); }
  std::unique_ptr<Symmetric_solver> make_symmetric_solver() const override
  {
    return std::make_unique<Simplicial_unordered_solver<double> >();
  }
  std::unique_ptr<Hermitian_solver> make_hermitian_solver() const override
  {
    return std::make_unique<Simplicial_unordered_solver<std::complex<double> > >();
  }
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_SIMPLICIAL_SOLVER_H
