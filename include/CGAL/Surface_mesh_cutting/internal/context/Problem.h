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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_PROBLEM_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_PROBLEM_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/connection/Initial_cut.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using Surface_mesh_parameterization::internal::Rest_shape;

// A connected surface at one resolution and what its cut has to satisfy. Some cut does (`restrict_to_feasible_component()`); what
// is mandatory are the loops that cut the handles, or, where there are many, a whole cut to one disk.
struct Problem
{
  const Indexed_mesh& mesh;
  std::vector<Rest_shape> shapes;
  Edge_constraints constraints;
  std::vector<int> terminals;
  Initial_cut initial;
  bool is_sphere;
  bool has_many_handles = false; // more than a tree that is proven shortest could connect the loops of
  bool is_opened = false;        // to a disk, by what is mandatory

  std::vector<Rest_shape> shapes_of(const std::vector<int>& faces) const
  {
    std::vector<Rest_shape> result;
    result.reserve(faces.size());
    for(int f : faces)
      result.push_back(shapes[f]);
    return result;
  }

  // Per vertex, whether it is a terminal: branches that end there stay.
  std::vector<char> terminal_marks() const
  {
    std::vector<char> marks(mesh.number_of_vertices(), 0);
    for(int v : terminals)
      marks[v] = 1;
    return marks;
  }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_PROBLEM_H
