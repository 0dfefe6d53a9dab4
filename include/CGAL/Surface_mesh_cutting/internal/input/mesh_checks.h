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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_MESH_CHECKS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_MESH_CHECKS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The vertices whose faces form more than one fan. O(n).
inline std::vector<int> vertices_with_several_fans(const Indexed_mesh& mesh)
{
  std::vector<int> number_of_fans(mesh.number_of_vertices(), 0);
  std::vector<char> is_visited(mesh.number_of_halfedges(), 0);
  for(int seed = 0; seed < mesh.number_of_halfedges(); ++seed)
  {
    if(is_visited[seed])
      continue;
    ++number_of_fans[mesh.source(seed)];
    int h = seed;
    do
    {
      is_visited[h] = 1;
      h = mesh.opposite(previous_halfedge(h));
    }
    while(h >= 0 && h != seed);
    if(h >= 0)
      continue;
    for(h = mesh.opposite(seed); h >= 0; h = mesh.opposite(next_halfedge(h)))
      is_visited[next_halfedge(h)] = 1;
  }
  std::vector<int> vertices;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(number_of_fans[v] > 1)
      vertices.push_back(v);
  return vertices;
}

// The faces that have the three vertices of another face in the same order. Two faces with the same
// vertices in opposite orders are the two sides of a pillow and legal. O(n), as only faces at two
// edges between the same two vertices need to be compared.
inline std::vector<int> faces_given_twice(const Indexed_mesh& mesh)
{
  const Csr_graph& graph = mesh.graph();
  std::vector<char> is_parallel(mesh.number_of_edges(), 0);
  std::vector<int> latest(mesh.number_of_vertices(), -1); // entry of the latest row
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    for(int i = graph.offsets[v]; i < graph.offsets[v + 1]; ++i)
    {
      const int former = std::exchange(latest[graph.arcs[i].target], i);
      if(former >= graph.offsets[v])
        is_parallel[graph.arcs[i].edge] = is_parallel[graph.arcs[former].edge] = 1;
    }

  std::vector<std::pair<Triangle, int> > candidates;
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    if(is_parallel[mesh.edge(3 * f)] && is_parallel[mesh.edge(3 * f + 1)] &&
       is_parallel[mesh.edge(3 * f + 2)])
    {
      Triangle t = mesh.triangles()[f];
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      candidates.emplace_back(t, f);
    }
  std::sort(candidates.begin(), candidates.end());
  std::vector<int> faces;
  for(std::size_t i = 0; i < candidates.size(); ++i)
    if((i > 0 && candidates[i].first == candidates[i - 1].first) ||
       (i + 1 < candidates.size() && candidates[i].first == candidates[i + 1].first))
      faces.push_back(candidates[i].second);
  std::sort(faces.begin(), faces.end());
  return faces;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_MESH_CHECKS_H
