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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_INDEXED_SYMMETRY_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_INDEXED_SYMMETRY_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/symmetry/Reflection.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A reflection of a mesh, and how well it maps the mesh to itself.
struct Indexed_symmetry
{
  static constexpr double least_match = 0.98; // less is no symmetry

  Reflection reflection;
  double matched = 0;      // share of the vertices that it brings to the surface
  bool is_exact = false;   // whether it maps the mesh to itself
  std::vector<int> images; // per vertex, -1 without one; an involution
  std::vector<int> edge_images; // the same per edge, if it is exact; diagonals, and what counts as such, have none

  bool is_symmetry() const { return matched >= least_match; }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_INDEXED_SYMMETRY_H
