// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

// Steiner trees in graphs given by lists of edges.

#ifndef SURFACE_MESH_CUTTING_PYTHON_FIND_STEINER_TREE_H
#define SURFACE_MESH_CUTTING_PYTHON_FIND_STEINER_TREE_H

#include "Run_monitor.h"
#include "array_views.h"

#include <CGAL/boost/graph/internal/Steiner_tree/solve.h>

#include <cstdint>
#include <vector>

namespace binding {

struct Graph_view
{
  std::size_t number_of_vertices;
  Indices edges; // two vertices each, in range
  Numbers weights; // finite and not negative
};

struct Steiner_options
{
  CGAL::internal::Steiner_tree::Options options;
  bool needs_proof = false; // whether it is an error if the tree is not proven shortest
};

enum class Steiner_outcome { OK, TERMINALS_NOT_CONNECTED, BUDGET_EXCEEDED, STOPPED };

struct Steiner_result
{
  Steiner_outcome outcome = Steiner_outcome::OK;
  std::vector<std::int64_t> edges; // positions in the list, increasing
  double length = 0, lower_bound = 0;
  bool is_optimal = false;
  int number_of_auxiliary_points = 0;
};

Steiner_result find_steiner_tree(const Graph_view& graph, const Indices& terminals, const Steiner_options& options,
                                 Run_monitor& monitor);

} // namespace binding

#endif // SURFACE_MESH_CUTTING_PYTHON_FIND_STEINER_TREE_H
