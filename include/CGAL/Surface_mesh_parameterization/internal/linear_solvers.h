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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVERS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVERS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <limits>
#include <memory>

#ifdef CGAL_SURFACE_MESH_CUTTING_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Solvers of symmetric systems whose upper triangle is stored and whose unknowns come in an order
// that keeps the factors sparse: `analyze()` once per pattern, `factorize()` once per matrix, false
// unless the matrix is positive definite, `solve()` as often as wanted.

using Sparse_matrix = Eigen::SparseMatrix<double>;

// Always there, one thread, the same result everywhere.
class Simplicial_solver
{
public:
  void analyze(const Sparse_matrix& upper) { m_solver.analyzePattern(upper); }
  bool factorize(const Sparse_matrix& upper)
  {
    m_solver.factorize(upper);
    return m_solver.info() == Eigen::Success && m_solver.vectorD().minCoeff() > 0;
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return m_solver.solve(b); }

private:
  Eigen::SimplicialLDLT<Sparse_matrix, Eigen::Upper, Eigen::NaturalOrdering<int> > m_solver;
};

#ifdef CGAL_SURFACE_MESH_CUTTING_WITH_CHOLMOD
// CHOLMOD's supernodal module: faster on large systems. It is under the GPL and uses the BLAS it is
// linked with.
class Supernodal_solver
{
public:
  Supernodal_solver()
  {
    m_solver.cholmod().nmethods = 1;
    m_solver.cholmod().method[0].ordering = CHOLMOD_NATURAL;
    m_solver.cholmod().postorder = true;
    m_solver.cholmod().print = 0;
  }
  void analyze(const Sparse_matrix& upper) { m_solver.analyzePattern(upper); }
  bool factorize(const Sparse_matrix& upper)
  {
    m_solver.factorize(upper);
    return m_solver.info() == Eigen::Success;
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return m_solver.solve(b); }

private:
  Eigen::CholmodSupernodalLLT<Sparse_matrix, Eigen::Upper> m_solver;
};
#endif

// What CGAL's named parameter `sparse_linear_solver` gives: a model of
// `SparseLinearAlgebraWithFactorTraits_d`, such as `Eigen_solver_traits` of a direct Eigen solver.
template <typename SolverTraits>
class Traits_solver
{
  using Matrix = typename SolverTraits::Matrix;

public:
  void analyze(const Sparse_matrix&) {}
  bool factorize(const Sparse_matrix& upper)
  {
    // `factor()` keeps a reference to the matrix: it has to live as long as the solver.
    // Of one dimension: the constructor of CGAL 5.5 with two of type std::size_t reads what is not set.
    m_matrix = std::make_unique<Matrix>(std::size_t(upper.rows()));
    for(int column = 0; column < upper.outerSize(); ++column)
      for(Sparse_matrix::InnerIterator it(upper, column); it; ++it)
      {
        m_matrix->set_coef(it.row(), it.col(), it.value(), true);
        if(it.row() != it.col())
          m_matrix->set_coef(it.col(), it.row(), it.value(), true);
      }
    typename SolverTraits::NT determinant;
    return m_traits.factor(*m_matrix, determinant);
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& b)
  {
    typename SolverTraits::Vector right(std::size_t(b.size())), left(std::size_t(b.size()));
    for(int i = 0; i < b.size(); ++i)
      right.set(i, b[i]);
    Eigen::VectorXd x(b.size());
    if(!m_traits.linear_solver(right, left))
      x.setConstant(std::numeric_limits<double>::quiet_NaN());
    else
      for(int i = 0; i < b.size(); ++i)
        x[i] = left[i];
    return x;
  }

private:
  SolverTraits m_traits;
  std::unique_ptr<Matrix> m_matrix;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVERS_H
