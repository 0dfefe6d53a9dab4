#ifndef STEINER_TREE_CHECKS_H
#define STEINER_TREE_CHECKS_H

#include "check.h"

#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>
#include <CGAL/boost/graph/internal/Steiner_tree/solve.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <numeric>
#include <vector>

namespace Core = CGAL::internal::Steiner_tree;

inline bool are_equal(double a, double b)
{
  return std::abs(a - b) <= 1e-9 * (std::max)(std::abs(a), std::abs(b));
}

// no cycle, all terminals connected, no leaf that is no terminal, and the length is right
inline void check_tree(const Core::Csr_graph& graph, const std::vector<int>& terminals, const Core::Tree& tree)
{
  CGAL::internal::Graph_kernel::Disjoint_sets components(graph.number_of_vertices());
  std::vector<int> degree(graph.number_of_vertices(), 0);
  double length = 0.;
  for(int e : tree.edges) {
    CHECK(components.unite(graph.edges[e].source, graph.edges[e].target));
    ++degree[graph.edges[e].source];
    ++degree[graph.edges[e].target];
    length += graph.edges[e].weight;
  }
  CHECK(are_equal(length, tree.length));
  for(int t : terminals)
    CHECK(components.find(t) == components.find(terminals.front()));
  for(int v = 0; v < graph.number_of_vertices(); ++v)
    CHECK(degree[v] != 1 || std::find(terminals.begin(), terminals.end(), v) != terminals.end());
  CHECK(tree.edges.empty() == (terminals.size() < 2));
}

inline Core::Solution solve(const Core::Csr_graph& graph, const std::vector<int>& terminals, Core::Method method,
                            double minimum_length_decrease = 0.)
{
  Core::Options options;
  options.method = method;
  options.minimum_length_decrease = minimum_length_decrease;
  return Core::solve(graph, terminals, options, Core::Execution::SEQUENTIAL, [] { return true; });
}

inline std::vector<int> all_edges(const Core::Csr_graph& graph)
{
  std::vector<int> edges(graph.number_of_edges());
  std::iota(edges.begin(), edges.end(), 0);
  return edges;
}

// A known tree, however long, changes nothing about what the exact method proves, and what that finds is never longer.
inline void check_known_tree(const Core::Csr_graph& graph, const std::vector<int>& terminals,
                             const std::vector<int>& known, double optimum)
{
  const double known_length = Core::make_tree(graph, terminals, known).length;
  Core::Options options;
  for(std::size_t states : {options.maximum_number_of_states, std::size_t(0)}) {
    options.maximum_number_of_states = states;
    const Core::Solution solution
      = Core::solve(graph, terminals, options, Core::Execution::SEQUENTIAL, [] { return true; }, known);
    check_tree(graph, terminals, solution.tree);
    CHECK(solution.tree.length <= known_length * (1. + 1e-9));
    CHECK(solution.tree.length >= optimum * (1. - 1e-9));
    CHECK(solution.lower_bound <= optimum * (1. + 1e-9));
    CHECK(states == 0 || solution.is_optimal);
    CHECK(!solution.is_optimal || are_equal(solution.tree.length, optimum));
  }
}

const Core::Method heuristics[] = {
  Core::Method::metric_closure, Core::Method::shortest_path_heuristic, Core::Method::greedy_auxiliary_points,
  Core::Method::greedy_auxiliary_points_and_shortest_paths, Core::Method::local_search};

// all methods on one problem whose optimum is known
inline void check_all_methods(const Core::Csr_graph& graph, const std::vector<int>& terminals, double optimum)
{
  for(Core::Method method : heuristics) {
    const Core::Solution solution = solve(graph, terminals, method);
    CHECK(solution.outcome == Core::Outcome::done);
    check_tree(graph, terminals, solution.tree);
    CHECK(solution.tree.length >= optimum * (1. - 1e-9));
    CHECK(solution.tree.length <= 2. * optimum * (1. + 1e-9));
    CHECK(solution.lower_bound <= optimum * (1. + 1e-9));
  }
  const Core::Solution exact = solve(graph, terminals, Core::Method::exact);
  CHECK(exact.outcome == Core::Outcome::done);
  CHECK(exact.is_optimal);
  check_tree(graph, terminals, exact.tree);
  CHECK(are_equal(exact.tree.length, optimum));
  CHECK(are_equal(exact.lower_bound, optimum));
  // without any state left, what the other parts of the exact solver find is a tree and a bound
  Core::Options options;
  options.maximum_number_of_states = 0;
  const Core::Solution solution = Core::solve(graph, terminals, options, Core::Execution::SEQUENTIAL, [] { return true; });
  check_tree(graph, terminals, solution.tree);
  CHECK(solution.tree.length >= optimum * (1. - 1e-9));
  CHECK(solution.lower_bound <= optimum * (1. + 1e-9));
  CHECK(!solution.is_optimal || are_equal(solution.tree.length, optimum));
  check_known_tree(graph, terminals, solve(graph, terminals, Core::Method::metric_closure).tree.edges, optimum);
  check_known_tree(graph, terminals, all_edges(graph), optimum);
  // where there are too many terminals for the exact solver, near points find a tree
  options.maximum_number_of_terminals = 0;
  options.maximum_number_of_states = 10000;
  const Core::Solution near = Core::solve(graph, terminals, options, Core::Execution::SEQUENTIAL, [] { return true; });
  check_tree(graph, terminals, near.tree);
  CHECK(near.tree.length >= optimum * (1. - 1e-9));
  CHECK(near.tree.length <= 2. * optimum * (1. + 1e-9));
  CHECK(near.lower_bound <= optimum * (1. + 1e-9));
}

#endif // STEINER_TREE_CHECKS_H
