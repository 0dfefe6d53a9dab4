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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_LENT_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_LENT_SOLVER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// A solver that several systems share, one at a time.
struct Lending
{
  explicit Lending(std::unique_ptr<Linear_solver> s) : solver(std::move(s)) {}

  std::unique_ptr<Linear_solver> solver;
  std::recursive_mutex mutex; // a thread can meet another system while it works on one
  std::size_t turn = 0;       // counts how often the solver passed from one system to another
};

// One of these systems. It waits for the solver when it factorizes, and keeps it until `release()`. The
// analysis is done with the first factorization, and again if another system had the solver since.
class Lent_solver : public Linear_solver
{
public:
  explicit Lent_solver(std::shared_ptr<Lending> lending)
    : m_lending(std::move(lending)), m_lock(m_lending->mutex, std::defer_lock)
  {}

  void analyze(const Sparse_matrix&) override { m_turn = 0; }
  bool factorize(const Sparse_matrix& upper) override
  {
    if(!m_lock.owns_lock())
      m_lock.lock();
    m_matrix = &upper;
    if(m_turn == 0 || m_turn != m_lending->turn)
    {
      m_turn = ++m_lending->turn;
      m_lending->solver->analyze(upper);
    }
    return m_lending->solver->factorize(upper);
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& right) override
  {
    if(m_turn != m_lending->turn) // a system that this thread met meanwhile took the solver
      factorize(*m_matrix);
    return m_lending->solver->solve(right);
  }
  void release() override
  {
    if(m_lock.owns_lock())
      m_lock.unlock();
  }

private:
  std::shared_ptr<Lending> m_lending;
  std::unique_lock<std::recursive_mutex> m_lock;
  std::size_t m_turn = 0; // of the lending, when this system got the solver
  const Sparse_matrix* m_matrix = nullptr;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_LENT_SOLVER_H
