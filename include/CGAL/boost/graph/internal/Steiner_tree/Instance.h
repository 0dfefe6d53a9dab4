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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_INSTANCE_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_INSTANCE_H

#include <CGAL/boost/graph/internal/Steiner_tree/Tree.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::internal::Steiner_tree {

// A Steiner tree problem that stands for a larger one: each edge stands for a path of original edges, and some
// original edges have been found to be in the tree already.
class Instance
{
  // Numbers below the number of original edges stand for these, others for concatenations.
  struct Concatenation
  {
    int first;
    int second;
  };

  Csr_graph m_graph;
  std::vector<int> m_terminals;
  int m_number_of_original_edges;
  std::vector<Concatenation> m_concatenations;
  std::vector<int> m_origins; // of the edges of the graph
  std::vector<int> m_fixed;   // in the tree

  friend class Degree_reduction;

public:
  Instance(const Csr_graph& graph, const std::vector<int>& terminals)
    : m_graph(graph), m_terminals(terminals), m_number_of_original_edges(graph.number_of_edges())
  {
    for(int e = 0; e < graph.number_of_edges(); ++e)
      m_origins.push_back(e);
  }

  const Csr_graph& graph() const { return m_graph; }
  const std::vector<int>& terminals() const { return m_terminals; }

  // the original edges that edges of the graph, and the fixed ones, stand for
  std::vector<int> original_edges(const std::vector<int>& edges) const
  {
    std::vector<int> result, stack(m_fixed);
    for(int e : edges)
      stack.push_back(m_origins[e]);
    while(!stack.empty()) {
      const int e = stack.back();
      stack.pop_back();
      if(e < m_number_of_original_edges)
        result.push_back(e);
      else {
        const Concatenation& c = m_concatenations[e - m_number_of_original_edges];
        stack.push_back(c.first);
        stack.push_back(c.second);
      }
    }
    return result;
  }
};

// Removes edges, and then what the degrees decide: vertices that are no terminals and have degree one or two, longer
// ones of parallel edges, terminals of degree one, and terminals whose shortest edge leads to another terminal
// (Duin and Volgenant 1989). The optimal trees of the result are optimal in the instance given, provided that the
// edges removed were not needed. Stopped early, it leaves some of that.
class Degree_reduction
{
  struct Working_edge
  {
    Edge edge;
    int origin;
    bool is_alive;
  };

  Instance m_instance;
  std::vector<Working_edge> m_edges;
  std::vector<std::vector<int>> m_incident; // may list dead edges
  std::vector<char> m_is_terminal;
  std::vector<char> m_is_queued;
  std::vector<int> m_queue;
  int m_number_of_terminals;

public:
  Degree_reduction(const Instance& instance, const std::vector<char>& is_removed, const Go_further& go_further)
    : m_instance(instance), m_incident(instance.graph().number_of_vertices()),
      m_is_terminal(mark(instance.graph().number_of_vertices(), instance.terminals())),
      m_is_queued(instance.graph().number_of_vertices(), 1), m_number_of_terminals(int(instance.terminals().size()))
  {
    const Csr_graph& graph = instance.graph();
    for(int e = 0; e < graph.number_of_edges(); ++e)
      if(!is_removed[e] && graph.edges[e].source != graph.edges[e].target)
        add_edge(graph.edges[e], instance.m_origins[e]);
    for(int v = graph.number_of_vertices() - 1; v >= 0; --v)
      m_queue.push_back(v);
    Patience patience(go_further);
    while(!m_queue.empty() && m_number_of_terminals > 1 && patience.lasts()) {
      const int v = m_queue.back();
      m_queue.pop_back();
      m_is_queued[v] = 0;
      reduce(v);
    }
    rebuild();
  }

  const Instance& instance() const { return m_instance; }

private:
  int opposite(int e, int v) const
  {
    return m_edges[e].edge.source == v ? m_edges[e].edge.target : m_edges[e].edge.source;
  }

  void enqueue(int v)
  {
    if(!m_is_queued[v]) {
      m_is_queued[v] = 1;
      m_queue.push_back(v);
    }
  }

  void add_edge(const Edge& edge, int origin)
  {
    m_incident[edge.source].push_back(int(m_edges.size()));
    m_incident[edge.target].push_back(int(m_edges.size()));
    m_edges.push_back(Working_edge{edge, origin, true});
  }

  void remove_edge(int e)
  {
    m_edges[e].is_alive = false;
    enqueue(m_edges[e].edge.source);
    enqueue(m_edges[e].edge.target);
  }

  // forgets dead edges, removes longer parallel ones
  void tidy(int v)
  {
    std::vector<int>& incident = m_incident[v];
    incident.erase(std::remove_if(incident.begin(), incident.end(), [&](int e) { return !m_edges[e].is_alive; }),
                   incident.end());
    std::sort(incident.begin(), incident.end(), [&](int a, int b) {
      const int va = opposite(a, v), vb = opposite(b, v);
      const double wa = m_edges[a].edge.weight, wb = m_edges[b].edge.weight;
      return va != vb ? va < vb : wa != wb ? wa < wb : a < b;
    });
    const auto last = std::unique(incident.begin(), incident.end(), [&](int a, int b) {
      if(opposite(a, v) != opposite(b, v))
        return false;
      m_edges[b].is_alive = false;
      enqueue(opposite(b, v));
      return true;
    });
    incident.erase(last, incident.end());
  }

  void reduce(int v)
  {
    tidy(v);
    const std::vector<int>& incident = m_incident[v];
    if(incident.empty())
      return;
    if(m_is_terminal[v]) {
      const int shortest = *std::min_element(incident.begin(), incident.end(), [&](int a, int b) {
        const double wa = m_edges[a].edge.weight, wb = m_edges[b].edge.weight;
        return wa != wb ? wa < wb : a < b;
      });
      if(incident.size() == 1 || m_is_terminal[opposite(shortest, v)])
        contract(shortest, v);
    }
    else if(incident.size() == 1)
      remove_edge(incident.front());
    else if(incident.size() == 2)
      concatenate(incident[0], incident[1], v);
  }

  // puts the edge into the tree; its terminal `v` goes, the other vertex is a terminal from now on
  void contract(int e, int v)
  {
    const int u = opposite(e, v);
    m_instance.m_fixed.push_back(m_edges[e].origin);
    m_edges[e].is_alive = false;
    if(m_is_terminal[u])
      --m_number_of_terminals;
    m_is_terminal[v] = 0;
    m_is_terminal[u] = 1;
    const std::vector<int> incident(m_incident[v]);
    for(int other : incident)
      if(m_edges[other].is_alive) {
        const int w = opposite(other, v);
        m_edges[other].is_alive = false;
        if(w != u)
          add_edge(Edge{u, w, m_edges[other].edge.weight}, m_edges[other].origin);
        enqueue(w);
      }
    m_incident[v].clear();
    enqueue(u);
    for(int other : m_incident[u])
      if(m_edges[other].is_alive)
        enqueue(opposite(other, u)); // may be a terminal whose shortest edge leads to a terminal now
  }

  void concatenate(int first, int second, int v)
  {
    const int a = opposite(first, v), b = opposite(second, v);
    const double weight = m_edges[first].edge.weight + m_edges[second].edge.weight;
    m_instance.m_concatenations.push_back({m_edges[first].origin, m_edges[second].origin});
    add_edge(Edge{a, b, weight}, m_instance.m_number_of_original_edges + int(m_instance.m_concatenations.size()) - 1);
    remove_edge(first);
    remove_edge(second);
  }

  // numbers the vertices that are left in their old order
  void rebuild()
  {
    std::vector<int> number(m_incident.size(), -1);
    for(const Working_edge& e : m_edges)
      if(e.is_alive)
        number[e.edge.source] = number[e.edge.target] = 0;
    int size = 0;
    m_instance.m_terminals.clear();
    for(std::size_t v = 0; v < number.size(); ++v)
      if(number[v] == 0 || m_is_terminal[v]) {
        number[v] = size++;
        if(m_is_terminal[v])
          m_instance.m_terminals.push_back(number[v]);
      }
    std::vector<Edge> edges;
    m_instance.m_origins.clear();
    for(const Working_edge& e : m_edges)
      if(e.is_alive) {
        edges.push_back(Edge{number[e.edge.source], number[e.edge.target], e.edge.weight});
        m_instance.m_origins.push_back(e.origin);
      }
    m_instance.m_graph = Csr_graph(size, std::move(edges));
  }
};

} // namespace CGAL::internal::Steiner_tree

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_INSTANCE_H
