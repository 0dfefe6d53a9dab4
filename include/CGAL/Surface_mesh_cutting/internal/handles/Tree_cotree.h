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

#include <CGAL/Surface_mesh_cutting/internal/handles/Homology_class.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Contracted_surface.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>
#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>
#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>
#include <CGAL/boost/graph/internal/Graph_kernel/spanning_forest.h>

#include <algorithm>
#include <cstddef>
#include <random>
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
// signature of the edge; the exclusive or over a cycle tells its homology class over Z_2. A simple
// cycle separates the surface iff that is zero. A signature has a bit for each generator, or, where
// there are more generators than bits, each bit is the sum of a random half of them: then classes
// may be lost, with a probability of 2^-64 as long as 64 bits are left, but none is made up.
class Tree_cotree
{
public:
  // `seed` is that of the random sums. O(n log n)
  Tree_cotree(const Corner_table& chart, const Contracted_surface& surface, unsigned int seed = 0)
    : m_chart(chart), m_surface(surface), m_edges(chart.opposites().size(), -1)
  {
    for(int e = 0; e < surface.graph.number_of_edges(); ++e)
      m_edges[surface.halfedges[e]] = m_edges[chart.opposite(surface.halfedges[e])] = e;
    const std::vector<int> candidates = grow_tree();
    const std::vector<int> cotree = grow_cotree(candidates);
    compute_signatures(cotree, seed);
    prune_cut_graph();
  }

  const std::vector<int>& generators() const { return m_generators; }

  // The nodes of the cut graph without its dead ends; every cycle that does not separate meets one.
  const std::vector<int>& cut_graph_nodes() const { return m_cut_graph_nodes; }

  // What an edge, given by a halfedge, contributes to the class of a cycle; those of the border nothing.
  Homology_class signature(int h) const { return m_edges[h] < 0 ? Homology_class() : m_signatures[m_edges[h]]; }

  // How many loops the signatures can tell apart, with next to no error.
  int number_of_loops() const
  {
    return is_exact() ? int(m_generators.size()) / 2 : Homology_class::number_of_coordinates - reserve;
  }

private:
  static constexpr int reserve = 64; // coordinates: as many as make an error all but impossible

  bool is_exact() const { return m_generators.size() <= Homology_class::number_of_coordinates; }

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

  // One for each generator.
  std::vector<Homology_class> make_coordinates(unsigned int seed) const
  {
    std::mt19937_64 random(seed);
    std::vector<Homology_class> coordinates(m_generators.size());
    for(int i = 0; i < int(coordinates.size()); ++i)
      if(is_exact())
        coordinates[i].flip(i);
      else
        for(int w = 0; w < Homology_class::number_of_words; ++w)
          coordinates[i].word(w) = random();
    return coordinates;
  }

  // Sums up the generators beyond each edge of the cotree, from the leaves to the roots.
  void compute_signatures(const std::vector<int>& cotree, unsigned int seed)
  {
    const std::vector<Homology_class> coordinates = make_coordinates(seed);
    m_signatures.resize(m_surface.graph.number_of_edges());
    std::vector<Homology_class> sums(m_chart.number_of_triangles());
    for(std::size_t i = 0; i < m_generators.size(); ++i)
    {
      const int e = m_generators[i];
      m_signatures[e] = coordinates[i];
      sums[first_face(e)] ^= coordinates[i];
      sums[second_face(e)] ^= coordinates[i];
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
      m_signatures[cotree[last_edge[*it]]] = sums[*it];
      sums[dual.opposite(last_edge[*it], *it)] ^= sums[*it];
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
    CGAL::internal::Graph_kernel::sort_unique(m_cut_graph_nodes);
  }

  const Corner_table& m_chart;
  const Contracted_surface& m_surface;
  std::vector<int> m_cut_graph, m_generators, m_cut_graph_nodes;
  std::vector<int> m_edges; // of the graph, per halfedge
  std::vector<Homology_class> m_signatures;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_TREE_COTREE_H
