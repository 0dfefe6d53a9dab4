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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_CUT_GRAPH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_CUT_GRAPH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Contracted_surface.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>
#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>
#include <CGAL/boost/graph/internal/Graph_kernel/spanning_forest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A cut to one disk of a connected surface with handles or borders that has one (`restrict_to_feasible_component()`): all
// borders, the shortest paths from one place, and one more edge for each loop that a handle takes, without dead ends. Longer
// than what `cut_handles()` and a tree make, but quickly found. O(n log n)
inline Cut cut_graph(const Indexed_mesh& mesh, const Edge_constraints& constraints)
{
  const Contracted_surface surface(make_chart(mesh, Cut(mesh.number_of_edges(), 0)),
                                   [&](int h) { return constraints.weights[mesh.edge(h)]; });
  const Csr_graph& graph = surface.graph;
  const auto is_allowed = [&](int e) { return !constraints.is_forbidden(mesh.edge(surface.halfedges[e])); };
  CGAL::internal::Graph_kernel::Shortest_paths paths(graph);
  for(int e = 0; e < graph.number_of_edges() && paths.touched().empty(); ++e)
    if(is_allowed(e))
      paths.add_source(graph.edges[e].source);
  paths.run();

  std::vector<char> is_in_graph(graph.number_of_edges(), 0);
  for(int v : paths.touched())
    if(paths.last_edge(v) >= 0)
      is_in_graph[paths.last_edge(v)] = 1;
  std::vector<std::pair<double, int> > others; // those with the longest loops first, and before them what must not be cut
  for(int e = 0; e < graph.number_of_edges(); ++e)
    if(!is_in_graph[e])
      others.emplace_back(-(paths.distance(graph.edges[e].source) + graph.edges[e].weight
                            + paths.distance(graph.edges[e].target)), e);
  std::sort(others.begin(), others.end());
  CGAL::internal::Graph_kernel::Disjoint_sets faces(mesh.number_of_faces());
  for(const auto& [length, e] : others)
  {
    const int h = surface.halfedges[e];
    is_in_graph[e] = !faces.unite(h / 3, mesh.opposite(h) / 3) && is_allowed(e);
  }

  std::vector<int> edges;
  for(int e = 0; e < graph.number_of_edges(); ++e)
    if(is_in_graph[e])
      edges.push_back(e);
  std::vector<char> is_border(graph.number_of_vertices(), 0);
  std::fill_n(is_border.begin(), surface.border_loops.size(), char(1));
  CGAL::internal::Graph_kernel::prune_leaves(graph, is_border, edges);
  Cut cut(mesh.number_of_edges(), 0);
  for(int e : edges)
    cut[mesh.edge(surface.halfedges[e])] = 1;
  return cut;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_CUT_GRAPH_H
