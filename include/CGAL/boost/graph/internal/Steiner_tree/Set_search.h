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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_SET_SEARCH_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_SET_SEARCH_H

#include <CGAL/boost/graph/internal/Steiner_tree/Dual_ascent.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Separator.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Tree.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::internal::Steiner_tree {

// A set of terminals, given by their positions 0..64*Words-1.
template <int Words>
class Terminal_set
{
  std::array<std::uint64_t, Words> m_words{};

public:
  static constexpr int capacity = 64 * Words;

  static Terminal_set all(int size)
  {
    Terminal_set result;
    for(int i = 0; i < size; ++i)
      result.insert(i);
    return result;
  }

  void insert(int i) { m_words[i / 64] |= std::uint64_t(1) << (i % 64); }
  bool contains(int i) const { return (m_words[i / 64] >> (i % 64)) & 1; }

  bool intersects(const Terminal_set& other) const
  {
    std::uint64_t common = 0;
    for(int w = 0; w < Words; ++w)
      common |= m_words[w] & other.m_words[w];
    return common != 0;
  }

  Terminal_set united(const Terminal_set& other) const
  {
    Terminal_set result;
    for(int w = 0; w < Words; ++w)
      result.m_words[w] = m_words[w] | other.m_words[w];
    return result;
  }

  Terminal_set without(const Terminal_set& other) const
  {
    Terminal_set result;
    for(int w = 0; w < Words; ++w)
      result.m_words[w] = m_words[w] & ~other.m_words[w];
    return result;
  }

  int size() const
  {
    int result = 0;
    for(std::uint64_t word : m_words)
      for(; word != 0; word &= word - 1)
        ++result;
    return result;
  }

  friend bool operator==(const Terminal_set& a, const Terminal_set& b) { return a.m_words == b.m_words; }
  friend bool operator<(const Terminal_set& a, const Terminal_set& b) { return a.m_words < b.m_words; }

  struct Hash
  {
    std::size_t operator()(const Terminal_set& set) const
    {
      std::uint64_t h = 0;
      for(std::uint64_t word : set.m_words)
        h = (h ^ word) * 0x9E3779B97F4A7C15ull + (h >> 29);
      return std::size_t(h ^ (h >> 32));
    }
  };
};

// Lower bounds for what a subtree at a vertex v that connects the terminals of a set I still needs: a tree that
// connects v and the other terminals R (the future costs of Hougardy, Silvanus and Vygen 2017), from a dual solution.
// Let r be its root.
//  - If r is in R, the rest is a tree directed away from r that enters all sets of the dual solution that hold v or a
//    terminal of R, and its path to v costs at least the distance by reduced weights on top.
//  - If r is in I, the rest is directed away from v and enters all sets that hold a terminal of R but not v.
template <int Words>
class Completion_bound
{
  using Set = Terminal_set<Words>;

  const Dual_ascent* m_dual;
  std::vector<Set> m_groups;

public:
  explicit Completion_bound(const Dual_ascent& dual) : m_dual(&dual)
  {
    for(const Dual_ascent::Group& group : dual.groups()) {
      m_groups.emplace_back();
      for(int t : group.terminals)
        m_groups.back().insert(t);
    }
  }

  // the value of all sets that hold a terminal of R
  double base(const Set& rest) const
  {
    double sum = 0.;
    for(std::size_t g = 0; g < m_groups.size(); ++g)
      if(m_groups[g].intersects(rest))
        sum += m_dual->groups()[g].value;
    return sum;
  }

  double operator()(int v, const Set& rest, double base_of_rest) const
  {
    const bool holds_root = rest.contains(m_dual->root());
    double sum = base_of_rest + (holds_root ? m_dual->distance_from_root(v) : m_dual->distance_to_terminal(v));
    for(const Dual_ascent::Share& share : m_dual->shares(v))
      if(m_groups[share.group].intersects(rest) != holds_root)
        sum += holds_root ? share.value : -share.value;
    return sum;
  }
};

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

// Sends the states of one set of terminals along the edges: Dijkstra's algorithm, pruned by rules 2 and 3 of
// `Pruned_dynamic_program`. Only allocations persist between calls.
template <int Words>
class Set_search
{
  using Set = Terminal_set<Words>;
  using State = Tree_states::State;

  const Csr_graph& m_graph;
  const std::vector<int>& m_terminals;
  const Completion_bound<Words>& m_bound;
  std::vector<double> m_lengths, m_completions;
  std::vector<int> m_origins, m_touched, m_positions;
  std::vector<char> m_is_other_terminal;
  Separator m_separator;

public:
  // The references are kept.
  Set_search(const Csr_graph& graph, const std::vector<int>& terminals, const Completion_bound<Words>& bound)
    : m_graph(graph), m_terminals(terminals), m_bound(bound), m_lengths(graph.number_of_vertices(), infinity()),
      m_completions(graph.number_of_vertices()), m_origins(graph.number_of_vertices()),
      m_positions(graph.number_of_vertices(), -1), m_is_other_terminal(graph.number_of_vertices(), 0),
      m_separator(graph)
  {}

  // The states that the initial ones lead to, by vertex. `rest`: the terminals outside the set, `base`: their part of
  // the completion bound.
  std::vector<State> operator()(const Set& rest, double base, double cut, const std::vector<State>& initial)
  {
    std::vector<int> others;
    for(int i = 0; i < int(m_terminals.size()); ++i)
      if(rest.contains(i))
        others.push_back(m_terminals[i]);
    for(int t : others)
      m_is_other_terminal[t] = 1;
    std::vector<State> states;
    double limit = search(rest, base, cut, initial, states);
    if(!states.empty()) {
      limit = (std::min)(limit, m_separator(m_lengths, m_touched, others));
      while(!states.empty() && states.back().length > limit)
        states.pop_back();
    }
    for(int v : m_touched) {
      m_lengths[v] = infinity();
      m_positions[v] = -1;
    }
    m_touched.clear();
    for(int t : others)
      m_is_other_terminal[t] = 0;
    Tree_states::sort_by_vertex(states);
    return states;
  }

private:
  static double infinity() { return (std::numeric_limits<double>::infinity)(); }

  // appends states by increasing length; returns the limit of rule 3 as a single other terminal sees it
  double search(const Set& rest, double base, double cut, const std::vector<State>& initial, std::vector<State>& states)
  {
    Distance_heap heap(m_lengths, m_positions);
    double limit = infinity();
    const auto relax = [&](int v, double length, int origin) {
      if(!(length < m_lengths[v]))
        return;
      if(m_lengths[v] == infinity()) {
        m_touched.push_back(v);
        m_completions[v] = m_bound(v, rest, base);
      }
      m_lengths[v] = length;
      m_origins[v] = origin;
      if(m_is_other_terminal[v])
        limit = (std::min)(limit, length);
      if(length + m_completions[v] <= cut)
        heap.push_or_update(v);
    };
    for(const State& s : initial)
      relax(s.vertex, s.length, s.origin);
    while(!heap.empty()) {
      const double length = m_lengths[heap.top()];
      if(length > limit)
        break;
      const int v = heap.extract_top();
      states.push_back(State{v, m_origins[v], length});
      if(m_is_other_terminal[v])
        continue;
      for(int i = m_graph.offsets[v]; i < m_graph.offsets[v + 1]; ++i)
        relax(m_graph.arcs[i].target, length + m_graph.arcs[i].weight, m_graph.arcs[i].edge);
    }
    return limit;
  }
};

} // namespace CGAL::internal::Steiner_tree

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_SET_SEARCH_H
