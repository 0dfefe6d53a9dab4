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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_SOLVE_IMPL_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_SOLVE_IMPL_H

#include <CGAL/boost/graph/internal/Graph_kernel/separate_implementation.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Exact_solver.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Near_points.h>
#include <CGAL/boost/graph/internal/Steiner_tree/local_search.h>
#include <CGAL/boost/graph/internal/Steiner_tree/metric_closure.h>
#include <CGAL/boost/graph/internal/Steiner_tree/solve.h>

#include <algorithm>
#include <utility>

namespace CGAL::internal::Steiner_tree {

// How often perturbed weights may lead to another tree: each time takes about as long as so many states of the
// program for each vertex. Further ones rarely find a better tree.
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

CGAL_INLINE_UNLESS_SEPARATE
std::vector<int> branch_vertices(const Csr_graph& graph, const std::vector<int>& terminals, const Tree& tree)
{
  std::vector<int> ends;
  for(int e : tree.edges) {
    ends.push_back(graph.edges[e].source);
    ends.push_back(graph.edges[e].target);
  }
  std::sort(ends.begin(), ends.end());
  std::vector<int> result;
  for(auto it = ends.begin(); it != ends.end();) {
    const auto next = std::upper_bound(it, ends.end(), *it);
    if(next - it >= 3 && std::find(terminals.begin(), terminals.end(), *it) == terminals.end())
      result.push_back(*it);
    it = next;
  }
  return result;
}

inline Tree greedy_tree(const Csr_graph& graph, const std::vector<int>& terminals, const Options& options,
                        Execution execution, const Go_further& go_further)
{
  Key_points points(graph, terminals, execution, go_further);
  if(!points.is_complete())
    return metric_closure_tree(graph, terminals);
  const Tree tree = insert_auxiliary_points(points, options.minimum_length_decrease, go_further);
  if(options.method == Method::greedy_auxiliary_points)
    return tree;
  std::vector<int> keys(terminals);
  for(int i = 0; i < points.number_of_auxiliary_points(); ++i)
    keys.push_back(points.auxiliary_point(i));
  const Tree grown = shortest_path_heuristic(graph, keys, go_further);
  return make_tree(graph, terminals, grown.edges);
}

// local search from two sides: from the terminals, and from the branches that the shortest path heuristic finds
inline Tree local_search_tree(const Csr_graph& graph, const std::vector<int>& terminals,
                              Execution execution, const Go_further& go_further)
{
  const Tree grown = shortest_path_heuristic(graph, terminals, go_further);
  const double minimum_decrease = 1e-10 * grown.length;
  Key_points points(graph, terminals, execution, go_further);
  if(!points.is_complete())
    return grown;
  const Tree first = local_search(points, minimum_decrease, go_further);
  for(int v : branch_vertices(graph, terminals, grown))
    points.insert(v);
  const Tree second = local_search(points, minimum_decrease, go_further);
  return second.length < first.length ? second : first;
}

CGAL_INLINE_UNLESS_SEPARATE
std::optional<Solution> solve_without_search(const Csr_graph& graph, const std::vector<int>& terminals)
{
  Solution solution;
  if(!are_connected(graph, terminals, [](int) { return true; })) {
    solution.outcome = Outcome::terminals_not_connected;
    return solution;
  }
  if(terminals.size() < 2) {
    solution.tree.length = 0.;
    solution.is_optimal = true;
    return solution;
  }
  return std::nullopt;
}

CGAL_INLINE_UNLESS_SEPARATE
Solution concluded(Solution solution, bool is_shortest_path, const Go_further& go_further)
{
  if(is_shortest_path) {
    solution.is_optimal = true;
    solution.outcome = Outcome::done;
  }
  if(solution.is_optimal)
    solution.lower_bound = solution.tree.length;
  else if(!go_further())
    solution.outcome = Outcome::cancelled;
  return solution;
}

CGAL_INLINE_UNLESS_SEPARATE
Solution solve(const Csr_graph& graph, const std::vector<int>& terminals, const Options& options,
               Execution execution, const Go_further& go_further, const std::vector<int>& known)
{
  if(const std::optional<Solution> solution = solve_without_search(graph, terminals))
    return *solution;
  Solution solution;
  switch(options.method) {
  case Method::metric_closure:
    solution.tree = metric_closure_tree(graph, terminals);
    break;
  case Method::shortest_path_heuristic:
    solution.tree = shortest_path_heuristic(graph, terminals, go_further);
    break;
  case Method::greedy_auxiliary_points:
  case Method::greedy_auxiliary_points_and_shortest_paths:
    solution.tree = greedy_tree(graph, terminals, options, execution, go_further);
    break;
  case Method::local_search:
    solution.tree = local_search_tree(graph, terminals, execution, go_further);
    break;
  case Method::exact:
    if(terminals.size() > options.maximum_number_of_terminals) {
      solution.tree = tree_through_many_terminals(graph, terminals, options.maximum_number_of_states, go_further);
      break;
    }
    const bool needs_near_points = known.empty() && terminals.size() > std::size_t(largest_number_of_terminals);
    const Exact_solver solver(
      graph, terminals, options.maximum_number_of_states, execution, go_further,
      needs_near_points
        ? tree_through_many_terminals(graph, terminals, options.maximum_number_of_states, go_further).edges
        : known);
    solution.tree = solver.tree();
    solution.lower_bound = solver.lower_bound();
    solution.is_optimal = solver.is_optimal();
    if(!solution.is_optimal)
      solution.outcome = Outcome::budget_exceeded;
    break;
  }
  return concluded(std::move(solution), terminals.size() == 2 && known.empty(), go_further);
}

} // namespace CGAL::internal::Steiner_tree

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_SOLVE_IMPL_H
