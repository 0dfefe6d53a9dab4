// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_TREE_COTREE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_TREE_COTREE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Contracted_surface.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Disjoint_sets.h>
#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>
#include <CGAL/boost/graph/internal/Graph_kernel/spanning_forest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using CGAL::internal::Graph_kernel::Disjoint_sets;
using CGAL::internal::Graph_kernel::Shortest_paths;

// Splits the edges of a surface into a spanning forest, one of the dual graph that does not cross
// it, and 2g generators (Erickson and Whittlesey 2005). The edges of the first and the last
// together are a cut graph: their complement is a disk in each part of the surface.
//
// Each generator closes a loop in the dual forest. Which of these loops cross an edge is the
// signature of the edge, a set of 2g bits; the exclusive or over a cycle tells its homology class
// over Z_2. A simple cycle separates the surface iff that is zero.
class Tree_cotree
{
public:
  using Word = std::uint64_t;

  // O(n log n + g n)
  Tree_cotree(const Corner_table& chart, const Contracted_surface& surface)
    : m_chart(chart), m_surface(surface)
  {
    const std::vector<int> candidates = grow_tree();
    const std::vector<int> cotree = grow_cotree(candidates);
    compute_signatures(cotree);
    prune_cut_graph();
  }

  const std::vector<int>& generators() const { return m_generators; }

  // The nodes of the cut graph without its dead ends; every cycle that does not separate meets one.
  const std::vector<int>& cut_graph_nodes() const { return m_cut_graph_nodes; }

  std::size_t number_of_words() const { return m_number_of_words; }
  const Word* signature(int e) const { return m_signatures.data() + e * m_number_of_words; }

private:
  int first_face(int e) const { return m_surface.halfedges[e] / 3; }
  int second_face(int e) const { return m_chart.opposite(m_surface.halfedges[e]) / 3; }

  // A forest of shortest paths, so that generators with short loops can be chosen; edges of
  // infinite weight join what shortest paths leave apart. Returns the other edges, those with the
  // longest loops first.
  std::vector<int> grow_tree()
  {
    const Csr_graph& graph = m_surface.graph;
    Shortest_paths paths(graph);
    Disjoint_sets nodes(graph.number_of_vertices());
    for(int v = 0; v < graph.number_of_vertices(); ++v)
      if(paths.distance(v) == Shortest_paths::infinity())
      {
        paths.add_source(v);
        paths.run();
      }
    std::vector<char> is_in_tree(graph.number_of_edges(), 0);
    for(int v = 0; v < graph.number_of_vertices(); ++v)
      if(paths.last_edge(v) >= 0)
      {
        is_in_tree[paths.last_edge(v)] = 1;
        nodes.unite(v, paths.predecessor(v));
      }
    std::vector<std::pair<double, int> > others;
    for(int e = 0; e < graph.number_of_edges(); ++e)
    {
      const int s = graph.edges[e].source, t = graph.edges[e].target;
      if(is_in_tree[e] || nodes.unite(s, t))
        m_cut_graph.push_back(e);
      else
        others.emplace_back(-(paths.distance(s) + graph.edges[e].weight + paths.distance(t)), e);
    }
    std::sort(others.begin(), others.end());
    std::vector<int> edges;
    for(const std::pair<double, int>& other : others)
      edges.push_back(other.second);
    return edges;
  }

  // Takes what fits together of the candidates; what is left are the generators.
  std::vector<int> grow_cotree(const std::vector<int>& candidates)
  {
    Disjoint_sets faces(m_chart.number_of_triangles());
    std::vector<int> cotree;
    for(int e : candidates)
      (faces.unite(first_face(e), second_face(e)) ? cotree : m_generators).push_back(e);
    return cotree;
  }

  // Sums up the generators beyond each edge of the cotree, from the leaves to the roots.
  void compute_signatures(const std::vector<int>& cotree)
  {
    m_number_of_words = (m_generators.size() + 63) / 64;
    m_signatures.assign(m_number_of_words * m_surface.graph.number_of_edges(), 0);
    std::vector<Word> sums(m_number_of_words * m_chart.number_of_triangles(), 0);
    for(std::size_t i = 0; i < m_generators.size(); ++i)
    {
      const int e = m_generators[i];
      const Word bit = Word(1) << (i % 64);
      m_signatures[e * m_number_of_words + i / 64] ^= bit;
      for(int f : {first_face(e), second_face(e)})
        sums[f * m_number_of_words + i / 64] ^= bit;
    }

    std::vector<CGAL::internal::Graph_kernel::Edge> dual_edges;
    for(int e : cotree)
      dual_edges.push_back({first_face(e), second_face(e), 0.});
    const Csr_graph dual(m_chart.number_of_triangles(), std::move(dual_edges));
    std::vector<int> order, last_edge;
    traverse(dual, order, last_edge);
    for(auto it = order.rbegin(); it != order.rend(); ++it)
    {
      if(last_edge[*it] < 0)
        continue;
      const int parent = dual.opposite(last_edge[*it], *it);
      for(std::size_t w = 0; w < m_number_of_words; ++w)
      {
        const Word sum = sums[*it * m_number_of_words + w];
        m_signatures[cotree[last_edge[*it]] * m_number_of_words + w] = sum;
        sums[parent * m_number_of_words + w] ^= sum;
      }
    }
  }

  // The vertices of a forest, parents before children.
  static void traverse(const Csr_graph& forest, std::vector<int>& order,
                       std::vector<int>& last_edge)
  {
    std::vector<char> is_reached(forest.number_of_vertices(), 0);
    last_edge.assign(forest.number_of_vertices(), -1);
    for(int root = 0; root < forest.number_of_vertices(); ++root)
    {
      if(is_reached[root])
        continue;
      is_reached[root] = 1;
      order.push_back(root);
      for(std::size_t i = order.size() - 1; i < order.size(); ++i)
        for(int a = forest.offsets[order[i]]; a < forest.offsets[order[i] + 1]; ++a)
        {
          const Csr_graph::Arc& arc = forest.arcs[a];
          if(std::exchange(is_reached[arc.target], char(1)))
            continue;
          last_edge[arc.target] = arc.edge;
          order.push_back(arc.target);
        }
    }
  }

  void prune_cut_graph()
  {
    const Csr_graph& graph = m_surface.graph;
    m_cut_graph.insert(m_cut_graph.end(), m_generators.begin(), m_generators.end());
    std::sort(m_cut_graph.begin(), m_cut_graph.end());
    const std::vector<char> no_terminals(graph.number_of_vertices(), 0);
    CGAL::internal::Graph_kernel::prune_leaves(graph, no_terminals, m_cut_graph);
    for(int e : m_cut_graph)
      for(int v : {graph.edges[e].source, graph.edges[e].target})
        m_cut_graph_nodes.push_back(v);
    std::sort(m_cut_graph_nodes.begin(), m_cut_graph_nodes.end());
    m_cut_graph_nodes.erase(std::unique(m_cut_graph_nodes.begin(), m_cut_graph_nodes.end()),
                            m_cut_graph_nodes.end());
  }

  const Corner_table& m_chart;
  const Contracted_surface& m_surface;
  std::vector<int> m_cut_graph, m_generators, m_cut_graph_nodes;
  std::size_t m_number_of_words = 0;
  std::vector<Word> m_signatures;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_TREE_COTREE_H
