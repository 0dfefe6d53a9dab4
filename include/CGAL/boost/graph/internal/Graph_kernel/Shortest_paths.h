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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SHORTEST_PATHS_H
#define CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SHORTEST_PATHS_H

#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>
#include <CGAL/boost/graph/internal/Graph_kernel/Distance_heap.h>

#include <functional>
#include <limits>
#include <vector>

namespace CGAL {
namespace internal {
namespace Graph_kernel {

// Dijkstra's algorithm where `search_from_sources()`, which is Boost's, does not serve: a search can end early
// (Boost's only by an exception), arcs may have a weight for each direction, vertices can become sources during a
// search, sources can have distances, and only what a run touched is reset, so that many small searches on a large graph
// are cheap. Boost's takes up to 1.2 times as long for a whole surface (`benchmark/BGL/boost_graph.cpp`), so the many
// searches of `Key_points` are done here, too: all of the greedy connection would take 1.13 to 1.17 times as long as with
// a heap that holds the distances, with this search 1.02 to 1.04 times.
// The one other search of our own is that of `Pruned_dynamic_programme`, which prunes by bounds.
class Shortest_paths
{
  const Csr_graph* m_graph;
  std::vector<double> m_distances;
  std::vector<int> m_edges; // last edge of the path to a vertex, -1 at a source
  std::vector<int> m_touched;
  std::vector<int> m_sources;   // not yet searched from
  std::vector<int> m_positions; // of the heap, which lasts as long as a run

public:
  explicit Shortest_paths(const Csr_graph& graph)
    : m_graph(&graph)
    , m_distances(graph.number_of_vertices(), infinity())
    , m_edges(graph.number_of_vertices(), -1)
    , m_positions(graph.number_of_vertices(), -1)
  {}

  static double infinity() { return (std::numeric_limits<double>::infinity)(); }

  double distance(int v) const { return m_distances[v]; }
  const std::vector<double>& distances() const { return m_distances; }
  const std::vector<int>& last_edges() const { return m_edges; }
  int last_edge(int v) const { return m_edges[v]; }
  int predecessor(int v) const { return m_graph->opposite(m_edges[v], v); }
  const std::vector<int>& touched() const { return m_touched; }

  void clear()
  {
    for(int v : m_touched) {
      m_distances[v] = infinity();
      m_edges[v] = -1;
    }
    m_touched.clear();
    m_sources.clear();
  }

  void add_source(int v, double distance = 0.)
  {
    if(relax(v, distance, -1))
      m_sources.push_back(v);
  }

  // makes a settled vertex a source; during a search, the distances around it go down as if it had always been one
  void make_source(int v)
  {
    m_distances[v] = 0.;
    m_edges[v] = -1;
    m_sources.push_back(v);
  }

  // calls `settle(v)` for the vertices in the order of their distances until it returns false
  void run(const std::function<bool(int)>& settle)
  {
    run(settle, [this](int i) { return m_graph->arcs[i].weight; });
  }

  // the same with the weight of arc `i` (in its vertex's row) given by `weight(i)`; infinity means: no arc
  template <typename Settle, typename Weight>
  void run(const Settle& settle, const Weight& weight)
  {
    Distance_heap heap(m_distances, m_positions);
    for(;;) {
      for(int v : m_sources)
        heap.push_or_update(v);
      m_sources.clear();
      if(heap.empty())
        return;
      const int v = heap.extract_top();
      if(!settle(v))
        break;
      const double distance = m_distances[v];
      for(int i = m_graph->offsets[v]; i < m_graph->offsets[v + 1]; ++i) {
        const Csr_graph::Arc& arc = m_graph->arcs[i];
        if(relax(arc.target, distance + weight(i), arc.edge))
          heap.push_or_update(arc.target);
      }
    }
    for(int v : m_touched)
      m_positions[v] = -1;
  }

  // searches everything that can be reached
  void run()
  {
    run([](int) { return true; }, [this](int i) { return m_graph->arcs[i].weight; });
  }

  // appends the edges of the path to `v`
  template <typename OutputIterator>
  OutputIterator path(int v, OutputIterator out) const
  {
    for(; m_edges[v] >= 0; v = predecessor(v))
      *out++ = m_edges[v];
    return out;
  }

private:
  bool relax(int v, double distance, int edge)
  {
    if(!(distance < m_distances[v]))
      return false;
    if(m_distances[v] == infinity())
      m_touched.push_back(v);
    m_distances[v] = distance;
    m_edges[v] = edge;
    return true;
  }
};

} // namespace Graph_kernel
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SHORTEST_PATHS_H
