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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_LOCAL_MAXIMIZERS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_LOCAL_MAXIMIZERS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The vertices with no larger value next to them, one (the lowest) for each plateau. O(n).
inline std::vector<int> local_maximizers(const Indexed_mesh& mesh, const std::vector<double>& values)
{
  std::vector<int> maximizers, plateau;
  std::vector<char> is_visited(values.size(), 0);
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    if(is_visited[v] || mesh.is_isolated(v))
      continue;
    bool is_maximal = true;
    plateau.assign(1, v);
    is_visited[v] = 1;
    for(std::size_t i = 0; i < plateau.size(); ++i)
      for(int a = mesh.graph().offsets[plateau[i]]; a < mesh.graph().offsets[plateau[i] + 1]; ++a)
      {
        const int w = mesh.graph().arcs[a].target;
        is_maximal = is_maximal && values[w] <= values[v];
        if(values[w] == values[v] && !is_visited[w])
        {
          is_visited[w] = 1;
          plateau.push_back(w);
        }
      }
    if(is_maximal)
      maximizers.push_back(v);
  }
  return maximizers;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_LOCAL_MAXIMIZERS_H
