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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_REORDERING_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_REORDERING_SOLVER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/fill_reducing_order.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/reordered.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Brings the unknowns into an order that keeps the factors of another solver sparse.
class Reordering_solver : public Symmetric_solver
{
public:
  explicit Reordering_solver(std::unique_ptr<Linear_solver> solver) : m_solver(std::move(solver)) {}

  bool factorize(const Sparse_matrix& lower) override
  {
    m_order = minimum_degree_order(lower);
    Sparse_matrix twisted(lower.rows(), lower.cols());
    twisted.selfadjointView<Eigen::Lower>() = lower.selfadjointView<Eigen::Lower>().twistedBy(permutation_to(m_order));
    m_upper = twisted.transpose(); // which sorts the columns
    m_solver->analyze(m_upper);
    return m_solver->factorize(m_upper);
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) override
  {
    return in_former_order(m_solver->solve(reordered(right, m_order)), m_order);
  }

private:
  std::unique_ptr<Linear_solver> m_solver;
  std::vector<int> m_order; // the unknown at each place
  Sparse_matrix m_upper;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_REORDERING_SOLVER_H
