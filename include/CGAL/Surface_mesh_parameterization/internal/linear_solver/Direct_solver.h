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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_DIRECT_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_DIRECT_SOLVER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Supernodal_factorization.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>

#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

// The solver of programs that give none: supernodes for large systems, single entries for small ones, by Eigen. The
// size alone decides, so that the result is the same for any number of threads. Factorizations of large systems end, as
// if they failed, once `go_further()` does not want more.
class Direct_solver : public Linear_solver
{
public:
  explicit Direct_solver(Go_further go_further = always_go_further, Execution execution = Execution::SEQUENTIAL)
    : m_go_further(std::move(go_further)), m_large(execution)
  {}

  void analyze(const Sparse_matrix& upper) override
  {
    m_is_large = is_large(upper);
    if(m_is_large)
      m_large.analyze(upper);
    else
      m_small.analyzePattern(upper);
  }
  bool factorize(const Sparse_matrix& upper) override
  {
    if(m_is_large)
      return m_large.factorize(upper, m_go_further);
    m_small.factorize(upper);
    return m_small.info() == Eigen::Success && (m_small.vectorD().array() > 0).all();
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& right) override
  {
    return m_is_large ? m_large.solve(right) : Eigen::VectorXd(m_small.solve(right));
  }

  // Whether the supernodes pay.
  static bool is_large(const Sparse_matrix& upper)
  {
    constexpr int smallest = 1000;
    return upper.cols() >= smallest;
  }

private:
  const Go_further m_go_further;
  Eigen::SimplicialLDLT<Sparse_matrix, Eigen::Upper, Eigen::NaturalOrdering<int> > m_small;
  Supernodal_factorization m_large;
  bool m_is_large = false;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_DIRECT_SOLVER_H
