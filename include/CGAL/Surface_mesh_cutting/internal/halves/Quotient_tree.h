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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_HALVES_QUOTIENT_TREE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_HALVES_QUOTIENT_TREE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/result/Mesh_result.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Topology.h>
#include <CGAL/Surface_mesh_cutting/internal/halves/Half_mesh.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>
#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>
#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>
#include <CGAL/boost/graph/internal/Steiner_tree/solve.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Connects the ends of a cut of one half anew: on the half, the way along the plane was for nothing, but on the whole it is not,
// and all else comes twice. Only where the half is a disk without a border of its own.
class Quotient_tree
{
public:
  // The references are kept.
  Quotient_tree(const Indexed_mesh& mesh, const Edge_constraints& constraints, const Half_mesh& half, const Context& context)
    : m_half(half), m_context(context), m_touches_plane(mesh.number_of_vertices(), 0)
  {
    std::vector<CGAL::internal::Graph_kernel::Edge> edges;
    for(std::size_t i = 0; i < half.half().edges.size(); ++i)
    {
      const int e = half.half().edges[i], v = mesh.source(mesh.halfedge(e)), w = mesh.target(mesh.halfedge(e));
      if(constraints.is_forbidden(e))
        continue;
      edges.push_back({v, w, (half.plane()[e] ? 1 : 2) * constraints.weights[e]});
      m_edges.push_back(int(i));
      if(half.plane()[e])
        m_touches_plane[v] = m_touches_plane[w] = 1;
    }
    m_graph = Csr_graph(mesh.number_of_vertices(), std::move(edges));
  }

  // A cut of the half, off the plane; empty where there is no such tree.
  Cut through(std::vector<int> ends) const
  {
    if(ends.empty())
      return Cut();
    std::vector<int> tree = connected(ends);
    if(!reaches_plane(tree, ends))
    {
      const int v = near_plane(ends);
      if(v < 0)
        return Cut();
      ends.push_back(v);
      tree = connected(ends);
    }
    Cut cut(m_half.half().edges.size(), 0);
    for(const int i : tree)
      cut[m_edges[i]] = !m_half.plane()[m_half.half().edges[m_edges[i]]];
    return cut;
  }

private:
  std::vector<int> connected(const std::vector<int>& ends) const
  {
    return CGAL::internal::Steiner_tree::solve(m_graph, ends, m_context.parameters.connection_while_refining(),
                                               m_context.execution, m_context.control).tree.edges;
  }

  bool reaches_plane(const std::vector<int>& tree, const std::vector<int>& ends) const
  {
    for(const int i : tree)
      if(m_touches_plane[m_graph.edges[i].source] || m_touches_plane[m_graph.edges[i].target])
        return true;
    for(const int v : ends)
      if(m_touches_plane[v])
        return true;
    return false;
  }

  // The vertex of the plane that is nearest to the ends; -1 if there is none.
  int near_plane(const std::vector<int>& ends) const
  {
    CGAL::internal::Graph_kernel::Shortest_paths paths(m_graph);
    for(const int v : ends)
      paths.add_source(v);
    int nearest = -1;
    paths.run([&](int v)
    {
      if(m_touches_plane[v])
        nearest = v;
      return nearest < 0;
    });
    return nearest;
  }

  const Half_mesh& m_half;
  const Context m_context;
  std::vector<char> m_touches_plane; // per vertex
  Csr_graph m_graph;        // of the vertices of the whole
  std::vector<int> m_edges; // of the half
};

// Whether a mesh is a disk that the plane bounds alone.
inline bool is_disk_at_plane(const Half_mesh& half)
{
  const Indexed_mesh& mesh = half.half().mesh;
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    if(mesh.is_border_edge(e) && !half.plane()[half.half().edges[e]])
      return false;
  const Corner_table chart = make_chart(mesh, Cut(mesh.number_of_edges(), 0));
  const Connected_parts parts(chart.opposites());
  return parts.number == 1 && topologies(chart, parts).front().is_disk();
}

// The ends of a cut of the half, connected anew; empty where that is not possible.
inline Cut quotient_tree(const Indexed_mesh& mesh, const Edge_constraints& constraints, const Half_mesh& half,
                         const Mesh_result& of_half, const Context& context)
{
  const bool is_given = std::any_of(half.half().edges.begin(), half.half().edges.end(), // the cut is to stay connected with it
                                    [&](int e) { return constraints.mandatory[e] != 0; });
  if(is_given || !is_disk_at_plane(half))
    return Cut();
  std::vector<int> ends;
  for(const int v : of_half.features)
    ends.push_back(half.half().vertices[v]);
  CGAL::internal::Graph_kernel::sort_unique(ends);
  return Quotient_tree(mesh, constraints, half, context).through(std::move(ends));
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_HALVES_QUOTIENT_TREE_H
