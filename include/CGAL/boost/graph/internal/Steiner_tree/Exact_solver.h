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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_EXACT_SOLVER_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_EXACT_SOLVER_H

#include <CGAL/boost/graph/internal/Steiner_tree/Dual_ascent.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Instance.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Pruned_dynamic_programme.h>
#include <CGAL/boost/graph/internal/Steiner_tree/local_search.h>
#include <CGAL/boost/graph/internal/Steiner_tree/shortest_path_heuristic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

// Finds a shortest tree: heuristics and dual ascent from both sides, which remove what no shorter tree can use, and
// the pruned dynamic programme on what is left. Without proof after `maximum_number_of_states`, the best tree found.
// All terminals must be in one component.
template <typename ConcurrencyTag, typename GoFurther>
class Exact_solver
{
  // A tree is optimal if none is shorter by more than this part of its length; larger than rounding errors.
  static constexpr double tolerance = 1e-10;

  const Csr_graph& m_graph;
  const std::vector<int>& m_terminals;
  std::size_t m_maximum_number_of_states;
  GoFurther m_go_further;
  bool m_has_integral_weights;
  Instance m_instance;
  Tree m_best;
  double m_lower_bound = 0.;
  bool m_is_optimal = false;
  int m_last_root = 0, m_best_root = 0;

public:
  Exact_solver(const Csr_graph& graph, const std::vector<int>& terminals, std::size_t maximum_number_of_states,
               GoFurther go_further)
    : m_graph(graph)
    , m_terminals(terminals)
    , m_maximum_number_of_states(maximum_number_of_states)
    , m_go_further(go_further)
    , m_has_integral_weights(std::all_of(graph.edges.begin(), graph.edges.end(),
                                         [](const Edge& e) { return e.weight == std::floor(e.weight); }))
    , m_instance(graph, terminals)
  {
    run();
    if(m_is_optimal)
      m_lower_bound = m_best.length;
  }

  const Tree& tree() const { return m_best; }
  double lower_bound() const { return m_lower_bound; }
  bool is_optimal() const { return m_is_optimal; }

private:
  // what a tree has to fall short of
  double cut() const
  {
    return m_has_integral_weights ? m_best.length - 0.5 : m_best.length * (1. - tolerance);
  }

  // the length of the shortest tree of the instance is this much less than that of the original problem
  double fixed_length() const { return total_weight(m_graph, m_instance.original_edges({})); }

  void run()
  {
    improve(shortest_path_heuristic(m_graph, m_terminals, terminal_of_nearest_pair(m_graph, m_terminals)));
    if(!reduce(0) || !m_go_further())
      return;
    const Csr_graph& graph = m_instance.graph();
    const double memory = double(graph.number_of_vertices()) * double(m_instance.terminals().size());
    if(memory <= double(m_maximum_number_of_states)) {
      Key_points points(graph, m_instance.terminals(), ConcurrencyTag());
      improve(local_search(points, tolerance * m_best.length, ConcurrencyTag(), m_go_further));
    }
    // the programme with few states first; if these do not suffice, more effort for the bounds on both sides pays
    if(!reduce_repeatedly(1, 0.7) || search(m_maximum_number_of_states / 20) || !m_go_further())
      return;
    search_locally_in_perturbed_graphs();
    if(reduce_repeatedly(4, 0.98))
      search(m_maximum_number_of_states);
  }

  void search_locally_in_perturbed_graphs()
  {
    const std::vector<int>& terminals = m_instance.terminals();
    const double work = double(m_instance.graph().arcs.size()) * double(terminals.size());
    const int number_of_trials = int((std::min)(1000., double(m_maximum_number_of_states) / work));
    for(int i = 0; i < number_of_trials && m_go_further(); ++i) {
      const Csr_graph graph = perturbed(m_instance.graph(), i);
      const Key_points points(graph, terminals, ConcurrencyTag());
      improve(local_search(points, tolerance * m_best.length, ConcurrencyTag(), m_go_further));
    }
  }

  // with different roots, at least `minimum_number_of_rounds` times and then as long as a round leaves at most
  // `maximum_ratio` of the edges; false if no tree is shorter
  bool reduce_repeatedly(int minimum_number_of_rounds, double maximum_ratio)
  {
    for(int round = 0; m_go_further(); ++round) {
      const int size = m_instance.graph().number_of_edges();
      if(!reduce(++m_last_root))
        return false;
      if(round + 1 >= minimum_number_of_rounds && m_instance.graph().number_of_edges() > maximum_ratio * size)
        break;
    }
    return true;
  }

  // removes from the instance what no shorter tree can use; false if no tree is shorter
  bool reduce(int root)
  {
    const Csr_graph& graph = m_instance.graph();
    const std::vector<int>& terminals = m_instance.terminals();
    const Dual_ascent dual(graph, terminals, root % int(terminals.size()));
    const double fixed = fixed_length();
    if(fixed + dual.bound() > m_lower_bound) {
      m_lower_bound = fixed + dual.bound();
      m_best_root = root;
    }

    // trees along the arcs that the dual solution has used up are often short
    improve(shortest_path_heuristic(graph, terminals, terminals[dual.root()], [&](int i) {
      return dual.is_saturated(i) ? graph.arcs[i].weight : Shortest_paths::infinity();
    }));

    const std::vector<double> bounds = dual.bounds_with_edge();
    std::vector<char> is_removed(graph.number_of_edges());
    for(int e = 0; e < graph.number_of_edges(); ++e)
      is_removed[e] = fixed + bounds[e] > cut();
    if(m_lower_bound > cut() || !are_connected(graph, terminals, is_removed)) {
      m_is_optimal = true;
      return false;
    }
    m_instance = Degree_reduction(m_instance, is_removed).instance();
    if(m_instance.terminals().size() > 1)
      return true;
    improve(Tree{{}, 0.});
    m_is_optimal = true;
    return false;
  }

  // false if it was stopped
  bool search(std::size_t maximum_number_of_states)
  {
    const std::size_t k = m_instance.terminals().size();
    return k <= Terminal_set<1>::capacity   ? search_with_sets_of<1>(maximum_number_of_states)
           : k <= Terminal_set<4>::capacity ? search_with_sets_of<4>(maximum_number_of_states)
                                            : false;
  }

  template <int Words>
  bool search_with_sets_of(std::size_t maximum_number_of_states)
  {
    const Csr_graph& graph = m_instance.graph();
    const std::vector<int>& terminals = m_instance.terminals();
    const Dual_ascent dual(graph, terminals, m_best_root % int(terminals.size()));
    const Completion_bound<Words> bound(dual);
    Pruned_dynamic_programme<Words> programme(graph, terminals, bound, cut() - fixed_length(),
                                              maximum_number_of_states);
    m_is_optimal = programme.run(m_go_further);
    if(programme.has_found_tree())
      improve(programme.tree());
    return m_is_optimal;
  }

  static bool are_connected(const Csr_graph& graph, const std::vector<int>& terminals,
                            const std::vector<char>& is_removed)
  {
    Disjoint_sets components(graph.number_of_vertices());
    for(int e = 0; e < graph.number_of_edges(); ++e)
      if(!is_removed[e])
        components.unite(graph.edges[e].source, graph.edges[e].target);
    return std::all_of(terminals.begin(), terminals.end(), [&](int t) {
      return components.find(t) == components.find(terminals.front());
    });
  }

  // keeps a tree of the instance if it is the shortest so far
  void improve(const Tree& tree)
  {
    if(tree.length == Shortest_paths::infinity())
      return;
    const Tree better = make_tree_on_same_vertices(m_instance.graph(), m_instance.terminals(), tree);
    const Tree original = make_tree(m_graph, m_terminals, m_instance.original_edges(better.edges));
    if(original.length < m_best.length)
      m_best = original;
  }
};

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_EXACT_SOLVER_H
