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
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <atomic>
#include <complex>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#ifdef CGAL_METIS_ENABLED
#include <metis.h>

#include <mutex>
#endif

namespace CGAL::Surface_mesh_parameterization::internal {

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

// Approximate minimum degree: order[i] is eliminated as the i-th. Only the lower triangle of the symmetric matrix is
// read: to a whole one, Eigen would add the transposed.
inline std::vector<int> minimum_degree_order(const Sparse_matrix& lower)
{
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int> order;
  order(lower.selfadjointView<Eigen::Lower>(), permutation);
  return std::vector<int>(permutation.indices().data(), permutation.indices().data() + permutation.size());
}

#ifdef CGAL_METIS_ENABLED
// Nested dissection by METIS; empty should it fail. METIS seeds the generator of the C library, hence
// one call at a time, each with the same result.
inline std::vector<int> nested_dissection_order(const Sparse_matrix& adjacency)
{
  idx_t n = idx_t(adjacency.cols());
  std::vector<idx_t> starts(1, 0), neighbours, order(n), positions(n);
  for(int c = 0; c < n; ++c)
  {
    for(Sparse_matrix::InnerIterator it(adjacency, c); it; ++it)
      if(it.row() != c)
        neighbours.push_back(idx_t(it.row()));
    starts.push_back(idx_t(neighbours.size()));
  }
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  if(METIS_NodeND(&n, starts.data(), neighbours.data(), nullptr, nullptr, order.data(), positions.data()) != METIS_OK)
    return std::vector<int>();
  return std::vector<int>(order.begin(), order.end());
}
#endif

// An order of the vertices of a graph that keeps Cholesky factors sparse: order[i] is eliminated as
// the i-th. `adjacency` has all diagonal entries: Eigen takes a row without its own for a dense row.
// Where METIS is there, large charts are dissected: with half a million vertices, that saves two
// thirds of the work of every factorization; below, it takes longer than what the few factorizations save.
inline std::vector<int> fill_reducing_order(const Sparse_matrix& adjacency)
{
#ifdef CGAL_METIS_ENABLED
  constexpr int large = 200000;
  if(adjacency.cols() >= large)
  {
    std::vector<int> order = nested_dissection_order(adjacency);
    if(!order.empty())
      return order;
  }
#endif
  return minimum_degree_order(adjacency);
}

// Solves a positive definite system whose lower triangle is stored, with all diagonal entries, and whose unknowns come
// in any order: a `Linear_solver` gets it in one that keeps the factors sparse.
class Symmetric_solver
{
public:
  explicit Symmetric_solver(const Solvers& solvers) : m_solvers(solvers), m_solver(solvers.make()) {}

  bool factorize(const Sparse_matrix& lower)
  {
    const std::vector<int> order = minimum_degree_order(lower);
    m_to_places.resize(lower.rows());
    for(int i = 0; i < int(order.size()); ++i)
      m_to_places.indices()[order[i]] = i;
    m_upper.resize(lower.rows(), lower.cols());
    m_upper.selfadjointView<Eigen::Upper>() = lower.selfadjointView<Eigen::Lower>().twistedBy(m_to_places);
    m_solver->analyze(m_upper);
    return m_solvers.factorize(*m_solver, m_upper);
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right)
  {
    const Eigen::VectorXd solution = m_solver->solve(m_to_places * right);
    return m_to_places.inverse() * solution;
  }

private:
  const Solvers& m_solvers;
  std::unique_ptr<Linear_solver> m_solver;
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> m_to_places;
  Sparse_matrix m_upper;
};

// The same for a Hermitian system, as a real one: with each unknown as its real and its imaginary part, a + ib becomes the
// block (a, -b; b, a).
class Hermitian_solver
{
public:
  using Matrix = Eigen::SparseMatrix<std::complex<double> >;

  explicit Hermitian_solver(const Solvers& solvers) : m_solver(solvers) {}

  bool factorize(const Matrix& lower) { return m_solver.factorize(embedded(lower)); }

  Eigen::VectorXcd solve(const Eigen::VectorXcd& right)
  {
    Eigen::VectorXd parts(2 * right.size());
    for(Eigen::Index i = 0; i < right.size(); ++i)
      parts.segment<2>(2 * i) << right[i].real(), right[i].imag();
    parts = m_solver.solve(parts);
    Eigen::VectorXcd result(right.size());
    for(Eigen::Index i = 0; i < right.size(); ++i)
      result[i] = std::complex<double>(parts[2 * i], parts[2 * i + 1]);
    return result;
  }

private:
  static Sparse_matrix embedded(const Matrix& lower)
  {
    std::vector<Eigen::Triplet<double> > entries;
    entries.reserve(4 * std::size_t(lower.nonZeros()));
    for(int column = 0; column < lower.outerSize(); ++column)
      for(Matrix::InnerIterator it(lower, column); it; ++it)
      {
        const int i = 2 * int(it.row()), j = 2 * column;
        entries.emplace_back(i, j, it.value().real());
        entries.emplace_back(i + 1, j + 1, it.value().real());
        entries.emplace_back(i + 1, j, it.value().imag());
        if(i != j) // otherwise it belongs to the upper triangle
          entries.emplace_back(i, j + 1, -it.value().imag());
      }
    Sparse_matrix result(2 * lower.rows(), 2 * lower.cols());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  Symmetric_solver m_solver;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_LINEAR_SOLVER_H
