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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_KEY_PATHS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_KEY_PATHS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The paths that a cut consists of: between vertices where it forks or ends, on the border, or that are kept; a closed
// curve without such a vertex is a path from any of its vertices.
class Key_paths
{
public:
  struct Path
  {
    int source, target;
    std::vector<int> edges; // in order
  };

  Key_paths(const Indexed_mesh& mesh, const Cut& cut, const std::vector<char>& is_kept)
    : m_mesh(mesh), m_cut(cut), m_is_key(is_kept), m_is_done(cut.size(), 0)
  {
    std::vector<int> degrees(mesh.number_of_vertices(), 0);
    for(int e = 0; e < mesh.number_of_edges(); ++e)
      for(int v : {mesh.source(mesh.halfedge(e)), mesh.target(mesh.halfedge(e))})
      {
        degrees[v] += cut[e];
        m_is_key[v] = m_is_key[v] || mesh.is_border_edge(e);
      }
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      m_is_key[v] = degrees[v] > 0 && (m_is_key[v] || degrees[v] != 2);
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      if(m_is_key[v])
        follow_paths_from(v);
    for(int e = 0; e < mesh.number_of_edges(); ++e)
      if(cut[e] && !m_is_done[e])
      {
        const int v = mesh.source(mesh.halfedge(e));
        m_is_key[v] = 1;
        follow_paths_from(v);
      }
  }

  const std::vector<Path>& paths() const { return m_paths; }
  bool is_key(int v) const { return m_is_key[v]; }

private:
  void follow_paths_from(int v)
  {
    const auto& graph = m_mesh.graph();
    for(int a = graph.offsets[v]; a < graph.offsets[v + 1]; ++a)
    {
      if(!m_cut[graph.arcs[a].edge] || m_is_done[graph.arcs[a].edge])
        continue;
      Path path{v, v, {}};
      for(int next = a; next >= 0; next = next_arc(path.target))
      {
        path.edges.push_back(graph.arcs[next].edge);
        m_is_done[path.edges.back()] = 1;
        path.target = graph.arcs[next].target;
      }
      m_paths.push_back(std::move(path));
    }
  }

  // The one to go on with from `v`; -1 where a path ends.
  int next_arc(int v) const
  {
    const auto& graph = m_mesh.graph();
    if(!m_is_key[v])
      for(int a = graph.offsets[v]; a < graph.offsets[v + 1]; ++a)
        if(m_cut[graph.arcs[a].edge] && !m_is_done[graph.arcs[a].edge])
          return a;
    return -1;
  }

  const Indexed_mesh& m_mesh;
  const Cut& m_cut;
  std::vector<char> m_is_key; // per vertex
  std::vector<char> m_is_done; // per edge
  std::vector<Path> m_paths;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_KEY_PATHS_H
