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

#include <CGAL/boost/graph/internal/Steiner_tree/Bounded_instance.h>
#include <CGAL/boost/graph/internal/Steiner_tree/local_search.h>
#include <CGAL/boost/graph/internal/Steiner_tree/metric_closure.h>

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <numeric>
#include <vector>

namespace CGAL::internal::Steiner_tree {

// for each edge: does it leave the `size` vertices nearest to these edges?
inline std::vector<char> is_outside_corridor(const Csr_graph& graph, const std::vector<int>& edges, int size)
{
  std::vector<char> is_inside(graph.number_of_vertices(), 0);
  Shortest_paths paths(graph);
  for(int e : edges) {
    paths.add_source(graph.edges[e].source);
    paths.add_source(graph.edges[e].target);
  }
  int number = 0;
  paths.run([&](int v) {
    is_inside[v] = 1;
    return ++number < size;
  });
  std::vector<char> is_outside(graph.number_of_edges());
  for(int e = 0; e < graph.number_of_edges(); ++e)
    is_outside[e] = !is_inside[graph.edges[e].source] || !is_inside[graph.edges[e].target];
  return is_outside;
}

// Reductions of edges go on while a round leaves at most this part of them.
constexpr double good_ratio = 0.7;

// the best tree without the edges removed that reductions and so many states of the program find
inline Tree improved_tree(const Csr_graph& graph, const std::vector<int>& terminals, const std::vector<char>& is_removed,
                          const Tree& tree, std::size_t maximum_number_of_states, Execution execution,
                          const Go_further& go_further)
{
  Bounded_instance instance(graph, terminals, is_removed, tree, execution, go_further);
  if(instance.reduce(1, good_ratio, go_further))
    instance.search(maximum_number_of_states, go_further);
  return instance.tree();
}

// The terminals first, then about as many vertices as wanted, evenly spread over the indices.
inline std::vector<int> with_spread_vertices(const Csr_graph& graph, const std::vector<int>& terminals, int number)
{
  std::vector<int> result(terminals);
  const std::vector<char> is_terminal = mark(graph.number_of_vertices(), terminals);
  for(int v = 0; v < graph.number_of_vertices(); v += (std::max)(1, graph.number_of_vertices() / number))
    if(!is_terminal[v])
      result.push_back(v);
  return result;
}

// the shortest tree of a coarser graph
inline std::vector<int> coarse_tree(const Csr_graph& graph, const std::vector<int>& terminals,
                                    std::size_t maximum_number_of_states, Execution execution,
                                    const Go_further& go_further)
{
  constexpr int number_of_centers = 3000;
  const Region_graph regions(graph, with_spread_vertices(graph, terminals, number_of_centers));
  std::vector<int> positions(terminals.size()); // the terminals are the first vertices
  std::iota(positions.begin(), positions.end(), 0);
  const Tree tree = improved_tree(regions.graph(), positions, std::vector<char>(regions.graph().number_of_edges(), 0),
                                  shortest_path_heuristic(regions.graph(), positions, go_further),
                                  maximum_number_of_states, execution, go_further);
  return regions.original_edges(tree.edges);
}

// A tree that is shortest among those near it, for graphs so large that searching the whole takes a good bound: the
// best tree in a corridor around the one given and one that is shortest in a coarser graph; then always the best in a
// corridor around the last one, as long as that pays.
inline Tree corridor_tree(const Csr_graph& graph, const std::vector<int>& terminals, Tree tree,
                          std::size_t maximum_number_of_states, Execution execution, const Go_further& go_further)
{
  constexpr int width = 12;           // vertices per edge of the tree
  constexpr double least_gain = 2e-3; // of the length, for one more corridor
  constexpr int maximum_number_of_corridors = 5;
  std::vector<int> middle = coarse_tree(graph, terminals, maximum_number_of_states, execution, go_further);
  middle.insert(middle.end(), tree.edges.begin(), tree.edges.end());
  for(int i = 0; i < maximum_number_of_corridors && go_further(); ++i) {
    const double former = tree.length;
    tree = improved_tree(graph, terminals, is_outside_corridor(graph, middle, width * int(middle.size())), tree,
                         maximum_number_of_states, execution, go_further);
    if(tree.length > (1. - least_gain) * former)
      break;
    middle = tree.edges;
  }
  return tree;
}

// Finds a shortest tree: heuristics and dual ascent from both sides, which remove what no shorter tree can use, and
// the pruned dynamic program on what is left. Without proof after `maximum_number_of_states`, the best tree found.
// All terminals must be in one component. Edges that connect them and are known to form a short tree take the place of
// the heuristics, and of most of their time.
class Exact_solver
{
  std::size_t m_maximum_number_of_states;
  Execution m_execution;
  const Go_further& m_go_further;
  Bounded_instance m_instance;
  unsigned int m_seed = 0;

public:
  Exact_solver(const Csr_graph& graph, const std::vector<int>& terminals, std::size_t maximum_number_of_states,
               Execution execution, const Go_further& go_further, const std::vector<int>& known = {})
    : m_maximum_number_of_states(maximum_number_of_states), m_execution(execution), m_go_further(go_further),
      m_instance(graph, terminals, execution)
  {
    if(!known.empty())
      m_instance.improve(make_tree(graph, terminals, known));
    else if(graph.number_of_vertices() > large_number_of_vertices)
      bound_from_both_sides(graph, terminals);
    else {
      m_instance.improve(shortest_path_heuristic(graph, terminals, go_further));
      if(!m_instance.reduce(1, 0., m_go_further) || !m_go_further())
        return;
      search_locally();
    }
    // The program with few states first. As often as these do not suffice, the same effort once more for the
    // bounds on both sides pays before it gets four times as many.
    if(!m_instance.reduce(1, good_ratio, m_go_further))
      return;
    const std::size_t first = (std::max)(minimum_number_of_states,
                                         minimum_number_of_states_per_edge * m_instance.graph().number_of_edges());
    std::size_t divisor = 1;
    while(m_maximum_number_of_states / divisor / 4 >= first)
      divisor *= 4;
    for(; m_go_further(); divisor /= 4) {
      const std::size_t states = m_maximum_number_of_states / divisor;
      if(m_instance.search(states, m_go_further))
        return;
      recombine(double(states));
      if(divisor == 1 || !m_instance.reduce(number_of_rounds(states), 0., m_go_further))
        return;
    }
  }

  const Tree& tree() const { return m_instance.tree(); }
  double lower_bound() const { return m_instance.lower_bound(); }
  bool is_optimal() const { return m_instance.is_optimal(); }

private:
  // of the first run of the program
  static constexpr std::size_t minimum_number_of_states = 500000, minimum_number_of_states_per_edge = 8;
  // Local search keeps distances to all vertices for each terminal; on large graphs it costs more than all the rest.
  static constexpr int large_number_of_vertices = 16384;
  static constexpr std::size_t corridor_divisor = 16; // corridors get this part of the states
  static constexpr double effort_per_part = 100; // of a recombination, for one union of trees

  // A round of reductions costs about as much as a state for each edge; at most four.
  int number_of_rounds(std::size_t states) const
  {
    const std::size_t size = std::size_t(m_instance.graph().number_of_edges());
    return states >= 4 * size ? 4 : (std::max)(1, int(states / size));
  }

  // a tree that is short, and a dual solution, which takes about as long and does not depend on the tree
  void bound_from_both_sides(const Csr_graph& graph, const std::vector<int>& terminals)
  {
    std::mutex mutex;
    const Go_further go_further = [&] {
      const std::lock_guard<std::mutex> lock(mutex);
      return m_go_further();
    };
    execute(m_execution, 2, [&](int i) {
      if(i == 1) {
        m_instance.ascend(go_further);
        return;
      }
      m_instance.improve(shortest_path_heuristic(graph, terminals, go_further));
      m_instance.improve(corridor_tree(graph, terminals, tree(), m_maximum_number_of_states / corridor_divisor,
                                       m_execution, go_further));
    });
  }

  double minimum_decrease() const { return Bounded_instance::tolerance * tree().length; }

  void search_locally()
  {
    const Csr_graph& graph = m_instance.graph();
    const double memory = double(graph.number_of_vertices()) * double(m_instance.terminals().size());
    if(memory > double(m_maximum_number_of_states))
      return;
    const Key_points points(graph, m_instance.terminals(), m_execution, m_go_further);
    if(points.is_complete())
      m_instance.improve(local_search(points, minimum_decrease(), m_go_further));
  }

  // Trees from perturbed weights, and each time the best tree in the union of one of them and the best so far: a graph so
  // small that the program mostly needs few states. As much effort as that many states of the program.
  void recombine(double effort)
  {
    const Csr_graph& graph = m_instance.graph();
    const std::vector<int>& terminals = m_instance.terminals();
    const double work = double(graph.arcs.size()) * double(terminals.size()); // of a trial
    Tree best;
    for(double spent = work; spent <= effort && m_go_further(); spent += work) {
      const Csr_graph other = perturbed(graph, m_seed++);
      const Key_points points(other, terminals, m_execution, m_go_further);
      if(!points.is_complete())
        break;
      Tree tree = make_tree(graph, terminals, local_search(points, minimum_decrease(), m_go_further).edges);
      tree = make_tree_on_same_vertices(graph, terminals, tree);
      std::vector<char> is_unused(graph.number_of_edges(), 1);
      for(const std::vector<int>* edges : {&tree.edges, &best.edges})
        for(int e : *edges)
          is_unused[e] = 0;
      best = improved_tree(graph, terminals, is_unused, tree.length < best.length ? tree : best,
                           std::size_t(effort / effort_per_part), m_execution, m_go_further);
    }
    m_instance.improve(best);
  }
};

} // namespace CGAL::internal::Steiner_tree

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_EXACT_SOLVER_H
