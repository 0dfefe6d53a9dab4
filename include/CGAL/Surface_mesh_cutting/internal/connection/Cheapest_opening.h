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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_CHEAPEST_OPENING_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_CHEAPEST_OPENING_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/connection/Key_paths.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Topology.h>

#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>

#include <algorithm>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

inline bool leaves_disk(const Indexed_mesh& mesh, const Cut& cut)
{
  const Corner_table chart = make_chart(mesh, cut);
  return chart.euler_characteristic() == 1 && Connected_parts(chart.opposites()).number == 1;
}

// Of a graph on a connected surface whose faces are disks, what a cut to one disk takes, as cheap as can be without
// taking its paths apart. Closes path after path, the most expensive first, as long as that joins two faces: the dual
// edges make up a spanning tree. What dangles is closed as well, and two paths become one where the others between them
// are closed.
class Cheapest_opening
{
public:
  // `is_kept` holds, per vertex, whether the cut must go on passing through it.
  Cheapest_opening(const Indexed_mesh& mesh, const Edge_constraints& constraints, const Cut& graph,
                   const std::vector<char>& is_kept)
    : m_key(mesh, graph, is_kept), m_is_fixed(open_vertices(mesh, Cut(mesh.number_of_edges(), 0))),
      m_pieces_at(mesh.number_of_vertices())
  {
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      m_is_fixed[v] = m_is_fixed[v] || is_kept[v];
    CGAL::internal::Graph_kernel::Disjoint_sets faces(mesh.number_of_faces());
    for(int h = 0; h < mesh.number_of_halfedges(); ++h)
      if(h < mesh.opposite(h) && !graph[mesh.edge(h)])
        faces.unite(h / 3, mesh.opposite(h) / 3);
    for(const Key_paths::Path& path : m_key.paths())
      add({{path.source, path.target}, {-1, -1}, total_cost(constraints, path.edges), path.edges.front(), true});
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      tidy(v);
    while(!m_queue.empty())
    {
      const int i = m_queue.top().second;
      m_queue.pop();
      const int h = mesh.halfedge(m_pieces[i].edge);
      if(m_pieces[i].is_open && faces.unite(h / 3, mesh.opposite(h) / 3))
        close(i);
    }
  }

  std::vector<int> edges() const
  {
    std::vector<int> result, stack;
    for(int i = 0; i < int(m_pieces.size()); ++i)
      if(m_pieces[i].is_open)
        stack.push_back(i);
    while(!stack.empty())
    {
      const int i = stack.back();
      stack.pop_back();
      if(i < int(m_key.paths().size()))
        result.insert(result.end(), m_key.paths()[i].edges.begin(), m_key.paths()[i].edges.end());
      else
        stack.insert(stack.end(), {m_pieces[i].parts[0], m_pieces[i].parts[1]});
    }
    return result;
  }

private:
  // A path of the graph, or several in a row.
  struct Piece
  {
    int ends[2];
    int parts[2]; // if several
    double cost;
    int edge;     // one of its edges
    bool is_open;
  };

  void add(const Piece& piece)
  {
    for(int v : piece.ends)
      m_pieces_at[v].push_back(int(m_pieces.size()));
    m_queue.emplace(piece.cost, int(m_pieces.size()));
    m_pieces.push_back(piece);
  }

  void take_out(int i)
  {
    m_pieces[i].is_open = false;
    for(int v : m_pieces[i].ends)
      m_pieces_at[v].erase(std::remove(m_pieces_at[v].begin(), m_pieces_at[v].end(), i), m_pieces_at[v].end());
  }

  void close(int i)
  {
    take_out(i);
    for(int v : {m_pieces[i].ends[0], m_pieces[i].ends[1]})
      tidy(v);
  }

  void tidy(int v)
  {
    const std::vector<int> pieces = m_pieces_at[v];
    if(m_is_fixed[v])
      return;
    if(pieces.size() == 1)
      close(pieces[0]); // dangles: the same face is on both sides
    else if(pieces.size() == 2 && pieces[0] != pieces[1])
    {
      const Piece a = m_pieces[pieces[0]], b = m_pieces[pieces[1]];
      take_out(pieces[0]);
      take_out(pieces[1]);
      add({{a.ends[a.ends[0] == v], b.ends[b.ends[0] == v]}, {pieces[0], pieces[1]}, a.cost + b.cost, a.edge, true});
    }
  }

  const Key_paths m_key;
  std::vector<char> m_is_fixed; // per vertex, whether paths end there in any case
  std::vector<std::vector<int> > m_pieces_at; // per vertex; those that return to it twice
  std::vector<Piece> m_pieces; // those of single paths first
  std::priority_queue<std::pair<double, int> > m_queue;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_CHEAPEST_OPENING_H
