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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_FIND_INDEXED_SYMMETRIES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_FIND_INDEXED_SYMMETRIES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/find_symmetries.h>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

CGAL_INLINE_UNLESS_SEPARATE
std::vector<Indexed_symmetry> find_indexed_symmetries(const Indexed_mesh& mesh, const Cut& diagonals, Symmetry choice,
                                                      Execution execution)
{
  return find_symmetries(mesh, diagonals, choice, execution);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_FIND_INDEXED_SYMMETRIES_H
