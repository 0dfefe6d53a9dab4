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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_SHORTEST_LOOP_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_SHORTEST_LOOP_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Contracted_surface.h>
#include <CGAL/Surface_mesh_cutting/internal/handles/Tree_cotree.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A cycle in the graph of a contracted surface.
struct Loop
{
  double weight = std::numeric_limits<double>::infinity();
  int start = -1;
  std::vector<int> edges; // in order
};

// Searches the shortest cycle that does not separate the surface.
//
// The shortest such cycle through a root consists of two shortest paths from the root and an edge
// (Erickson and Har-Peled 2004). It lies within half its length from the root, so that only a ball
// around the root is searched once some cycle is known. As every such cycle meets each cut graph,
// the nodes of one suffice as roots. A root near one whose shortest cycle is known to be long
// cannot have a much shorter one: for roots r and s at distance d, the lengths differ by at most
// 2d.
class Shortest_loop
{
public:
  // The loop found is at most 1 / (1 - tolerance) times as long as the shortest one.
  Shortest_loop(const Contracted_surface& surface, const Tree_cotree& tree_cotree, double tolerance)
    : m_graph(surface.graph), m_tree_cotree(tree_cotree), m_tolerance(tolerance), m_paths(m_graph),
      m_lower_bounds(m_graph.number_of_vertices(), 0.),
      m_is_settled(m_graph.number_of_vertices(), 0),
      m_signatures(m_graph.number_of_vertices() * tree_cotree.number_of_words(), 0)
  {
    search_self_loops();
  }

  // Starts from the given roots and, whenever a shorter loop is found, from its nodes.
  void search(const std::vector<int>& roots)
  {
    std::vector<int> stack(roots.rbegin(), roots.rend());
    while(!stack.empty())
    {
      const int root = stack.back();
      stack.pop_back();
      if(m_lower_bounds[root] >= (1 - m_tolerance) * m_loop.weight)
        continue;
      if(search(root))
        for(int e : m_loop.edges)
          for(int v : {m_graph.edges[e].source, m_graph.edges[e].target})
            stack.push_back(v);
    }
  }

  const Loop& loop() const { return m_loop; }

private:
  using Word = Tree_cotree::Word;

  // How far beyond the length of the present loop to search: larger lower bounds spare more roots
  // than they cost.
  static constexpr double reach = 1.25;

  // The edge at which the two paths from a root meet.
  struct Closure
  {
    double weight;
    int edge;
  };

  Word* signature(int v) { return m_signatures.data() + v * m_tree_cotree.number_of_words(); }

  void search_self_loops()
  {
    for(int e = 0; e < m_graph.number_of_edges(); ++e)
    {
      const auto& edge = m_graph.edges[e];
      const Word* bits = m_tree_cotree.signature(e);
      if(edge.source == edge.target && edge.weight < m_loop.weight &&
         std::any_of(bits, bits + m_tree_cotree.number_of_words(), [](Word w) { return w != 0; }))
        m_loop = Loop{edge.weight, edge.source, {e}};
    }
  }

  // Returns whether a loop shorter than the present one was found.
  bool search(int root)
  {
    Closure best{reach * m_loop.weight, -1};
    m_paths.clear();
    m_paths.add_source(root);
    m_paths.run([&](int v)
    {
      if(2 * m_paths.distance(v) >= best.weight)
        return false;
      settle(v);
      for(int i = m_graph.offsets[v]; i < m_graph.offsets[v + 1]; ++i)
        close(v, m_graph.arcs[i], best);
      return true;
    });
    for(int v : m_paths.touched())
    {
      m_is_settled[v] = 0;
      m_lower_bounds[v] = (std::max)(m_lower_bounds[v], best.weight - 2 * m_paths.distance(v));
    }
    if(best.edge < 0 || best.weight >= m_loop.weight)
      return false;
    m_loop = extract(best);
    return true;
  }

  void settle(int v)
  {
    m_is_settled[v] = 1;
    const int e = m_paths.last_edge(v);
    const Word* previous = e < 0 ? nullptr : signature(m_paths.predecessor(v));
    const Word* last = e < 0 ? nullptr : m_tree_cotree.signature(e);
    for(std::size_t w = 0; w < m_tree_cotree.number_of_words(); ++w)
      signature(v)[w] = e < 0 ? 0 : previous[w] ^ last[w];
  }

  void close(int v, const Csr_graph::Arc& arc, Closure& best)
  {
    if(!m_is_settled[arc.target])
      return;
    const double weight = m_paths.distance(v) + arc.weight + m_paths.distance(arc.target);
    if(weight >= best.weight)
      return;
    const Word* bits = m_tree_cotree.signature(arc.edge);
    for(std::size_t w = 0; w < m_tree_cotree.number_of_words(); ++w)
      if((signature(v)[w] ^ signature(arc.target)[w]) != bits[w])
      {
        best = Closure{weight, arc.edge};
        return;
      }
  }

  // The cycle that the edge closes in the tree; what the paths to its two ends share is left out.
  Loop extract(const Closure& closure) const
  {
    std::vector<int> forth, back;
    int start = m_graph.edges[closure.edge].source;
    m_paths.path(start, std::back_inserter(forth));
    m_paths.path(m_graph.edges[closure.edge].target, std::back_inserter(back));
    double weight = closure.weight;
    while(!forth.empty() && !back.empty() && forth.back() == back.back())
    {
      weight -= 2 * m_graph.edges[forth.back()].weight;
      forth.pop_back();
      back.pop_back();
    }
    for(int e : forth)
      start = m_graph.opposite(e, start);
    Loop loop{weight, start, {}};
    loop.edges.assign(forth.rbegin(), forth.rend());
    loop.edges.push_back(closure.edge);
    loop.edges.insert(loop.edges.end(), back.begin(), back.end());
    return loop;
  }

  const Csr_graph& m_graph;
  const Tree_cotree& m_tree_cotree;
  const double m_tolerance;
  Shortest_paths m_paths;
  std::vector<double> m_lower_bounds; // for the loops through a node
  std::vector<char> m_is_settled;
  std::vector<Word> m_signatures;     // of the paths to the nodes
  Loop m_loop;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_SHORTEST_LOOP_H
