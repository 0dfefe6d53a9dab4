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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_CUT_INDEXED_MESH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_CUT_INDEXED_MESH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Mesh_cutter.h>
#include <CGAL/Surface_mesh_cutting/internal/halves/cut_symmetrically.h>

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/find_indexed_symmetries.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

CGAL_INLINE_UNLESS_SEPARATE
Mesh_result cut_indexed_mesh(const Indexed_mesh& mesh, Output_kind output,
                             const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& round,
                             const Cutting_constraints& constraints, const Context& context)
{
  if(context.parameters.symmetry != Symmetry::NONE && output != Output_kind::FEATURES)
    return cut_symmetrically(mesh, output, round, constraints, context);
  return Mesh_cutter(mesh, round, constraints, context).run(output);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_CUT_INDEXED_MESH_H
