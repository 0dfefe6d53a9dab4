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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_GRAPH_TRAITS_CSR_GRAPH_H
#define CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_GRAPH_TRAITS_CSR_GRAPH_H

#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <utility>

namespace CGAL {
namespace internal {
namespace Graph_kernel {

// an edge as seen from one of its vertices; the same edge from either side
struct Csr_edge_descriptor
{
  int source = -1;
  int target = -1;
  int edge = -1;
  double weight = 0.;

  friend bool operator==(const Csr_edge_descriptor& a, const Csr_edge_descriptor& b) { return a.edge == b.edge; }
  friend bool operator!=(const Csr_edge_descriptor& a, const Csr_edge_descriptor& b) { return a.edge != b.edge; }
};

// the descriptor of the i-th arc, which is in the row of `source`
struct Csr_arc_to_edge
{
  const Csr_graph* graph = nullptr;
  int source = -1;

  Csr_edge_descriptor operator()(int i) const
  {
    const Csr_graph::Arc& arc = graph->arcs[i];
    return {source, arc.target, arc.edge, arc.weight};
  }
};

struct Csr_index_to_edge
{
  const Csr_graph* graph = nullptr;

  Csr_edge_descriptor operator()(int e) const
  {
    const Edge& edge = graph->edges[e];
    return {edge.source, edge.target, e, edge.weight};
  }
};

struct Csr_traversal_category : boost::vertex_list_graph_tag, boost::incidence_graph_tag, boost::edge_list_graph_tag
{};

struct Csr_weight_map
{
  typedef Csr_edge_descriptor key_type;
  typedef double value_type;
  typedef double reference;
  typedef boost::readable_property_map_tag category;

  friend double get(const Csr_weight_map&, const Csr_edge_descriptor& e) { return e.weight; }
};

} // namespace Graph_kernel
} // namespace internal
} // namespace CGAL

namespace boost {

// `Csr_graph` is a model of `VertexListGraph`, `IncidenceGraph` and `EdgeListGraph` with the properties `edge_weight`
// and `vertex_index`: all that Boost's algorithms for shortest paths and spanning trees ask for. A self loop is no
// out-edge of its vertex.
template <>
struct graph_traits<CGAL::internal::Graph_kernel::Csr_graph>
{
  typedef int vertex_descriptor;
  typedef CGAL::internal::Graph_kernel::Csr_edge_descriptor edge_descriptor;
  typedef undirected_tag directed_category;
  typedef allow_parallel_edge_tag edge_parallel_category;
  typedef CGAL::internal::Graph_kernel::Csr_traversal_category traversal_category;
  typedef int vertices_size_type;
  typedef int edges_size_type;
  typedef int degree_size_type;
  typedef counting_iterator<int> vertex_iterator;
  typedef transform_iterator<CGAL::internal::Graph_kernel::Csr_arc_to_edge, counting_iterator<int>> out_edge_iterator;
  typedef transform_iterator<CGAL::internal::Graph_kernel::Csr_index_to_edge, counting_iterator<int>> edge_iterator;

  static vertex_descriptor null_vertex() { return -1; }
};

template <>
struct property_map<CGAL::internal::Graph_kernel::Csr_graph, edge_weight_t>
{
  typedef CGAL::internal::Graph_kernel::Csr_weight_map type;
  typedef type const_type;
};

template <>
struct property_map<CGAL::internal::Graph_kernel::Csr_graph, vertex_index_t>
{
  typedef typed_identity_property_map<int> type;
  typedef type const_type;
};

} // namespace boost

namespace CGAL {
namespace internal {
namespace Graph_kernel {

typedef boost::graph_traits<Csr_graph> Csr_traits;

inline int num_vertices(const Csr_graph& graph) { return graph.number_of_vertices(); }
inline int num_edges(const Csr_graph& graph) { return graph.number_of_edges(); }
inline int out_degree(int v, const Csr_graph& graph) { return graph.degree(v); }
inline int source(const Csr_edge_descriptor& e, const Csr_graph&) { return e.source; }
inline int target(const Csr_edge_descriptor& e, const Csr_graph&) { return e.target; }

inline std::pair<Csr_traits::vertex_iterator, Csr_traits::vertex_iterator> vertices(const Csr_graph& graph)
{
  typedef Csr_traits::vertex_iterator Iterator;
  return {Iterator(0), Iterator(graph.number_of_vertices())};
}

inline std::pair<Csr_traits::edge_iterator, Csr_traits::edge_iterator> edges(const Csr_graph& graph)
{
  typedef Csr_traits::edge_iterator Iterator;
  const Csr_index_to_edge descriptor{&graph};
  return {Iterator(boost::counting_iterator<int>(0), descriptor),
          Iterator(boost::counting_iterator<int>(graph.number_of_edges()), descriptor)};
}

inline std::pair<Csr_traits::out_edge_iterator, Csr_traits::out_edge_iterator> out_edges(int v, const Csr_graph& graph)
{
  typedef Csr_traits::out_edge_iterator Iterator;
  const Csr_arc_to_edge descriptor{&graph, v};
  return {Iterator(boost::counting_iterator<int>(graph.offsets[v]), descriptor),
          Iterator(boost::counting_iterator<int>(graph.offsets[v + 1]), descriptor)};
}

inline Csr_weight_map get(boost::edge_weight_t, const Csr_graph&) { return Csr_weight_map(); }
inline double get(boost::edge_weight_t, const Csr_graph& graph, const Csr_edge_descriptor& e)
{
  return graph.edges[e.edge].weight;
}

inline boost::typed_identity_property_map<int> get(boost::vertex_index_t, const Csr_graph&) { return {}; }
inline int get(boost::vertex_index_t, const Csr_graph&, int v) { return v; }

} // namespace Graph_kernel
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_GRAPH_TRAITS_CSR_GRAPH_H
