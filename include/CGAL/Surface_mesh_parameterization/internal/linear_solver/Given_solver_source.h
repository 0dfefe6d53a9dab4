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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_GIVEN_SOLVER_SOURCE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_GIVEN_SOLVER_SOURCE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Embedded_hermitian_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Reordering_solver.h>

#include <functional>
#include <memory>
#include <utility>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Where the solvers come from if the program gives one: that one solves all systems.
class Given_solver_source : public Linear_solver_source
{
public:
  using Make_solver = std::function<std::unique_ptr<Linear_solver>()>;

  Given_solver_source(Make_solver make_solver, Execution execution)
    : Linear_solver_source(execution), m_make_solver(std::move(make_solver))
  {}

  std::unique_ptr<Linear_solver> make_solver() const override { return m_make_solver(); }
  std::unique_ptr<Symmetric_solver> make_symmetric_solver() const override
  {
    return std::make_unique<Reordering_solver>(make_solver());
  }
  std::unique_ptr<Hermitian_solver> make_hermitian_solver() const override
  {
    return std::make_unique<Embedded_hermitian_solver>(make_solver());
  }

private:
  const Make_solver m_make_solver;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_GIVEN_SOLVER_SOURCE_H
