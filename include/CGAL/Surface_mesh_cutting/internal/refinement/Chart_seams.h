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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_SEAMS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_SEAMS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Connected_parts.h>

#include <CGAL/boost/graph/internal/Graph_kernel/spanning_forest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A run of edges between the same two parts of a divided chart.
struct Chart_seam
{
  double cost = 0;
  std::pair<int, int> parts;
  std::vector<int> edges;
};

// Takes off a cut what is left of `paths` where it ends inside of a part: once parts that met there are one, it separates
// nothing.
inline void close_dead_ends(const std::vector<std::vector<int> >& paths, const Indexed_mesh& mesh, Cut& cut)
{
  std::vector<int> edges;
  for(const std::vector<int>& path : paths)
    for(int e : path)
      if(std::exchange(cut[e], char(0)))
        edges.push_back(e);
  std::sort(edges.begin(), edges.end());
  CGAL::internal::Graph_kernel::prune_leaves(mesh.graph(), open_vertices(mesh, cut), edges);
  for(int e : edges)
    cut[e] = 1;
}

// Those along `paths` between two parts, in order.
inline std::vector<Chart_seam> seams_along(const std::vector<std::vector<int> >& paths, const Problem& problem,
                                           const Surface_mesh_parameterization::internal::Connected_parts& parts)
{
  std::vector<Chart_seam> result;
  for(const std::vector<int>& path : paths)
  {
    bool goes_on = false;
    for(int e : path)
    {
      const int h = problem.mesh.halfedge(e);
      const std::pair<int, int> sides = std::minmax(parts.part[h / 3], parts.part[problem.mesh.opposite(h) / 3]);
      if(sides.first == sides.second)
      {
        goes_on = false;
        continue;
      }
      if(!goes_on || result.back().parts != sides)
        result.push_back({0, sides, {}});
      goes_on = true;
      result.back().cost += problem.constraints.weights[e];
      result.back().edges.push_back(e);
    }
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_SEAMS_H
