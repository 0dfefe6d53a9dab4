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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_SOLVE_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_SOLVE_H

#include <CGAL/boost/graph/internal/Steiner_tree/Tree.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::internal::Steiner_tree {

enum class Method
{
  metric_closure,
  shortest_path_heuristic,
  greedy_auxiliary_points,                    // the points connected along the metric closure
  greedy_auxiliary_points_and_shortest_paths, // or by the shortest path heuristic
  local_search,
  exact
};

struct Options
{
  Method method = Method::exact;
  double minimum_length_decrease = 0.;
  std::size_t maximum_number_of_states = 20000000;
  // Beyond this number, near points replace the exact solver.
  std::size_t maximum_number_of_terminals = (std::numeric_limits<std::size_t>::max)();
};

enum class Outcome
{
  done, // for the exact method: with proof
  terminals_not_connected,
  budget_exceeded,
  cancelled
};

// If not all terminals are connected there is no tree; otherwise there is one whatever the outcome.
struct Solution
{
  Outcome outcome = Outcome::done;
  Tree tree;
  double lower_bound = 0.;
  bool is_optimal = false;
};

// vertices that branch the tree without being terminals
std::vector<int> branch_vertices(const Csr_graph& graph, const std::vector<int>& terminals, const Tree& tree);

// where the terminals are not connected, or fewer than two
std::optional<Solution> solve_without_search(const Csr_graph& graph, const std::vector<int>& terminals);

// the solution with what follows from it. All methods begin with a shortest path between two terminals.
Solution concluded(Solution solution, bool is_shortest_path, const Go_further& go_further);

// connects the terminals, which must be different vertices. `go_further()` is asked between steps; false cancels.
// Weights must be finite and not negative. The exact method begins with the edges of a `known` tree, if one is given.
Solution solve(const Csr_graph& graph, const std::vector<int>& terminals, const Options& options,
               Execution execution, const Go_further& go_further, const std::vector<int>& known = {});

} // namespace CGAL::internal::Steiner_tree

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/boost/graph/internal/Steiner_tree/solve_impl.h>
#endif

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_SOLVE_H
