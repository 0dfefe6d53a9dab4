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

#include <boost/graph/detail/d_ary_heap.hpp>
#include <boost/property_map/property_map.hpp>

#include <functional>
#include <limits>
#include <vector>

namespace CGAL::internal::Graph_kernel {

// A distance that knows its vertex. Equal ones are in the order of the vertices' indices: a search whose heap
// compares these settles vertices in an order that depends on the graph alone, whichever way the heap is built.
struct Indexed_distance
{
  double distance;
  int index;

  friend bool operator<(const Indexed_distance& a, const Indexed_distance& b)
  {
    return a.distance != b.distance ? a.distance < b.distance : a.index < b.index;
  }
};

// the distances in an array, each with the index of its vertex
template <typename VertexIndexMap>
class Distance_map
{
  double* m_distances;
  VertexIndexMap m_index;

public:
  typedef typename boost::property_traits<VertexIndexMap>::key_type key_type;
  typedef Indexed_distance value_type;
  typedef Indexed_distance reference;
  typedef boost::read_write_property_map_tag category;

  Distance_map(std::vector<double>& distances, VertexIndexMap index) : m_distances(distances.data()), m_index(index) {}

  friend value_type get(const Distance_map& map, const key_type& v)
  {
    using boost::get;
    const int i = int(get(map.m_index, v));
    return value_type{map.m_distances[i], i};
  }

  friend void put(const Distance_map& map, const key_type& v, const value_type& d)
  {
    using boost::get;
    map.m_distances[get(map.m_index, v)] = d.distance;
  }
};

typedef boost::typed_identity_property_map<int> Identity_map;

// A heap of vertices by their distances, which are in an array. The array of their positions in the heap holds -1 for
// those outside; whoever leaves vertices in the heap resets it.
class Distance_heap
  : public boost::d_ary_heap_indirect<int, 4, boost::iterator_property_map<int*, Identity_map>,
                                      Distance_map<Identity_map>, std::less<Indexed_distance>>
{
public:
  Distance_heap(std::vector<double>& distances, std::vector<int>& positions)
    : d_ary_heap_indirect(Distance_map<Identity_map>(distances, Identity_map()),
                          boost::make_iterator_property_map(positions.data(), Identity_map()))
  {}

  int extract_top()
  {
    const int v = top();
    pop();
    return v;
  }
};

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
    : m_graph(&graph), m_distances(graph.number_of_vertices(), infinity()), m_edges(graph.number_of_vertices(), -1),
      m_positions(graph.number_of_vertices(), -1)
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

} // namespace CGAL::internal::Graph_kernel

#endif // CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SHORTEST_PATHS_H
