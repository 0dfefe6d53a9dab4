// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#include "find_steiner_tree.h"

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/boost/graph/internal/Steiner_tree/solve.h>
#include <CGAL/tags.h>

#include <utility>

namespace binding {

namespace {

namespace Core = CGAL::internal::Steiner_tree;

Core::Csr_graph csr_graph(const Graph_view& graph)
{
  std::vector<Core::Edge> edges;
  edges.reserve(graph.weights.size());
  for(std::ptrdiff_t e = 0; e < std::ptrdiff_t(graph.weights.size()); ++e)
    edges.push_back({int(graph.edges[2 * e]), int(graph.edges[2 * e + 1]), graph.weights[e]});
  return Core::Csr_graph(int(graph.number_of_vertices), std::move(edges));
}

Steiner_outcome outcome_of(Core::Outcome outcome, bool needs_proof)
{
  switch(outcome)
  {
  case Core::Outcome::done: return Steiner_outcome::OK;
  case Core::Outcome::terminals_not_connected: return Steiner_outcome::TERMINALS_NOT_CONNECTED;
  case Core::Outcome::budget_exceeded: return needs_proof ? Steiner_outcome::BUDGET_EXCEEDED : Steiner_outcome::OK;
  case Core::Outcome::cancelled: return Steiner_outcome::STOPPED;
  }
  return Steiner_outcome::OK;
}

} // namespace

Steiner_result find_steiner_tree(const Graph_view& graph_view, const Indices& terminals, const Steiner_options& options,
                                 Run_monitor& monitor)
{
  const Core::Csr_graph graph = csr_graph(graph_view);
  std::vector<int> different;
  std::vector<char> is_terminal(graph_view.number_of_vertices, 0);
  for(const std::int64_t v : terminals)
    if(!std::exchange(is_terminal[std::size_t(v)], char(1)))
      different.push_back(int(v));

  const Core::Solution solution = Core::solve(
    graph, different, options.options,
    CGAL::internal::Graph_kernel::execution_of<CGAL::Parallel_if_available_tag>(), [&] { return monitor.go_further(); });
  Steiner_result result;
  result.outcome = outcome_of(solution.outcome, options.needs_proof);
  if(result.outcome == Steiner_outcome::TERMINALS_NOT_CONNECTED)
    return result;
  result.edges.assign(solution.tree.edges.begin(), solution.tree.edges.end());
  result.length = solution.tree.length;
  result.lower_bound = solution.lower_bound;
  result.is_optimal = solution.is_optimal;
  result.number_of_auxiliary_points = int(Core::branch_vertices(graph, different, solution.tree).size());
  return result;
}

} // namespace binding
