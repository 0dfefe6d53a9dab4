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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_PRUNED_DYNAMIC_PROGRAM_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_PRUNED_DYNAMIC_PROGRAM_H

#include <CGAL/boost/graph/internal/Steiner_tree/Set_search.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Tree.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::internal::Steiner_tree {

// The program of Erickson, Monma and Veinott (1987) on states (v, I): a vertex, a set of terminals, and the length
// d(v, I) of the shortest tree found that connects them. States are made by sending one along an edge and by merging
// two at the same vertex whose sets are disjoint. It looks for a tree of length at most `cut` and keeps only states
// that such an optimal tree T can be made of:
//
//  1. T has a vertex all of whose branches hold at most half of the k terminals. The branches there can be joined
//     into at most three parts with at most k/2 terminals each. So no larger set is sent, and T is found as three
//     states (or two with exactly half of the terminals) at one vertex.
//  2. d(v, I) + (lower bound for connecting v and the other terminals) <= cut (Completion_bound).
//  3. The separators of Iwata and Shigemura (PACE 2018): let a be the largest number such that the other terminals
//     are connected among the vertices u with d(u, I) >= a. Then every tree that connects them has a vertex u with
//     d(u, I) <= a, where the part for I could be attached. So in T it is attached at such a distance, and
//     d(v, I) > a cannot occur. The argument needs only that d(u, I) is the length of some tree, so tentative
//     values of vertices that rule 2 has excluded may serve.
//
// All states of T itself survive, in the order of the number of terminals, with their exact values: by induction,
// its parts did.
template <int Words>
class Pruned_dynamic_program
{
  using Set = Terminal_set<Words>;
  using State = Tree_states::State;
  using Merge = Tree_states::Merge;
  using Target = Tree_states::Target;
  using Search = Set_search<Words>;
  using Searches = std::vector<std::unique_ptr<Search>>; // made when they are needed
  static constexpr int from_terminal = Tree_states::from_terminal;
  static constexpr int number_of_searches = 4;   // at once; each keeps some arrays of the size of the graph
  static constexpr std::size_t batch_size = 16; // sets between two merges: work for all searches, little of it lost

  // looking at so many labels counts as a state, so that the number of states bounds the time, too
  static constexpr std::size_t labels_per_state = 512;

  struct Table
  {
    Set set;
    double base;                // of the completion bound
    std::vector<State> initial; // terminal or merges
    std::vector<State> states;  // what is left in the end, by vertex
  };

  // what is known at a vertex
  struct Label
  {
    Set set;
    int table;
    int size; // of the set
    double length;
  };

  const Csr_graph& m_graph;
  const std::vector<int>& m_terminals;
  const Completion_bound<Words>& m_bound;
  const Set m_all;
  double m_cut;
  std::size_t m_remaining_states;
  bool m_is_complete = true;

  std::vector<Table> m_tables;
  std::unordered_map<Set, int, typename Set::Hash> m_table_of_set;
  std::vector<std::vector<int>> m_tables_by_size;
  std::vector<Merge> m_merges;
  std::vector<std::vector<Label>> m_labels;
  std::vector<Target> m_targets; // by the other table
  std::vector<int> m_tables_merged_with;

  int m_best_vertex = -1; // the best complete tree: tables with a state at this vertex
  std::vector<int> m_best_tables;

public:
  Pruned_dynamic_program(const Csr_graph& graph, const std::vector<int>& terminals,
                           const Completion_bound<Words>& bound, double cut, std::size_t maximum_number_of_states)
    : m_graph(graph), m_terminals(terminals), m_bound(bound), m_all(Set::all(int(terminals.size()))), m_cut(cut),
      m_remaining_states(maximum_number_of_states), m_tables_by_size(terminals.size() + 1),
      m_labels(graph.number_of_vertices())
  {}

  // False if it was stopped by the budget or by `go_further`. Sets of one size do not depend on each other: a batch of
  // them is sent at once, by so many searches as are given, and then merged one after the other.
  bool run(Execution execution, const Go_further& go_further)
  {
    for(int i = 0; i < int(m_terminals.size()); ++i) {
      Set single;
      single.insert(i);
      m_tables[table_of(single)].initial.push_back(State{m_terminals[i], from_terminal, 0.});
    }
    Searches searches(execution == Execution::PARALLEL ? number_of_searches : 1);
    for(std::size_t size = 1; size <= m_terminals.size() / 2; ++size) {
      const std::vector<int> tables = m_tables_by_size[size]; // merging makes only larger sets
      for(std::size_t first = 0; first < tables.size(); first += batch_size) {
        const std::size_t last = (std::min)(first + batch_size, tables.size());
        send(execution, std::vector<int>(tables.begin() + first, tables.begin() + last), searches);
        for(std::size_t i = first; i < last; ++i) {
          count_states(m_tables[tables[i]].states.size());
          if(!m_is_complete || !go_further())
            return false;
          merge(tables[i], go_further);
          complete(tables[i]);
        }
      }
    }
    return m_is_complete;
  }

  bool has_found_tree() const { return m_best_vertex >= 0; }

  Tree tree() const
  {
    std::vector<int> edges;
    for(int table : m_best_tables)
      trace(table, m_best_vertex, edges);
    return make_tree(m_graph, m_terminals, edges);
  }

private:
  int table_of(const Set& set)
  {
    const auto found = m_table_of_set.insert(std::make_pair(set, int(m_tables.size())));
    if(found.second) {
      m_tables.push_back(Table{set, m_bound.base(m_all.without(set)), {}, {}});
      m_tables_by_size[set.size()].push_back(found.first->second);
    }
    return found.first->second;
  }

  void count_states(std::size_t number)
  {
    if(m_remaining_states < number)
      m_is_complete = false;
    else
      m_remaining_states -= number;
  }

  void send(Execution execution, const std::vector<int>& batch, Searches& searches)
  {
    execute(execution, int(searches.size()), [&](int s) {
      for(std::size_t i = s; i < batch.size(); i += searches.size()) {
        if(!searches[s])
          searches[s].reset(new Search(m_graph, m_terminals, m_bound));
        Table& table = m_tables[batch[i]];
        table.states = (*searches[s])(m_all.without(table.set), table.base, m_cut, table.initial);
        std::vector<State>().swap(table.initial);
      }
    });
  }

  // merges the states of a table with those of the earlier tables at the same vertices. The larger part of rule 1
  // may come last, so a union of more than k/2 terminals, which is only completed, must leave a part of at least the
  // size of the present one. Labels are in the order of their sizes.
  void merge(int index, const Go_further& go_further)
  {
    const Set set = m_tables[index].set;
    const int maximum_size = int(m_terminals.size()) - 2 * set.size();
    m_targets.resize(m_tables.size());
    Patience patience(go_further);
    for(std::size_t s = 0; m_is_complete && s < m_tables[index].states.size(); ++s) {
      m_is_complete = patience.lasts();
      const State state = m_tables[index].states[s];
      for(const Label& label : m_labels[state.vertex]) {
        if(label.size > maximum_size)
          break;
        const double length = state.length + label.length;
        if(length > m_cut || set.intersects(label.set))
          continue;
        const Target& target = target_of(index, label);
        Table& united = m_tables[target.table];
        if(length + m_bound(state.vertex, m_all.without(united.set), united.base) > m_cut)
          continue;
        united.initial.push_back(State{state.vertex, -2 - target.merge, length});
        count_states(1);
      }
      count_states(m_labels[state.vertex].size() / labels_per_state);
      m_labels[state.vertex].push_back(Label{set, index, set.size(), state.length});
    }
    for(int table : m_tables_merged_with)
      m_targets[table] = Target();
    m_tables_merged_with.clear();
  }

  const Target& target_of(int index, const Label& label)
  {
    Target& target = m_targets[label.table];
    if(target.table < 0) {
      target.table = table_of(m_tables[index].set.united(label.set));
      target.merge = int(m_merges.size());
      m_merges.push_back(Merge{index, label.table});
      m_tables_merged_with.push_back(label.table);
    }
    return target;
  }

  // rule 1: two halves, or three parts, the last of which is `index`
  void complete(int index)
  {
    const auto found = m_table_of_set.find(m_all.without(m_tables[index].set));
    if(found == m_table_of_set.end())
      return;
    const std::vector<State>& states = m_tables[index].states;
    const auto for_each_match = [&](const std::vector<State>& others, const auto& join) {
      for(const State& other : others)
        if(const State* state = Tree_states::find(states, other.vertex))
          join(state->length + other.length, other);
    };
    for_each_match(m_tables[found->second].states, [&](double length, const State& other) {
      improve(length, other.vertex, {index, found->second});
    });
    for_each_match(m_tables[found->second].initial, [&](double length, const State& other) {
      if(other.origin == from_terminal)
        return;
      const Merge merge = m_merges[-2 - other.origin];
      improve(length, other.vertex, {index, merge.first, merge.second});
    });
  }

  void improve(double length, int v, std::vector<int> tables)
  {
    if(length > m_cut || (m_best_vertex >= 0 && length == m_cut))
      return;
    m_cut = length;
    m_best_vertex = v;
    m_best_tables = std::move(tables);
  }

  // appends the edges of the tree of a state
  void trace(int index, int v, std::vector<int>& edges) const
  {
    std::vector<std::pair<int, int>> stack(1, std::make_pair(index, v));
    while(!stack.empty()) {
      const std::pair<int, int> top = stack.back();
      stack.pop_back();
      const State* state = Tree_states::find(m_tables[top.first].states, top.second);
      if(state->origin >= 0) {
        edges.push_back(state->origin);
        stack.push_back(std::make_pair(top.first, m_graph.opposite(state->origin, top.second)));
      }
      else if(state->origin != from_terminal) {
        const Merge merge = m_merges[-2 - state->origin];
        stack.push_back(std::make_pair(merge.first, top.second));
        stack.push_back(std::make_pair(merge.second, top.second));
      }
    }
  }
};

} // namespace CGAL::internal::Steiner_tree

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_PRUNED_DYNAMIC_PROGRAM_H
