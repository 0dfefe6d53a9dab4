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
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Simplicial_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Supernodal_factorization.h>

#include <Eigen/Core>

#include <memory>
#include <utility>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Supernodes for large systems, single entries for small ones. The size alone decides, so that the result is the
// same for any number of threads.
class Direct_solver : public Linear_solver
{
public:
  Direct_solver(Go_further go_further, Execution execution)
    : m_go_further(go_further), m_small(std::move(go_further)), m_large(execution)
  {}

  void analyze(const Sparse_matrix& upper) override
  {
    m_is_large = is_large(upper);
    if(m_is_large)
      m_large.analyze(upper);
    else
      m_small.analyze(upper);
  }
  bool factorize(const Sparse_matrix& upper) override
  {
    return m_is_large ? m_large.factorize(upper, m_go_further) : m_small.factorize(upper);
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& right) override
  {
    return m_is_large ? m_large.solve(right) : m_small.solve(right);
  }

  // Whether the supernodes pay.
  static bool is_large(const Sparse_matrix& upper)
  {
    constexpr int smallest = 1000;
    return upper.cols() >= smallest;
  }

private:
  const Go_further m_go_further;
  Simplicial_solver m_small;
  Supernodal_factorization m_large;
  bool m_is_large = false;
};

// What is used unless another solver is given.
class Direct_solver_source : public Simplicial_solver_source
{
public:
  explicit Direct_solver_source(Go_further go_further = always_go_further, Execution execution = Execution::SEQUENTIAL)
    : Simplicial_solver_source(go_further, execution), m_go_further(std::move(go_further))
  {}

  std::unique_ptr<Linear_solver> make_solver() const override
  {
    return std::make_unique<Direct_solver>(m_go_further, execution());
  }

private:
  const Go_further m_go_further;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_DIRECT_SOLVER_H
