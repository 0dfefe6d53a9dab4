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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_VISIBILITIES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_VISIBILITIES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Visibility.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Execution.h>

#include <utility>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

CGAL_INLINE_UNLESS_SEPARATE
std::optional<std::vector<double> > visibilities(const Indexed_mesh& mesh, const View& view, Execution execution,
                                                Run_control& control)
{
  constexpr int edges_per_question = 16; // well below a millisecond for each thread
  if(!control.go_further())
    return std::nullopt;
  const Visibility visibility(mesh, view);
  std::vector<double> result(mesh.number_of_edges());
  execute(execution, mesh.number_of_edges(), [&](int e) {
    if(e % edges_per_question == 0)
      control.go_further();
    if(!control.is_stopped())
      result[e] = visibility(e);
  });
  return control.is_stopped() ? std::nullopt : std::make_optional(std::move(result));
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_VISIBILITIES_H
