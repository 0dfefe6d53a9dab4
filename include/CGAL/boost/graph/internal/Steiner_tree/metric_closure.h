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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_METRIC_CLOSURE_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_METRIC_CLOSURE_H

#include <CGAL/boost/graph/internal/Steiner_tree/Tree.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::internal::Steiner_tree {

// A coarser graph: some of the vertices as centers, joined where their regions touch by the shortest path from center
// to center through an edge between the regions. Its paths are paths of the graph, a few percent longer than the
// shortest ones; with terminals alone as centers, its minimum spanning trees are those of their metric closure
// (Mehlhorn 1988). One search from all centers: O(m log n)
class Region_graph
{
  const Csr_graph& m_graph;
  Shortest_paths m_paths;
  std::vector<int> m_bridges; // of the edges
  Csr_graph m_coarse;

public:
  Region_graph(const Csr_graph& graph, const std::vector<int>& centers) : m_graph(graph), m_paths(graph)
  {
    std::vector<int> nearest(graph.number_of_vertices(), -1); // positions of the centers
    for(std::size_t i = 0; i < centers.size(); ++i) {
      nearest[centers[i]] = int(i);
      m_paths.add_source(centers[i]);
    }
    m_paths.run([&](int v) {
      if(m_paths.last_edge(v) >= 0)
        nearest[v] = nearest[m_paths.predecessor(v)];
      return true;
    });
    std::vector<Edge> coarse_edges;
    for(int e = 0; e < graph.number_of_edges(); ++e) {
      const Edge& edge = graph.edges[e];
      if(nearest[edge.source] == nearest[edge.target])
        continue;
      const double length = m_paths.distance(edge.source) + edge.weight + m_paths.distance(edge.target);
      coarse_edges.push_back(Edge{nearest[edge.source], nearest[edge.target], length});
      m_bridges.push_back(e);
    }
    m_coarse = Csr_graph(int(centers.size()), std::move(coarse_edges));
  }

  const Csr_graph& graph() const { return m_coarse; }

  // the edges of the paths that these edges stand for
  std::vector<int> original_edges(const std::vector<int>& coarse_edges) const
  {
    std::vector<int> result;
    for(int e : coarse_edges) {
      const int bridge = m_bridges[e];
      result.push_back(bridge);
      for(int v : {m_graph.edges[bridge].source, m_graph.edges[bridge].target})
        m_paths.path(v, std::back_inserter(result));
    }
    sort_unique(result);
    return result;
  }
};

// of parallel edges the shortest ones (the first of equals)
inline std::vector<int> shortest_parallel_edges(const Csr_graph& graph)
{
  std::vector<int> best(graph.number_of_vertices(), -1), result;
  for(int v = 0; v < graph.number_of_vertices(); ++v) {
    for(int i = graph.offsets[v]; i < graph.offsets[v + 1]; ++i) {
      int& e = best[graph.arcs[i].target];
      if(e < 0 || graph.arcs[i].weight < graph.edges[e].weight)
        e = graph.arcs[i].edge;
    }
    for(int i = graph.offsets[v]; i < graph.offsets[v + 1]; ++i) {
      int& e = best[graph.arcs[i].target];
      if(e >= 0 && v < graph.arcs[i].target)
        result.push_back(e);
      e = -1;
    }
  }
  return result;
}

// the edges of a minimum spanning forest, by Boost
inline std::vector<int> minimum_spanning_forest(const Csr_graph& graph)
{
  return minimum_spanning_forest(graph, shortest_parallel_edges(graph));
}

// The tree of Kou, Markowsky and Berman (1981; paper, Section 3.2): a minimum spanning tree of the metric closure of the
// terminals, as the union of its shortest paths. Mehlhorn (1988) reads one such tree off a single search from all
// terminals: the shortest connections among the edges that join the regions of two terminals. These regions are spanned
// by trees: the union has no cycle and only terminals as leaves. If the terminals are not connected, it is a forest.
inline Tree metric_closure_tree(const Csr_graph& graph, const std::vector<int>& terminals)
{
  const Region_graph regions(graph, terminals);
  Tree tree;
  tree.edges = regions.original_edges(minimum_spanning_forest(regions.graph()));
  tree.length = total_weight(graph, tree.edges);
  return tree;
}

// The shortest path heuristic of Takahashi and Matsuyama (1980): grows a tree from `start`, always by a shortest
// path to the nearest terminal outside. One search serves all steps: the vertices of a new path become sources
// and lower the distances around them. The tree has infinite length if a terminal cannot be reached or it is stopped.
// `weight(i)` is the weight of arc i.
template <typename Weight>
Tree grow_tree(const Csr_graph& graph, const std::vector<int>& terminals, int start, Weight weight,
               const Go_further& go_further)
{
  std::vector<char> is_terminal = mark(graph.number_of_vertices(), terminals);
  std::size_t remaining = terminals.size();
  std::vector<int> tree_edges;
  Shortest_paths paths(graph);
  paths.add_source(start);
  Patience patience(go_further);
  paths.run([&](int v) {
    if(!patience.lasts())
      return false;
    if(is_terminal[v] != 1)
      return true;
    is_terminal[v] = 2; // reached
    for(int u = v; paths.last_edge(u) >= 0;) {
      const int e = paths.last_edge(u), next = paths.predecessor(u);
      tree_edges.push_back(e);
      paths.make_source(u);
      u = next;
    }
    return --remaining > 0;
  }, weight);
  return remaining == 0 ? make_tree(graph, terminals, tree_edges) : Tree();
}

// a terminal that has another terminal nearest to it: from there the heuristic grows as in the paper (Section 4.1),
// which begins with the nearest pair
inline int terminal_of_nearest_pair(const Csr_graph& graph, const std::vector<int>& terminals)
{
  const std::vector<Edge> connections = Region_graph(graph, terminals).graph().edges;
  const auto nearest = std::min_element(connections.begin(), connections.end(),
                                        [](const Edge& a, const Edge& b) { return a.weight < b.weight; });
  return nearest == connections.end() ? terminals.front()
                                      : (std::min)(terminals[nearest->source], terminals[nearest->target]);
}

// the same from there; if it is stopped, the tree of the metric closure, which is found at once
inline Tree shortest_path_heuristic(const Csr_graph& graph, const std::vector<int>& terminals,
                                    const Go_further& go_further)
{
  const Tree tree = grow_tree(graph, terminals, terminal_of_nearest_pair(graph, terminals),
                              [&](int i) { return graph.arcs[i].weight; }, go_further);
  return tree.edges.empty() ? metric_closure_tree(graph, terminals) : tree;
}

} // namespace CGAL::internal::Steiner_tree

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_METRIC_CLOSURE_H
