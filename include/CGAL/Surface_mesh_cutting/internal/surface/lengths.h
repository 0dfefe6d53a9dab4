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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_LENGTHS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_LENGTHS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

inline double average_edge_length(const Indexed_mesh& mesh)
{
  double sum = 0;
  for(double l : mesh.lengths())
    sum += l;
  return sum / double(mesh.number_of_edges());
}

// Of the surface: isolated vertices do not count.
inline double bounding_box_diagonal(const Indexed_mesh& mesh)
{
  Surface_mesh_parameterization::internal::Bounding_box<3> box;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(!mesh.is_isolated(v))
      box.add(mesh.point(v));
  return box.size().norm();
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_LENGTHS_H
