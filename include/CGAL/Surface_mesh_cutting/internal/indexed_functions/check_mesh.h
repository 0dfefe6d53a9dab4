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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_CHECK_MESH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_CHECK_MESH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/input/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

CGAL_INLINE_UNLESS_SEPARATE Indexed_status check_mesh(const Indexed_mesh& mesh, Execution execution)
{
  std::vector<int> pinched, doubled;
  Surface_mesh_parameterization::internal::execute_both(
    execution, [&] { pinched = vertices_with_several_fans(mesh); }, [&] { doubled = faces_given_twice(mesh); });
  if(!pinched.empty())
    return Indexed_status(Status_code::NON_MANIFOLD, "vertices whose faces form more than one fan",
                          Element_kind::VERTEX, std::move(pinched));
  if(!doubled.empty())
    return Indexed_status(Status_code::NON_MANIFOLD, "duplicate faces",
                          Element_kind::FACE, std::move(doubled));
  return Indexed_status();
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_CHECK_MESH_H
