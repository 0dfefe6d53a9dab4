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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_OPTIONS_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_OPTIONS_H

#include <cstddef>
#include <limits>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

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

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_OPTIONS_H
