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

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>

#include <CGAL/Default.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

// Adapters of the solvers that a program can give: those with the interface of Eigen's sparse solvers, those that hold
// such a solver, as CGAL's `Eigen_solver_traits`, and any other model of `SparseLinearAlgebraWithFactorTraits_d`.

template <typename Solver, typename = void>
struct Has_eigen_interface : std::false_type {};
template <typename Solver>
struct Has_eigen_interface<Solver, std::void_t<
  decltype(std::declval<Solver&>().analyzePattern(std::declval<const Sparse_matrix&>())),
  decltype(std::declval<Solver&>().factorize(std::declval<const Sparse_matrix&>())),
  decltype(std::declval<Solver&>().info())> > : std::true_type {};

template <typename Solver, typename = void>
struct Holds_eigen_solver : std::false_type {};
template <typename Solver>
struct Holds_eigen_solver<Solver, std::void_t<decltype(std::declval<Solver&>().solver())> >
  : Has_eigen_interface<std::decay_t<decltype(std::declval<Solver&>().solver())> > {};

// The part of the matrix that a solver reads: one triangle if it names one, as Eigen's solvers of
// symmetric systems do.
template <typename Solver, typename = void>
struct Stored_triangles : std::integral_constant<int, Eigen::Lower | Eigen::Upper> {};
template <typename Solver>
struct Stored_triangles<Solver, std::void_t<decltype(Solver::UpLo)> >
  : std::integral_constant<int, int(Solver::UpLo) & (Eigen::Lower | Eigen::Upper)> {};

template <typename Solver, typename = void>
struct Matrix_of { using type = Sparse_matrix; };
template <typename Solver>
struct Matrix_of<Solver, std::void_t<typename Solver::MatrixType> > { using type = typename Solver::MatrixType; };

template <typename Solver, typename = void>
struct Has_diagonal : std::false_type {};
template <typename Solver>
struct Has_diagonal<Solver, std::void_t<decltype(std::declval<Solver&>().vectorD().array())> >
  : std::true_type {};

template <typename Solver, typename = void>
struct Is_cholmod_solver : std::false_type {};
template <typename Solver>
struct Is_cholmod_solver<Solver, std::void_t<decltype(std::declval<Solver&>().cholmod().nmethods)> >
  : std::true_type {};

template <typename Solver>
class Adapted_eigen_solver : public Linear_solver
{
public:
  explicit Adapted_eigen_solver(std::shared_ptr<Solver> solver) : m_solver(std::move(solver))
  {
    if constexpr(Is_cholmod_solver<Solver>::value)
      keep_order(m_solver->cholmod());
  }

  void analyze(const Sparse_matrix& upper) override { m_solver->analyzePattern(stored(upper)); }
  bool factorize(const Sparse_matrix& upper) override
  {
    m_solver->factorize(stored(upper));
    return m_solver->info() == Eigen::Success && is_positive();
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& right) override
  {
    Eigen::VectorXd x = m_solver->solve(right);
    if(m_solver->info() != Eigen::Success)
      x.setConstant(std::numeric_limits<double>::quiet_NaN());
    return x;
  }

private:
  using Matrix = typename Matrix_of<Solver>::type;

  // CHOLMOD tries orderings unless it is told which ones: the order that the unknowns have is good.
  template <typename Common>
  static void keep_order(Common& common)
  {
    constexpr int natural = 0; // CHOLMOD_NATURAL; its header need not be there
    if(common.nmethods != 0)
      return;
    common.nmethods = 1;
    common.method[0].ordering = natural;
    common.postorder = true;
    common.print = 0; // that a matrix is not positive definite is no news for the terminal
  }

  // With sorted columns, which transposing brings about: CHOLMOD relies on them.
  const Matrix& stored(const Sparse_matrix& upper)
  {
    constexpr int triangles = Stored_triangles<Solver>::value;
    const Sparse_matrix lower = upper.transpose();
    if constexpr(triangles == Eigen::Lower)
      m_matrix = lower;
    else if constexpr(triangles == Eigen::Upper)
      m_matrix = lower.transpose();
    else
      m_matrix = lower.selfadjointView<Eigen::Lower>();
    return m_matrix;
  }

  // LDL^T goes on where the matrix is not positive definite, which its diagonal shows. Other solvers
  // for general matrices cannot tell; then the solution shows.
  bool is_positive() const
  {
    if constexpr(Has_diagonal<Solver>::value)
      return (m_solver->vectorD().array() > 0).all();
    else
      return true;
  }

  std::shared_ptr<Solver> m_solver;
  Matrix m_matrix;
};

template <typename SolverTraits>
class Adapted_solver_traits : public Linear_solver
{
  using Matrix = typename SolverTraits::Matrix;

public:
  explicit Adapted_solver_traits(std::shared_ptr<SolverTraits> traits) : m_traits(std::move(traits)) {}

  void analyze(const Sparse_matrix&) override {}
  bool factorize(const Sparse_matrix& upper) override
  {
    // `factor()` keeps a reference to the matrix: it has to live as long as the solver.
    // One dimension is given: the constructor of CGAL 5.5 with two of type std::size_t reads what is not set.
    m_matrix = std::make_unique<Matrix>(std::size_t(upper.rows()));
    for(int column = 0; column < upper.outerSize(); ++column)
      for(Sparse_matrix::InnerIterator it(upper, column); it; ++it)
      {
        m_matrix->set_coef(it.row(), it.col(), it.value(), true);
        if(it.row() != it.col())
          m_matrix->set_coef(it.col(), it.row(), it.value(), true);
      }
    typename SolverTraits::NT determinant;
    return m_traits->factor(*m_matrix, determinant);
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) override
  {
    typename SolverTraits::Vector right(std::size_t(b.size())), left(std::size_t(b.size()));
    for(int i = 0; i < b.size(); ++i)
      right.set(i, b[i]);
    Eigen::VectorXd x(b.size());
    if(!m_traits->linear_solver(right, left))
      x.setConstant(std::numeric_limits<double>::quiet_NaN());
    else
      for(int i = 0; i < b.size(); ++i)
        x[i] = left[i];
    return x;
  }

private:
  std::shared_ptr<SolverTraits> m_traits;
  std::unique_ptr<Matrix> m_matrix;
};

template <typename Solver>
std::unique_ptr<Linear_solver> adapt(std::shared_ptr<Solver> solver)
{
  if constexpr(Has_eigen_interface<Solver>::value)
    return std::make_unique<Adapted_eigen_solver<Solver> >(std::move(solver));
  else if constexpr(Holds_eigen_solver<Solver>::value)
  {
    auto& held = solver->solver();
    using Held = std::decay_t<decltype(held)>;
    return std::make_unique<Adapted_eigen_solver<Held> >(std::shared_ptr<Held>(solver, &held));
  }
  else
    return std::make_unique<Adapted_solver_traits<Solver> >(std::move(solver));
}

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

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_MAKE_SOLVERS_H
