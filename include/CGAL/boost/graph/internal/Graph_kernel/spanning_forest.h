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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SPANNING_FOREST_H
#define CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SPANNING_FOREST_H

#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>
#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::internal::Graph_kernel {

// The graph of some edges, with its vertices numbered from 0: keeps the cost of a small tree in a large graph small.
// A model of Boost's concepts `VertexListGraph` and `EdgeListGraph`.
class Edge_subgraph
{
  const Csr_graph* m_graph;
  std::vector<int> m_edges, m_vertices;

public:
  typedef int vertex_descriptor;
  typedef int edge_descriptor; // in the whole graph
  typedef boost::undirected_tag directed_category;
  typedef boost::allow_parallel_edge_tag edge_parallel_category;
  struct traversal_category : boost::vertex_list_graph_tag, boost::edge_list_graph_tag
  {};
  typedef boost::counting_iterator<int> vertex_iterator;
  typedef std::vector<int>::const_iterator edge_iterator;
  typedef int vertices_size_type;
  typedef std::size_t edges_size_type;

  Edge_subgraph(const Csr_graph& graph, std::vector<int> edges) : m_graph(&graph), m_edges(std::move(edges))
  {
    for(int e : m_edges) {
      m_vertices.push_back(graph.edges[e].source);
      m_vertices.push_back(graph.edges[e].target);
    }
    sort_unique(m_vertices);
  }

  // from and to the numbers of the vertices in the whole graph
  int rank(int v) const { return int(std::lower_bound(m_vertices.begin(), m_vertices.end(), v) - m_vertices.begin()); }
  int vertex(int rank) const { return m_vertices[rank]; }

  friend int num_vertices(const Edge_subgraph& graph) { return int(graph.m_vertices.size()); }
  friend std::size_t num_edges(const Edge_subgraph& graph) { return graph.m_edges.size(); }
  friend int source(int e, const Edge_subgraph& graph) { return graph.rank(graph.m_graph->edges[e].source); }
  friend int target(int e, const Edge_subgraph& graph) { return graph.rank(graph.m_graph->edges[e].target); }
  friend std::pair<vertex_iterator, vertex_iterator> vertices(const Edge_subgraph& graph)
  {
    return {vertex_iterator(0), vertex_iterator(num_vertices(graph))};
  }
  friend std::pair<edge_iterator, edge_iterator> edges(const Edge_subgraph& graph)
  {
    return {graph.m_edges.begin(), graph.m_edges.end()};
  }
};

// the weights of edges with the edges' indices, which decide ties
struct Indexed_weight_map
{
  typedef int key_type;
  typedef std::pair<double, int> value_type;
  typedef value_type reference;
  typedef boost::readable_property_map_tag category;

  const Csr_graph* graph;

  friend value_type get(const Indexed_weight_map& map, int e) { return value_type(map.graph->edges[e].weight, e); }
};

// keeps of the candidate edges a minimum spanning forest, by Boost
inline std::vector<int> minimum_spanning_forest(const Csr_graph& graph, const std::vector<int>& candidates)
{
  std::vector<int> forest;
  boost::kruskal_minimum_spanning_tree(Edge_subgraph(graph, candidates), std::back_inserter(forest),
                                       boost::weight_map(Indexed_weight_map{&graph})
                                         .vertex_index_map(boost::typed_identity_property_map<int>()));
  std::sort(forest.begin(), forest.end());
  return forest;
}

// removes the edges to leaves that are no terminals until no such leaf is left
inline void prune_leaves(const Csr_graph& graph, const std::vector<char>& is_terminal, std::vector<int>& forest)
{
  const Edge_subgraph subgraph(graph, forest);
  const int size = num_vertices(subgraph);
  // the exclusive or of a vertex's edges is its only edge once it is a leaf
  std::vector<int> degree(size, 0), edges(size, 0);
  for(int e : forest)
    for(int v : {source(e, subgraph), target(e, subgraph)}) {
      ++degree[v];
      edges[v] ^= e;
    }
  std::vector<int> removed;
  for(int i = 0; i < size; ++i)
    for(int leaf = i; degree[leaf] == 1 && !is_terminal[subgraph.vertex(leaf)];) {
      const int e = edges[leaf];
      const int neighbor = subgraph.rank(graph.opposite(e, subgraph.vertex(leaf)));
      removed.push_back(e);
      degree[leaf] = 0;
      --degree[neighbor];
      edges[neighbor] ^= e;
      leaf = neighbor;
    }
  std::sort(removed.begin(), removed.end());
  std::vector<int> kept;
  std::set_difference(forest.begin(), forest.end(), removed.begin(), removed.end(), std::back_inserter(kept));
  forest.swap(kept);
}

inline double total_weight(const Csr_graph& graph, const std::vector<int>& edges)
{
  double sum = 0.;
  for(int e : edges)
    sum += graph.edges[e].weight;
  return sum;
}

} // namespace CGAL::internal::Graph_kernel

#endif // CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_SPANNING_FOREST_H
