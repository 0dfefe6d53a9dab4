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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_COUNTED_SOLVER_SOURCE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_COUNTED_SOLVER_SOURCE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>

#include <atomic>
#include <complex>
#include <memory>
#include <utility>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// A sum over factorizations of their numbers of unknowns: what a run costs, whatever the machine.
using Unknowns = std::atomic<long long>;

class Counted_solver : public Linear_solver
{
public:
  Counted_solver(std::unique_ptr<Linear_solver> solver, Unknowns& unknowns)
    : m_solver(std::move(solver)), m_unknowns(unknowns)
  {}

  void analyze(const Sparse_matrix& upper) override { m_solver->analyze(upper); }
  bool factorize(const Sparse_matrix& upper) override
  {
    m_unknowns += upper.rows();
    return m_solver->factorize(upper);
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& right) override { return m_solver->solve(right); }
  void release() override { m_solver->release(); }

private:
  std::unique_ptr<Linear_solver> m_solver;
  Unknowns& m_unknowns;
};

// An unknown of a Hermitian system counts two.
template <typename Scalar>
class Counted_unordered_solver : public Unordered_solver<Scalar>
{
  using Solver = Unordered_solver<Scalar>;

public:
  Counted_unordered_solver(std::unique_ptr<Solver> solver, Unknowns& unknowns)
    : m_solver(std::move(solver)), m_unknowns(unknowns)
  {}

  bool factorize(const typename Solver::Matrix& lower) override
  {
    constexpr int numbers = int(sizeof(Scalar) / sizeof(double));
    m_unknowns += numbers * lower.rows();
    return m_solver->factorize(lower);
  }
  typename Solver::Vector solve(const typename Solver::Vector& right) override { return m_solver->solve(right); }

private:
  std::unique_ptr<Solver> m_solver;
  Unknowns& m_unknowns;
};

// The solvers of another source, which count in `unknowns` what they factorize.
class Counted_solver_source : public Linear_solver_source
{
public:
  Counted_solver_source(std::shared_ptr<const Linear_solver_source> source, Unknowns& unknowns)
    : Linear_solver_source(source->execution()), m_source(std::move(source)), m_unknowns(unknowns)
  {}

  std::unique_ptr<Linear_solver> make_solver() const override
  {
    return std::make_unique<Counted_solver>(m_source->make_solver(), m_unknowns);
  }
  std::unique_ptr<Symmetric_solver> make_symmetric_solver() const override
  {
    return std::make_unique<Counted_unordered_solver<double> >(m_source->make_symmetric_solver(), m_unknowns);
  }
  std::unique_ptr<Hermitian_solver> make_hermitian_solver() const override
  {
    return std::make_unique<Counted_unordered_solver<std::complex<double> > >(m_source->make_hermitian_solver(),
                                                                              m_unknowns);
  }

private:
  const std::shared_ptr<const Linear_solver_source> m_source;
  Unknowns& m_unknowns;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_COUNTED_SOLVER_SOURCE_H
