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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_CSR_GRAPH_H
#define CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_CSR_GRAPH_H

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::internal::Graph_kernel {

// Arrays of variable size in one flat array. In each, entries keep the order in which they come.
template <typename Entry>
class Buckets
{
public:
  Buckets() = default;

  // `for_each_entry(visit)` calls `visit(bucket, entry)` for each entry: once to count, and once again in the same order.
  template <typename ForEachEntry>
  Buckets(int number_of_buckets, const ForEachEntry& for_each_entry) : m_starts(number_of_buckets + 1, 0)
  {
    for_each_entry([&](int bucket, const Entry&) { ++m_starts[bucket + 1]; });
    std::partial_sum(m_starts.begin(), m_starts.end(), m_starts.begin());
    m_entries.resize(m_starts.back());
    std::vector<int> ends(m_starts.begin(), m_starts.end() - 1); // of what has come so far
    for_each_entry([&](int bucket, const Entry& entry) { m_entries[ends[bucket]++] = entry; });
  }

  int number_of_buckets() const { return int(m_starts.size()) - 1; }
  int size(int bucket) const { return m_starts[bucket + 1] - m_starts[bucket]; }

  Iterator_range<const Entry*> operator[](int bucket) const
  { return make_range(m_entries.data() + m_starts[bucket], m_entries.data() + m_starts[bucket + 1]); }
  Iterator_range<Entry*> operator[](int bucket)
  { return make_range(m_entries.data() + m_starts[bucket], m_entries.data() + m_starts[bucket + 1]); }

private:
  std::vector<int> m_starts = {0};
  std::vector<Entry> m_entries;
};

struct Edge
{
  int source;
  int target;
  double weight;
};

// An undirected graph in compressed sparse row form. Each edge that is not a self loop has one arc in the
// row of each of its two vertices; an arc stores what a relaxation reads next to each other.
struct Csr_graph
{
  struct Arc
  {
    int target;
    int edge;
    double weight;
  };

  std::vector<Edge> edges;
  std::vector<int> offsets;
  std::vector<Arc> arcs;

  Csr_graph() : offsets(1, 0) {}

  // builds the rows by counting; O(n + m)
  Csr_graph(int number_of_vertices, std::vector<Edge> edge_list)
    : edges(std::move(edge_list)), offsets(std::size_t(number_of_vertices) + 1, 0)
  {
    for(const Edge& e : edges)
      if(e.source != e.target) {
        ++offsets[e.source + 1];
        ++offsets[e.target + 1];
      }
    for(std::size_t v = 1; v < offsets.size(); ++v)
      offsets[v] += offsets[v - 1];
    arcs.resize(offsets.back());
    std::vector<int> next(offsets.begin(), offsets.end() - 1);
    for(std::size_t i = 0; i < edges.size(); ++i) {
      const Edge& e = edges[i];
      if(e.source == e.target)
        continue;
      arcs[next[e.source]++] = Arc{e.target, int(i), e.weight};
      arcs[next[e.target]++] = Arc{e.source, int(i), e.weight};
    }
  }

  int number_of_vertices() const { return int(offsets.size()) - 1; }
  int number_of_edges() const { return int(edges.size()); }
  int degree(int v) const { return offsets[v + 1] - offsets[v]; }

  int opposite(int edge, int v) const
  {
    return edges[edge].source == v ? edges[edge].target : edges[edge].source;
  }

  // the arc in the other direction, for each arc
  std::vector<int> opposite_arcs() const
  {
    std::vector<int> first(edges.size(), -1), result(arcs.size());
    for(std::size_t i = 0; i < arcs.size(); ++i) {
      int& other = first[arcs[i].edge];
      if(other < 0)
        other = int(i);
      else {
        result[i] = other;
        result[other] = int(i);
      }
    }
    return result;
  }
};

// whether the vertices are connected by edges for which `uses(edge)` is true
template <typename Uses>
bool are_connected(const Csr_graph& graph, const std::vector<int>& vertices, const Uses& uses)
{
  Disjoint_sets components(graph.number_of_vertices());
  for(int e = 0; e < graph.number_of_edges(); ++e)
    if(uses(e))
      components.unite(graph.edges[e].source, graph.edges[e].target);
  return std::all_of(vertices.begin(), vertices.end(),
                     [&](int v) { return components.find(v) == components.find(vertices.front()); });
}

} // namespace CGAL::internal::Graph_kernel

#endif // CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_CSR_GRAPH_H
