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
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/fill_reducing_order.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <complex>
#include <memory>
#include <vector>

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

// The same for unknowns in any order.
template <typename Scalar>
class Simplicial_unordered_solver : public Unordered_solver<Scalar>
{
  using Matrix = typename Unordered_solver<Scalar>::Matrix;
  using Vector = typename Unordered_solver<Scalar>::Vector;
  using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

public:
  // Orders the unknowns as Eigen would. Its own way orders matrices of each scalar type by other code, which every
  // program would have to compile.
  bool factorize(const Matrix& lower) override
  {
    CGAL_assertion(lower.isCompressed());
    Sparse_matrix pattern(lower.rows(), lower.cols());
    pattern.resizeNonZeros(lower.nonZeros());
    std::copy_n(lower.outerIndexPtr(), lower.cols() + 1, pattern.outerIndexPtr());
    std::copy_n(lower.innerIndexPtr(), lower.nonZeros(), pattern.innerIndexPtr());
    std::fill_n(pattern.valuePtr(), lower.nonZeros(), 1.);
    const std::vector<int> order = minimum_degree_order(pattern.selfadjointView<Eigen::Lower>());
    m_inverse_order = Permutation(Eigen::Map<const Eigen::VectorXi>(order.data(), lower.rows()));
    m_order = m_inverse_order.inverse();
    Matrix upper(lower.rows(), lower.cols());
    upper.template selfadjointView<Eigen::Upper>() = lower.template selfadjointView<Eigen::Lower>().twistedBy(m_order);
    m_solver.analyzePattern(upper);
    m_solver.factorize(upper);
    return m_solver.info() == Eigen::Success;
  }
  Vector solve(const Vector& right) override
  {
    const Vector reordered = m_order * right, solution = m_solver.solve(reordered);
    return m_inverse_order * solution;
  }

private:
  Eigen::SimplicialLDLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int> > m_solver;
  Permutation m_order, m_inverse_order;
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
