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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_READ_VERTICES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_READ_VERTICES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>

#include <CGAL/boost/graph/properties.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The indices of some vertices of the caller's mesh.
template <typename TriangleMesh, typename VertexPointMap, typename VertexRange>
std::vector<int> read_vertices(const TriangleMesh& tmesh,
                               const Mesh_adapter<TriangleMesh, VertexPointMap>& adapter,
                               const VertexRange& range)
{
  auto index = get(CGAL::dynamic_vertex_property_t<int>(), tmesh);
  for(int v = 0; v < adapter.mesh().number_of_vertices(); ++v)
    put(index, adapter.to_vertex(v), v);
  std::vector<int> indices;
  for(const auto& v : range)
    indices.push_back(get(index, v));
  return indices;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_READ_VERTICES_H
