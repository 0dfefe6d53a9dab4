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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_INITIAL_CUT_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_INITIAL_CUT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/connection/connect_terminals.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A cut that the caller has already: seams drawn by hand, or the result of another program. It need
// not be connected nor leave disks.
class Initial_cut
{
public:
  Initial_cut() = default;
  explicit Initial_cut(Cut cut) : m_cut(std::move(cut)) {}

  bool is_given() const { return std::find(m_cut.begin(), m_cut.end(), char(1)) != m_cut.end(); }

  // The same constraints, but the edges of the cut are almost for nothing: loops, paths and trees
  // follow it where they can.
  Edge_constraints guide(const Edge_constraints& constraints) const
  {
    constexpr double discount = 1e-3;
    Edge_constraints guided = constraints;
    for(std::size_t e = 0; e < m_cut.size(); ++e)
      if(m_cut[e] && !guided.is_forbidden(int(e)))
        guided.weights[e] *= discount;
    return guided;
  }

  // Connects it, and the terminals, to a cut that leaves one disk: closed loops that would separate
  // the surface stay open at one edge.
  Connected_cut connected(const Indexed_mesh& mesh, const Edge_constraints& constraints, std::vector<int> terminals,
                          Execution execution, const Go_further& go_further) const
  {
    const std::vector<char> is_reachable = reachable_vertices(mesh, constraints);
    for(int e = 0; e < mesh.number_of_edges(); ++e)
      if(m_cut[e])
        for(int v : {mesh.source(mesh.halfedge(e)), mesh.target(mesh.halfedge(e))})
          if(is_reachable[v])
            terminals.push_back(v);
    CGAL::internal::Graph_kernel::sort_unique(terminals);
    CGAL::internal::Steiner_tree::Options options;
    options.method = CGAL::internal::Steiner_tree::Method::shortest_path_heuristic;
    return connect_terminals(mesh, guide(constraints), terminals, options, execution, go_further);
  }

private:
  Cut m_cut; // per edge; empty if not given
};

// The vertices inside the surface at which a cut ends or forks.
inline std::vector<int> ends_and_forks(const Indexed_mesh& mesh, const Cut& cut)
{
  const std::vector<char> is_on_border = open_vertices(mesh, Cut(mesh.number_of_edges(), 0));
  const std::vector<int> degree = cut_degrees(mesh, cut);
  std::vector<int> vertices;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
    if(degree[v] > 0 && degree[v] != 2 && !is_on_border[v])
      vertices.push_back(v);
  return vertices;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_INITIAL_CUT_H
