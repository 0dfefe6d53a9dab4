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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_TREE_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_TREE_H

#include <CGAL/boost/graph/internal/Steiner_tree/Csr_graph.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

// A tree in a `Csr_graph`: its edges in increasing order and the sum of their weights.
struct Tree
{
  std::vector<int> edges;
  double length = (std::numeric_limits<double>::infinity)();
};

class Disjoint_sets
{
  std::vector<int> m_rank, m_parent;
  boost::disjoint_sets<int*, int*> m_sets;

public:
  explicit Disjoint_sets(int size) : m_rank(size, 0), m_parent(size), m_sets(m_rank.data(), m_parent.data())
  {
    for(int i = 0; i < size; ++i)
      m_parent[i] = i;
  }

  int find(int i) { return m_sets.find_set(i); }

  // false if they were together already
  bool unite(int i, int j)
  {
    i = find(i);
    j = find(j);
    if(i == j)
      return false;
    m_sets.link(i, j);
    return true;
  }
};

// The vertices of some edges, numbered from 0: keeps the cost of a small tree in a large graph small.
class Vertex_ranks
{
  std::vector<int> m_vertices;

public:
  Vertex_ranks(const Csr_graph& graph, const std::vector<int>& edges)
  {
    for(int e : edges) {
      m_vertices.push_back(graph.edges[e].source);
      m_vertices.push_back(graph.edges[e].target);
    }
    std::sort(m_vertices.begin(), m_vertices.end());
    m_vertices.erase(std::unique(m_vertices.begin(), m_vertices.end()), m_vertices.end());
  }

  int size() const { return int(m_vertices.size()); }
  int vertex(int rank) const { return m_vertices[rank]; }
  int rank(int v) const
  {
    return int(std::lower_bound(m_vertices.begin(), m_vertices.end(), v) - m_vertices.begin());
  }
};

// keeps of the candidate edges a minimum spanning forest (Kruskal; ties by index)
inline std::vector<int> minimum_spanning_forest(const Csr_graph& graph, std::vector<int> candidates)
{
  std::sort(candidates.begin(), candidates.end(), [&](int a, int b) {
    const double wa = graph.edges[a].weight, wb = graph.edges[b].weight;
    return wa < wb || (wa == wb && a < b);
  });
  const Vertex_ranks ranks(graph, candidates);
  Disjoint_sets sets(ranks.size());
  std::vector<int> forest;
  for(int e : candidates)
    if(sets.unite(ranks.rank(graph.edges[e].source), ranks.rank(graph.edges[e].target)))
      forest.push_back(e);
  std::sort(forest.begin(), forest.end());
  return forest;
}

// removes the edges to leaves that are no terminals until no such leaf is left
inline void prune_leaves(const Csr_graph& graph, const std::vector<char>& is_terminal, std::vector<int>& forest)
{
  const Vertex_ranks ranks(graph, forest);
  // the exclusive or of a vertex's edges is its only edge once it is a leaf
  std::vector<int> degree(ranks.size(), 0), edges(ranks.size(), 0);
  for(int e : forest)
    for(int v : {graph.edges[e].source, graph.edges[e].target}) {
      ++degree[ranks.rank(v)];
      edges[ranks.rank(v)] ^= e;
    }
  std::vector<int> removed;
  for(int i = 0; i < ranks.size(); ++i)
    for(int leaf = i; degree[leaf] == 1 && !is_terminal[ranks.vertex(leaf)];) {
      const int e = edges[leaf];
      const int neighbor = ranks.rank(graph.opposite(e, ranks.vertex(leaf)));
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

inline std::vector<char> mark(int size, const std::vector<int>& indices)
{
  std::vector<char> marks(size, 0);
  for(int i : indices)
    marks[i] = 1;
  return marks;
}

// the tree left of a connected set of edges when cycles and dangling non-terminals are gone
inline Tree make_tree(const Csr_graph& graph, const std::vector<int>& terminals, const std::vector<int>& candidates)
{
  Tree tree;
  tree.edges = minimum_spanning_forest(graph, candidates);
  prune_leaves(graph, mark(graph.number_of_vertices(), terminals), tree.edges);
  tree.length = total_weight(graph, tree.edges);
  return tree;
}

// the best tree on the vertices of `tree`: all edges between them compete
inline Tree make_tree_on_same_vertices(const Csr_graph& graph, const std::vector<int>& terminals, const Tree& tree)
{
  std::vector<char> is_in_tree(graph.number_of_vertices(), 0);
  for(int e : tree.edges)
    is_in_tree[graph.edges[e].source] = is_in_tree[graph.edges[e].target] = 1;
  std::vector<int> candidates;
  for(int v = 0; v < graph.number_of_vertices(); ++v)
    if(is_in_tree[v])
      for(int i = graph.offsets[v]; i < graph.offsets[v + 1]; ++i)
        if(v < graph.arcs[i].target && is_in_tree[graph.arcs[i].target])
          candidates.push_back(graph.arcs[i].edge);
  Tree result = make_tree(graph, terminals, candidates);
  return result.length < tree.length ? result : tree;
}

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_TREE_H
