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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_KEPT_SOLVER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_KEPT_SOLVER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_solver.h>

#include <memory>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The solver of a chart, which is kept as long as the chart stays as it is. It is not copied: a copy makes one of its own.
struct Kept_solver
{
  Kept_solver() = default;
  Kept_solver(const Kept_solver&) {}
  Kept_solver& operator=(const Kept_solver&)
  {
    pointer.reset();
    return *this;
  }

  std::unique_ptr<Surface_mesh_parameterization::internal::Newton_solver> pointer;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_KEPT_SOLVER_H
