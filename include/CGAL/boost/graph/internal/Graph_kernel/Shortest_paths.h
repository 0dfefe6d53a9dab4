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

// Dijkstra's algorithm. Boost's, which `Steiner_tree::metric_closure_tree()` runs on the caller's graph, offers no searches
// that end early, arcs with a weight for each direction, vertices that become sources during a search, or sources with
// distances; and only what a run touched is reset here, so that many small searches on a large graph are cheap.
// The one other search is that of `Pruned_dynamic_program`, which prunes by bounds.
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
