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

#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>
#include <CGAL/boost/graph/internal/Graph_kernel/Execution.h>
#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>
#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>
#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>
#include <CGAL/boost/graph/internal/Graph_kernel/spanning_forest.h>

#include <limits>
#include <vector>

namespace CGAL::internal::Steiner_tree {

using namespace Graph_kernel;
using Graph_kernel::Edge;                    // CGAL::internal has another one
using Graph_kernel::minimum_spanning_forest; // has an overload here, which would hide it

// A tree in a `Csr_graph`: its edges in increasing order and the sum of their weights.
struct Tree
{
  std::vector<int> edges;
  double length = (std::numeric_limits<double>::infinity)();
};

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

} // namespace CGAL::internal::Steiner_tree

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_TREE_H
