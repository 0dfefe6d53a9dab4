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
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Simplicial_factorization.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/fill_reducing_order.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/reordered.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <complex>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Always there, one thread, the same result everywhere.
class Simplicial_solver : public Linear_solver
{
public:
  explicit Simplicial_solver(Go_further go_further) : m_go_further(std::move(go_further)) {}

  void analyze(const Sparse_matrix& upper) override { m_factorization.analyze(upper); }
  bool factorize(const Sparse_matrix& upper) override { return m_factorization.factorize(upper, m_go_further); }
  Eigen::VectorXd solve(const Eigen::VectorXd& right) override
  {
    Eigen::VectorXd result = right;
    m_factorization.solve(result);
    return result;
  }

private:
  const Go_further m_go_further;
  Simplicial_factorization<double> m_factorization;
};

// The same for unknowns in any order.
template <typename Scalar>
class Simplicial_unordered_solver : public Unordered_solver<Scalar>
{
  using Matrix = typename Unordered_solver<Scalar>::Matrix;
  using Vector = typename Unordered_solver<Scalar>::Vector;

public:
  explicit Simplicial_unordered_solver(Go_further go_further) : m_go_further(std::move(go_further)) {}

  // The order is that of the pattern alone, so that one function orders matrices of any scalar type.
  bool factorize(const Matrix& lower) override
  {
    CGAL_assertion(lower.isCompressed());
    Sparse_matrix pattern(lower.rows(), lower.cols());
    pattern.resizeNonZeros(lower.nonZeros());
    std::copy_n(lower.outerIndexPtr(), lower.cols() + 1, pattern.outerIndexPtr());
    std::copy_n(lower.innerIndexPtr(), lower.nonZeros(), pattern.innerIndexPtr());
    std::fill_n(pattern.valuePtr(), lower.nonZeros(), 1.);
    m_order = minimum_degree_order(pattern);
    Matrix upper(lower.rows(), lower.cols());
    upper.template selfadjointView<Eigen::Upper>()
      = lower.template selfadjointView<Eigen::Lower>().twistedBy(permutation_to(m_order));
    m_factorization.analyze(upper);
    return m_factorization.factorize(upper, m_go_further);
  }
  Vector solve(const Vector& right) override
  {
    Vector result = reordered(right, m_order);
    m_factorization.solve(result);
    return in_former_order(result, m_order);
  }

private:
  const Go_further m_go_further;
  std::vector<int> m_order; // the unknown at each place
  Simplicial_factorization<Scalar> m_factorization;
};

// Factorizations end, as if they failed, once `go_further()` does not want more; several threads may ask it at a time.
class Simplicial_solver_source : public Linear_solver_source
{
public:
  explicit Simplicial_solver_source(Go_further go_further = always_go_further,
                                    Execution execution = Execution::SEQUENTIAL)
    : Linear_solver_source(execution), m_go_further(std::move(go_further))
  {}

  std::unique_ptr<Linear_solver> make_solver() const override
  {
    return std::make_unique<Simplicial_solver>(m_go_further);
  }
  std::unique_ptr<Symmetric_solver> make_symmetric_solver() const override
  {
    return std::make_unique<Simplicial_unordered_solver<double> >(m_go_further);
  }
  std::unique_ptr<Hermitian_solver> make_hermitian_solver() const override
  {
    return std::make_unique<Simplicial_unordered_solver<std::complex<double> > >(m_go_further);
  }

private:
  const Go_further m_go_further;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_SIMPLICIAL_SOLVER_H
