// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_SEPARATOR_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_SEPARATOR_H

#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Tree.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::internal::Steiner_tree {

// Finds the largest number a such that given terminals are connected among the vertices v with length(v) >= a. Few
// vertices, the touched ones, have a finite length, and time should depend on their number rather than on the
// size of the graph, which must be connected.
class Separator
{
  const Csr_graph& m_graph;
  Graph_kernel::Index_set m_seen; // in the order of the search
  Graph_kernel::Disjoint_sets m_sets; // of the vertices seen
  std::vector<int> m_pending; // of a set that is still growing: number of its vertices in the queue
  std::vector<char> m_holds_terminal;
  int m_number_of_growing_sets = 0;
  int m_missing = 0; // merges of sets with terminals until all terminals are connected

public:
  explicit Separator(const Csr_graph& graph)
    : m_graph(graph), m_seen(graph.number_of_vertices()), m_sets(graph.number_of_vertices()),
      m_pending(graph.number_of_vertices(), 0), m_holds_terminal(graph.number_of_vertices(), 0)
  {}

  // infinity if the terminals are connected without the touched vertices; these are sorted by decreasing length
  double operator()(const std::vector<double>& lengths, std::vector<int>& touched, const std::vector<int>& terminals)
  {
    search_around(lengths, touched);
    place_terminals(lengths, terminals);
    double result = (std::numeric_limits<double>::infinity)();
    if(m_missing > 0) {
      std::sort(touched.begin(), touched.end(), [&](int v, int w) {
        return lengths[v] > lengths[w] || (lengths[v] == lengths[w] && v < w);
      });
      for(std::size_t i = 0; m_missing > 0 && i < touched.size(); ++i) {
        const int v = touched[i];
        result = lengths[v];
        for(int j = m_graph.offsets[v]; j < m_graph.offsets[v + 1]; ++j)
          if(lengths[m_graph.arcs[j].target] >= lengths[v])
            unite(v, m_graph.arcs[j].target);
      }
    }
    for(int v : m_seen.indices()) {
      m_sets.reset(v);
      m_pending[v] = 0;
      m_holds_terminal[v] = 0;
    }
    m_seen.clear();
    return result;
  }

private:
  // Searches from the rim of the touched vertices in all directions at once. Parts that meet become one, and as soon
  // as only one is still growing, all vertices not seen belong to it: on a surface, that is after a few steps unless
  // the touched vertices do separate it.
  void search_around(const std::vector<double>& lengths, const std::vector<int>& touched)
  {
    m_number_of_growing_sets = 0;
    for(int v : touched)
      m_seen.insert(v);
    const std::size_t first = m_seen.indices().size();
    for(int v : touched)
      for(int i = m_graph.offsets[v]; i < m_graph.offsets[v + 1]; ++i) {
        const int w = m_graph.arcs[i].target;
        if(!m_seen.contains(w))
          start_at(w);
      }
    for(std::size_t next = first; next < m_seen.indices().size() && m_number_of_growing_sets > 1; ++next) {
      const int v = m_seen.indices()[next];
      for(int i = m_graph.offsets[v]; i < m_graph.offsets[v + 1]; ++i) {
        const int w = m_graph.arcs[i].target;
        if(lengths[w] < (std::numeric_limits<double>::infinity)())
          continue;
        if(!m_seen.contains(w))
          start_at(w);
        unite(v, w);
      }
      if(--m_pending[m_sets.find(v)] == 0)
        --m_number_of_growing_sets;
    }
  }

  // terminals that were not seen are in the set that is still growing
  void place_terminals(const std::vector<double>& lengths, const std::vector<int>& terminals)
  {
    m_missing = -1;
    bool is_one_not_seen = false;
    for(int t : terminals)
      if(!m_seen.contains(t))
        is_one_not_seen = true;
      else {
        char& holds_terminal = m_holds_terminal[m_sets.find(t)];
        if(!holds_terminal || lengths[t] < (std::numeric_limits<double>::infinity)())
          ++m_missing;
        holds_terminal = 1;
      }
    if(!is_one_not_seen)
      return;
    for(int v : m_seen.indices())
      if(m_sets.find(v) == v && m_pending[v] > 0) {
        if(!m_holds_terminal[v])
          ++m_missing;
        m_holds_terminal[v] = 1;
        return;
      }
  }

  // a set that grows
  void start_at(int v)
  {
    m_seen.insert(v);
    m_pending[v] = 1;
    ++m_number_of_growing_sets;
  }

  void unite(int v, int w)
  {
    v = m_sets.find(v);
    w = m_sets.find(w);
    if(!m_sets.unite(v, w))
      return;
    if(w < v)
      std::swap(v, w);
    if(m_pending[v] > 0 && m_pending[w] > 0)
      --m_number_of_growing_sets;
    m_pending[v] += m_pending[w];
    if(m_holds_terminal[v] && m_holds_terminal[w])
      --m_missing;
    m_holds_terminal[v] |= m_holds_terminal[w];
  }
};

} // namespace CGAL::internal::Steiner_tree

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_SEPARATOR_H
