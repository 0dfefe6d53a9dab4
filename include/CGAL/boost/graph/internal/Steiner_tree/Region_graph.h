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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_REGION_GRAPH_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_REGION_GRAPH_H

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/internal/Graph_kernel/graph_traits_Csr_graph.h>
#include <CGAL/boost/graph/internal/Graph_kernel/sort_unique.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Tree.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Voronoi_regions.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

using Graph_kernel::Csr_edge_descriptor;
using Graph_kernel::Csr_weight_map;

// A coarser graph: some of the vertices as centers, joined where their regions touch by the shortest path from center
// to center through an edge between the regions. Its paths are paths of the graph, a few percent longer than the
// shortest ones.
class Region_graph
{
  using Regions = Voronoi_regions<Csr_graph, Csr_weight_map, boost::typed_identity_property_map<int>>;

  const Csr_graph& m_graph;
  std::vector<int> m_centers;
  Regions m_regions;
  std::vector<int> m_bridges; // of the edges
  Csr_graph m_coarse;

public:
  // The first centers are the terminals, the others are evenly spread over the indices.
  Region_graph(const Csr_graph& graph, const std::vector<int>& terminals, int number_of_centers)
    : m_graph(graph)
    , m_centers(choose_centers(graph, terminals, number_of_centers))
    , m_regions(graph, m_centers, get(boost::edge_weight, graph), get(boost::vertex_index, graph))
  {
    std::vector<Edge> coarse_edges;
    for(const Csr_edge_descriptor& e : CGAL::make_range(edges(graph)))
      if(m_regions.is_bridge(e)) {
        coarse_edges.push_back(Edge{m_regions.center(e.source), m_regions.center(e.target), m_regions.bridge_length(e)});
        m_bridges.push_back(e.edge);
      }
    m_coarse = Csr_graph(int(m_centers.size()), std::move(coarse_edges));
  }

  const Csr_graph& graph() const { return m_coarse; }

  // the edges of the paths that these edges stand for
  std::vector<int> original_edges(const std::vector<int>& coarse_edges) const
  {
    std::vector<int> result;
    for(int e : coarse_edges) {
      result.push_back(m_bridges[e]);
      add_path_to_center(m_graph.edges[m_bridges[e]].source, result);
      add_path_to_center(m_graph.edges[m_bridges[e]].target, result);
    }
    Graph_kernel::sort_unique(result);
    return result;
  }

private:
  static std::vector<int> choose_centers(const Csr_graph& graph, const std::vector<int>& terminals, int number)
  {
    std::vector<int> result(terminals);
    const std::vector<char> is_terminal = mark(graph.number_of_vertices(), terminals);
    for(int v = 0; v < graph.number_of_vertices(); v += (std::max)(1, graph.number_of_vertices() / number))
      if(!is_terminal[v])
        result.push_back(v);
    return result;
  }

  void add_path_to_center(int v, std::vector<int>& path) const
  {
    for(; v != m_centers[m_regions.center(v)]; v = m_regions.last_edge(v).source)
      path.push_back(m_regions.last_edge(v).edge);
  }
};

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_REGION_GRAPH_H
