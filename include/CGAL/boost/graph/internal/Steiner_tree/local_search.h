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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_LOCAL_SEARCH_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_LOCAL_SEARCH_H

#include <CGAL/boost/graph/internal/Steiner_tree/greedy_auxiliary_points.h>

#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

// Local search over the auxiliary points (key vertices) after the greedy insertion: eliminates a point and inserts
// the best others again (which includes exchanges) as long as the tree, measured by the union of its paths, gets
// shorter. `minimum_decrease` keeps rounding errors from looking like progress.
inline Tree local_search(Key_points points, double minimum_decrease, const Go_further& go_further)
{
  Tree best = insert_auxiliary_points(points, minimum_decrease, go_further);
  for(int i = 0; i < points.number_of_auxiliary_points() && go_further(); ++i) {
    Key_points candidate = points;
    candidate.erase_auxiliary_point(i);
    const Tree tree = insert_auxiliary_points(candidate, minimum_decrease, go_further);
    const bool is_shorter = tree.length < best.length - minimum_decrease;
    if(is_shorter || candidate.length() < points.length() - minimum_decrease) {
      if(is_shorter)
        best = tree;
      points = candidate;
      i = -1;
    }
  }
  return best;
}

// the graph with weights up to a fifth larger, at random: another way into the local search, and out of ties
inline Csr_graph perturbed(const Csr_graph& graph, unsigned int seed)
{
  std::mt19937 generator(seed);
  std::vector<Edge> edges(graph.edges);
  for(Edge& e : edges)
    e.weight *= 1. + 0.2 * double(generator()) / 4294967296.;
  return Csr_graph(graph.number_of_vertices(), std::move(edges));
}

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_LOCAL_SEARCH_H
