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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_BOUNDED_INSTANCE_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_BOUNDED_INSTANCE_H

#include <CGAL/boost/graph/internal/Steiner_tree/Dual_ascent.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Instance.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Pruned_dynamic_program.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Tree.h>
#include <CGAL/boost/graph/internal/Steiner_tree/metric_closure.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::internal::Steiner_tree {

// of the dynamic program
constexpr int largest_number_of_terminals = Terminal_set<4>::capacity;

// A Steiner tree problem, the best tree known, a lower bound, and an instance in which all shorter trees are left.
// All terminals must be in one component.
class Bounded_instance
{
  const Csr_graph* m_graph;
  const std::vector<int>* m_terminals;
  Execution m_execution;
  bool m_has_integral_weights;
  Instance m_instance;
  Tree m_best;
  double m_lower_bound = 0.;
  bool m_is_optimal = false;
  int m_last_root = -1, m_best_root = 0;
  std::unique_ptr<const Dual_ascent> m_dual; // the last one, if it is one of the present instance
  bool m_is_dual_new = false;                // no reduction has used it
  Tree m_dual_tree;

public:
  // A tree is optimal if none is shorter by more than this part of its length; larger than rounding errors.
  static constexpr double tolerance = 1e-10;

  Bounded_instance(const Csr_graph& graph, const std::vector<int>& terminals, Execution execution)
    : m_graph(&graph)
    , m_terminals(&terminals)
    , m_execution(execution)
    , m_has_integral_weights(std::all_of(graph.edges.begin(), graph.edges.end(),
                                         [](const Edge& e) { return e.weight == std::floor(e.weight); }))
    , m_instance(graph, terminals)
  {}

  // the part of the graph without the edges removed, which must hold the tree
  Bounded_instance(const Csr_graph& graph, const std::vector<int>& terminals, const std::vector<char>& is_removed,
                   const Tree& tree, Execution execution, const Go_further& go_further)
    : Bounded_instance(graph, terminals, execution)
  {
    m_best = tree;
    remove(is_removed, go_further);
  }

  const Csr_graph& graph() const { return m_instance.graph(); }
  const std::vector<int>& terminals() const { return m_instance.terminals(); }

  // the best tree, in the original graph
  const Tree& tree() const { return m_best; }
  double lower_bound() const { return m_is_optimal ? m_best.length : m_lower_bound; }
  bool is_optimal() const { return m_is_optimal; }

  // keeps a tree of the instance if it is the shortest so far
  void improve(const Tree& tree)
  {
    if(tree.length == Shortest_paths::infinity())
      return;
    const Tree better = make_tree_on_same_vertices(graph(), terminals(), tree);
    const Tree original = make_tree(*m_graph, *m_terminals, m_instance.original_edges(better.edges));
    if(original.length < m_best.length)
      m_best = original;
  }

  // Finds the dual solution that the next reduction uses. It depends on no tree: trees may be found by `improve()` at
  // the same time.
  void ascend(const Go_further& go_further)
  {
    const int root = ++m_last_root % int(terminals().size());
    // trees along the arcs that the dual solution has used up are often short
    const auto grow = [&](const Dual_ascent& dual) {
      m_dual_tree = grow_tree(graph(), terminals(), terminals()[root], [&](int i) {
        return dual.is_saturated(i) ? graph().arcs[i].weight : Shortest_paths::infinity();
      }, go_further);
    };
    m_dual.reset(new Dual_ascent(graph(), terminals(), root, m_execution, go_further, grow));
    m_is_dual_new = true;
  }

  // Removes what no shorter tree can use, by dual ascent with different roots: at least `minimum_number_of_rounds`
  // times and then as long as a round leaves at most `maximum_ratio` of the edges. False if no tree is shorter.
  bool reduce(int minimum_number_of_rounds, double maximum_ratio, const Go_further& go_further)
  {
    for(int round = 0; !m_is_optimal && (m_is_dual_new || go_further()); ++round) {
      const int size = graph().number_of_edges();
      if(!m_is_dual_new)
        ascend(go_further);
      reduce_by_dual(go_further);
      if(round + 1 >= minimum_number_of_rounds && graph().number_of_edges() > maximum_ratio * size)
        break;
    }
    return !m_is_optimal;
  }

  // the pruned dynamic program; false if it was stopped
  bool search(std::size_t maximum_number_of_states, const Go_further& go_further)
  {
    const std::size_t k = terminals().size();
    return k <= Terminal_set<1>::capacity   ? search_with_sets_of<1>(maximum_number_of_states, go_further)
           : k <= Terminal_set<4>::capacity ? search_with_sets_of<4>(maximum_number_of_states, go_further)
                                            : false;
  }

private:
  // what a tree has to fall short of
  double cut() const
  {
    return m_has_integral_weights ? m_best.length - 0.5 : m_best.length * (1. - tolerance);
  }

  // the length of the shortest tree of the instance is this much less than that of the original problem
  double fixed_length() const { return total_weight(*m_graph, m_instance.original_edges({})); }

  void reduce_by_dual(const Go_further& go_further)
  {
    const Dual_ascent& dual = *m_dual;
    m_is_dual_new = false;
    const double fixed = fixed_length();
    if(fixed + dual.bound() > m_lower_bound) {
      m_lower_bound = fixed + dual.bound();
      m_best_root = m_last_root;
    }
    improve(m_dual_tree);

    const std::vector<double> bounds = dual.bounds_with_edge();
    std::vector<char> is_removed(graph().number_of_edges());
    for(int e = 0; e < graph().number_of_edges(); ++e)
      is_removed[e] = fixed + bounds[e] > cut();
    const auto is_left = [&](int e) { return !is_removed[e]; };
    if(m_lower_bound > cut() || !are_connected(graph(), terminals(), is_left))
      m_is_optimal = true;
    else if(is_worthwhile(is_removed))
      remove(is_removed, go_further);
  }

  // Graphs are not made anew for a few edges; then the dual solution serves the search, too.
  bool is_worthwhile(const std::vector<char>& is_removed) const
  {
    constexpr int large_size = 50000; // edges
    constexpr double worthwhile_share = 0.2, worthwhile_share_of_small = 0.02;
    const double size = graph().number_of_edges();
    return double(std::count(is_removed.begin(), is_removed.end(), char(1))) >=
           (size < large_size ? worthwhile_share_of_small : worthwhile_share) * size;
  }

  void remove(const std::vector<char>& is_removed, const Go_further& go_further)
  {
    m_instance = Degree_reduction(m_instance, is_removed, go_further).instance();
    m_dual.reset();
    if(terminals().size() > 1)
      return;
    improve(Tree{{}, 0.});
    m_is_optimal = true;
  }

  template <int Words>
  bool search_with_sets_of(std::size_t maximum_number_of_states, const Go_further& go_further)
  {
    if(!m_dual)
      m_dual.reset(new Dual_ascent(graph(), terminals(), m_best_root % int(terminals().size()), m_execution,
                                   go_further, [](const Dual_ascent&) {}));
    const Completion_bound<Words> bound(*m_dual);
    Pruned_dynamic_program<Words> program(graph(), terminals(), bound, cut() - fixed_length(),
                                              maximum_number_of_states);
    m_is_optimal = program.run(m_execution, go_further);
    if(program.has_found_tree())
      improve(program.tree());
    return m_is_optimal;
  }
};

} // namespace CGAL::internal::Steiner_tree

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_BOUNDED_INSTANCE_H
