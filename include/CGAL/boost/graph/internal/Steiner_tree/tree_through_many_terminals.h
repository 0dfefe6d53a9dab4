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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_TREE_THROUGH_MANY_TERMINALS_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_TREE_THROUGH_MANY_TERMINALS_H

#include <CGAL/boost/graph/internal/Steiner_tree/Near_points.h>
#include <CGAL/boost/graph/internal/Steiner_tree/local_search.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

// How often perturbed weights may lead to another tree: each time takes about as long as so many states of the
// program for each vertex. More seldom find a better one.
inline int number_of_perturbations(const Csr_graph& graph, std::size_t maximum_number_of_states)
{
  constexpr std::size_t states_per_vertex = 100, enough = 24;
  return int((std::min)(enough, maximum_number_of_states / (states_per_vertex * (graph.number_of_vertices() + 1))));
}

// Near points improved, and again from where perturbed weights lead them; about a percent longer than the shortest
// tree. O(n log n) for each round of improvements, mostly less than twenty.
inline Tree tree_through_many_terminals(const Csr_graph& graph, const std::vector<int>& terminals,
                                        std::size_t maximum_number_of_states, const Go_further& go_further)
{
  constexpr double tolerance = 1e-10; // larger than rounding errors
  std::vector<int> best;
  double length = Shortest_paths::infinity();
  Tree tree;
  const auto improve = [&](const std::vector<int>& auxiliary_points) {
    Near_points points(graph, terminals, auxiliary_points);
    points.improve(tolerance * points.length(), go_further);
    if(!(points.length() < length))
      return;
    length = points.length();
    best = points.auxiliary_points();
    const Tree other = points.tree();
    if(other.length < tree.length)
      tree = other;
  };
  improve({});
  const int rounds = number_of_perturbations(graph, maximum_number_of_states);
  for(int i = 0; i < rounds && go_further(); ++i) {
    const Csr_graph other = perturbed(graph, (unsigned int)i);
    Near_points points(other, terminals, best);
    points.improve(tolerance * points.length(), go_further);
    improve(points.auxiliary_points());
  }
  return tree;
}

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_TREE_THROUGH_MANY_TERMINALS_H
