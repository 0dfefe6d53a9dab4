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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_TREE_STATES_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_TREE_STATES_H

#include <algorithm>
#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

// The states of `Pruned_dynamic_program` for one set of terminals. They do not depend on how sets are held, so that
// they are compiled once for sets of any width.
class Tree_states
{
public:
  // How a state was made: by the edge to its predecessor (>= 0), from its terminal, or by the merge of two sets
  // at the same vertex (-2 - index of the merge).
  static constexpr int from_terminal = -1;

  struct State
  {
    int vertex;
    int origin;
    double length;
  };

  struct Merge
  {
    int first;
    int second;
  };

  // of the merges of the present set with another one
  struct Target
  {
    int table = -1;
    int merge = -1;
  };

  static void sort_by_vertex(std::vector<State>& states)
  {
    std::sort(states.begin(), states.end(), [](const State& a, const State& b) { return a.vertex < b.vertex; });
  }

  // null if there is none
  static const State* find(const std::vector<State>& states, int vertex)
  {
    const auto state = std::lower_bound(states.begin(), states.end(), vertex,
                                        [](const State& s, int v) { return s.vertex < v; });
    return state != states.end() && state->vertex == vertex ? &*state : nullptr;
  }
};

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_TREE_STATES_H
