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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_FIRST_CUT_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_FIRST_CUT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using CGAL::internal::Graph_kernel::Shortest_paths;

// The edges of the graph on which all paths of a region run: those of its triangles.
inline std::vector<char> edges_of_faces(const Indexed_mesh& mesh, const std::vector<char>& is_in_region)
{
  std::vector<char> is_allowed(mesh.number_of_edges(), 0);
  for(int h = 0; h < mesh.number_of_halfedges(); ++h)
    if(is_in_region[h / 3])
      is_allowed[mesh.edge(h)] = 1;
  return is_allowed;
}

// Searches from `v` over the allowed edges (empty: all); returns the farthest vertex, the lowest
// among equals.
inline int farthest_vertex(const Indexed_mesh& mesh, Shortest_paths& paths, int v,
                           const std::vector<char>& is_allowed)
{
  int farthest = v;
  paths.clear();
  paths.add_source(v);
  const auto& arcs = mesh.graph().arcs;
  paths.run([&](int w)
            {
              if(paths.distance(w) > paths.distance(farthest) ||
                 (paths.distance(w) == paths.distance(farthest) && w < farthest))
                farthest = w;
              return true;
            },
            [&](int a) { return is_allowed.empty() || is_allowed[arcs[a].edge] ? arcs[a].weight
                                                                              : Shortest_paths::infinity(); });
  return farthest;
}

// A cut of one edge leaves a border of two edges, on which no flip-free map exists: such a cut is
// extended by the allowed edge (empty: any) that leads farthest.
inline void extend_single_edge(const Indexed_mesh& mesh, std::vector<int>& edges, const std::vector<char>& is_allowed)
{
  if(edges.size() != 1)
    return;
  const int h = mesh.halfedge(edges.front()), s = mesh.source(h), t = mesh.target(h);
  int best = -1;
  double length = -1;
  for(int v : {s, t})
    for(int a = mesh.graph().offsets[v]; a < mesh.graph().offsets[v + 1]; ++a)
    {
      const auto& arc = mesh.graph().arcs[a];
      if(arc.target != s && arc.target != t && arc.weight > length &&
         (is_allowed.empty() || is_allowed[arc.edge]))
      {
        length = arc.weight;
        best = arc.edge;
      }
    }
  if(best >= 0)
    edges.push_back(best);
}

// The edges of the shortest path from `start` to the vertex farthest from it (paper, Section 3.1.1). With
// two sweeps, the path starts from there instead, which brings both ends to extremities of the surface.
// All within the allowed edges (empty: all).
inline std::vector<int> path_to_farthest_vertex(const Indexed_mesh& mesh, int start, int number_of_sweeps,
                                                const std::vector<char>& is_allowed = {})
{
  Shortest_paths paths(mesh.graph());
  int end = start;
  for(int i = 0; i < number_of_sweeps; ++i)
    end = farthest_vertex(mesh, paths, end, is_allowed);
  std::vector<int> edges;
  paths.path(end, std::back_inserter(edges));
  extend_single_edge(mesh, edges, is_allowed);
  return edges;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_FIRST_CUT_H
