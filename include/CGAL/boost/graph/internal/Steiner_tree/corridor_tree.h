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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_CORRIDOR_TREE_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_CORRIDOR_TREE_H

#include <CGAL/boost/graph/internal/Steiner_tree/Bounded_instance.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Region_graph.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

// for each edge: does it leave the `size` vertices nearest to these edges?
inline std::vector<char> is_outside_corridor(const Csr_graph& graph, const std::vector<int>& edges, int size)
{
  std::vector<char> is_inside(graph.number_of_vertices(), 0);
  Shortest_paths paths(graph);
  for(int e : edges) {
    paths.add_source(graph.edges[e].source);
    paths.add_source(graph.edges[e].target);
  }
  int number = 0;
  paths.run([&](int v) {
    is_inside[v] = 1;
    return ++number < size;
  });
  std::vector<char> is_outside(graph.number_of_edges());
  for(int e = 0; e < graph.number_of_edges(); ++e)
    is_outside[e] = !is_inside[graph.edges[e].source] || !is_inside[graph.edges[e].target];
  return is_outside;
}

// the best tree without the edges removed that reductions and so many states of the program find
inline Tree improved_tree(const Csr_graph& graph, const std::vector<int>& terminals, const std::vector<char>& is_removed,
                          const Tree& tree, std::size_t maximum_number_of_states, Execution execution,
                          const Go_further& go_further)
{
  constexpr double good_ratio = 0.7; // of the edges that a reduction leaves, for one more
  Bounded_instance instance(graph, terminals, is_removed, tree, execution, go_further);
  if(instance.reduce(1, good_ratio, go_further))
    instance.search(maximum_number_of_states, go_further);
  return instance.tree();
}

// the shortest tree of a coarser graph
inline std::vector<int> coarse_tree(const Csr_graph& graph, const std::vector<int>& terminals,
                                    std::size_t maximum_number_of_states, Execution execution,
                                    const Go_further& go_further)
{
  constexpr int number_of_centers = 3000;
  const Region_graph regions(graph, terminals, number_of_centers);
  std::vector<int> positions; // the terminals are the first vertices
  for(std::size_t i = 0; i < terminals.size(); ++i)
    positions.push_back(int(i));
  const Tree tree = improved_tree(regions.graph(), positions, std::vector<char>(regions.graph().number_of_edges(), 0),
                                  shortest_path_heuristic(regions.graph(), positions, go_further),
                                  maximum_number_of_states, execution, go_further);
  return regions.original_edges(tree.edges);
}

// A tree that is shortest among those near it, for graphs so large that searching the whole takes a good bound: the
// best tree in a corridor around the one given and one that is shortest in a coarser graph; then always the best in a
// corridor around the last one, as long as that pays.
inline Tree corridor_tree(const Csr_graph& graph, const std::vector<int>& terminals, Tree tree,
                          std::size_t maximum_number_of_states, Execution execution, const Go_further& go_further)
{
  constexpr int width = 12;           // vertices per edge of the tree
  constexpr double least_gain = 2e-3; // of the length, for one more corridor
  constexpr int maximum_number_of_corridors = 5;
  std::vector<int> middle = coarse_tree(graph, terminals, maximum_number_of_states, execution, go_further);
  middle.insert(middle.end(), tree.edges.begin(), tree.edges.end());
  for(int i = 0; i < maximum_number_of_corridors && go_further(); ++i) {
    const double former = tree.length;
    tree = improved_tree(graph, terminals, is_outside_corridor(graph, middle, width * int(middle.size())), tree,
                         maximum_number_of_states, execution, go_further);
    if(tree.length > (1. - least_gain) * former)
      break;
    middle = tree.edges;
  }
  return tree;
}

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_CORRIDOR_TREE_H
