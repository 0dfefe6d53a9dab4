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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_DUAL_ASCENT_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_DUAL_ASCENT_H

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Tree.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::internal::Steiner_tree {

// A feasible dual solution of the directed cut formulation (Wong 1984). Every Steiner tree, directed away from a
// root terminal, enters each set W of vertices that holds a terminal but not the root. The sets get values y_W >= 0
// such that the sets an arc enters sum up to at most its weight. Then the sum of all values is a lower bound, and the
// reduced weights (what is left of the arcs' weights) tell which arcs a tree shorter than a given one can use.
// Sets are grouped by the terminals they hold: that is all the solvers ask for.
class Dual_ascent
{
public:
  struct Group
  {
    std::vector<int> terminals; // positions, increasing
    double value;               // sum over its sets
  };

  // the sum over those sets of a group that contain a certain vertex
  struct Share
  {
    int group;
    double value;
  };

private:
  // The sets of a group are nested, so the share of a vertex is what the group gains from when it entered; that is
  // recorded once, and interiors need no update while their sets grow.
  class Recorded_shares
  {
    struct Entry
    {
      int vertex;
      int group;
      double value; // of the group when the vertex entered
      int next;     // of the same vertex
    };

    std::vector<int> m_last; // entry of each vertex
    std::vector<Entry> m_entries;

  public:
    explicit Recorded_shares(int number_of_vertices) : m_last(number_of_vertices, -1) {}

    // keeps the first one for each vertex and group
    void add(int v, int group, double value)
    {
      for(int i = m_last[v]; i >= 0; i = m_entries[i].next)
        if(m_entries[i].group == group)
          return;
      m_entries.push_back(Entry{v, group, value, m_last[v]});
      m_last[v] = int(m_entries.size()) - 1;
    }

    Buckets<Share> of_vertices(const std::vector<Group>& groups) const
    {
      return {int(m_last.size()), [&](const auto& visit) {
        for(const Entry& e : m_entries)
          visit(e.vertex, Share{e.group, groups[e.group].value - e.value});
      }};
    }
  };

  const Csr_graph* m_graph;
  std::vector<int> m_terminals;
  int m_root; // position among the terminals
  double m_bound = 0.;
  std::vector<double> m_entering; // for arc i in the row of v: reduced weight of the arc that enters v along its edge
  std::vector<int> m_opposite;
  std::vector<Group> m_groups;
  Buckets<Share> m_shares; // of the vertices
  std::vector<double> m_from_root, m_to_terminal;

public:
  // raises the sets around the terminals, the smallest first, until all are reached from the root along arcs of
  // reduced weight zero. All terminals must be in one component. Stopped earlier, it is a solution, too.
  // `use(*this)` is called with the reduced weights while the distances are still searched.
  template <typename Use>
  Dual_ascent(const Csr_graph& graph, const std::vector<int>& terminals, int root,
              Execution execution, const Go_further& go_further, const Use& use)
    : m_graph(&graph), m_terminals(terminals), m_root(root), m_opposite(graph.opposite_arcs())
  {
    m_entering.reserve(graph.arcs.size());
    for(const Csr_graph::Arc& arc : graph.arcs)
      m_entering.push_back(arc.weight);
    ascend(go_further);
    execute(execution, 3, [this, &use](int i) {
      if(i == 0)
        use(*this);
      else if(i == 1)
        search_from_root();
      else
        search_to_terminals();
    });
  }

  int root() const { return m_root; }
  double bound() const { return m_bound; }
  const std::vector<Group>& groups() const { return m_groups; }
  Iterator_range<const Share*> shares(int v) const { return m_shares[v]; }

  // reduced weight of the arc that enters (leaves) v along the i-th arc, which is in the row of v
  double entering_weight(int i) const { return m_entering[i]; }
  double leaving_weight(int i) const { return m_entering[m_opposite[i]]; }
  bool is_saturated(int i) const { return entering_weight(i) == 0. || leaving_weight(i) == 0.; }

  // distances by reduced weights from the root, and to the nearest terminal other than the root
  double distance_from_root(int v) const { return m_from_root[v]; }
  double distance_to_terminal(int v) const { return m_to_terminal[v]; }

  // for each edge a lower bound on the length of the trees that use it, in either direction
  std::vector<double> bounds_with_edge() const
  {
    std::vector<double> result(m_graph->number_of_edges(), Shortest_paths::infinity());
    for(int v = 0; v < m_graph->number_of_vertices(); ++v)
      for(int i = m_graph->offsets[v]; i < m_graph->offsets[v + 1]; ++i) {
        const Csr_graph::Arc& arc = m_graph->arcs[i];
        result[arc.edge] = (std::min)(result[arc.edge],
                                      m_bound + m_from_root[arc.target] + m_entering[i] + m_to_terminal[v]);
      }
    return result;
  }

private:
  void search_from_root()
  {
    Shortest_paths paths(*m_graph);
    paths.add_source(m_terminals[m_root]);
    paths.run([](int) { return true; }, [this](int i) { return leaving_weight(i); });
    m_from_root = paths.distances();
  }

  void search_to_terminals()
  {
    Shortest_paths paths(*m_graph);
    for(int i = 0; i < int(m_terminals.size()); ++i)
      if(i != m_root)
        paths.add_source(m_terminals[i]);
    paths.run([](int) { return true; }, [this](int i) { return entering_weight(i); });
    m_to_terminal = paths.distances();
  }

  // The terminal that each terminal's sets have met. Sets of a terminal that was reached from another one by arcs of
  // reduced weight zero stop growing: the other's sets will contain them. Terminals that reach each other grow as one.
  struct Leaders
  {
    std::vector<int> leader;
    int find(int i)
    {
      while(leader[i] != i)
        i = leader[i] = leader[leader[i]];
      return i;
    }
  };

  // A set that grows: what arcs of reduced weight zero join to its terminal already, and what a search reaches next.
  struct Growth
  {
    Shortest_paths paths;
    Index_set inside;         // in the order of the search
    std::vector<int> reached; // outside, in the order of their distances
    std::vector<int> members; // positions of the terminals

    explicit Growth(const Csr_graph& graph) : paths(graph), inside(graph.number_of_vertices()) {}

    double distance(int v) const { return inside.contains(v) ? 0. : paths.distance(v); }
    int size() const { return int(inside.indices().size() + reached.size()); }

    void clear()
    {
      inside.clear();
      reached.clear();
      members.clear();
      paths.clear();
    }
  };

  void ascend(const Go_further& go_further)
  {
    const int k = int(m_terminals.size());
    std::vector<int> position(m_graph->number_of_vertices(), -1);
    Leaders leaders;
    std::set<std::pair<int, int>> active; // size of the set, position of the terminal
    for(int i = 0; i < k; ++i) {
      position[m_terminals[i]] = i;
      leaders.leader.push_back(i);
      if(i != m_root)
        active.insert(std::make_pair(1, i));
    }
    Growth growth(*m_graph);
    Recorded_shares recorded(m_graph->number_of_vertices());
    std::map<std::vector<int>, int> group_index;
    while(!active.empty() && go_further()) {
      const int size = active.begin()->first, grown = active.begin()->second;
      active.erase(active.begin());
      // growing beyond the size of the next set by a factor keeps the total cost in proportion to the final sizes
      const double limit = active.empty() ? double(m_graph->number_of_vertices())
                                          : 2. * (std::max)(size, active.begin()->first);
      growth.clear();
      growth.inside.insert(m_terminals[grown]);
      int met = collect_inside(growth, position, leaders, grown);
      if(met == grown) {
        double radius = 0.;
        met = grow(growth, position, leaders, grown, limit, radius);
        std::sort(growth.members.begin(), growth.members.end());
        const auto found = group_index.insert(std::make_pair(growth.members, int(m_groups.size())));
        if(found.second)
          m_groups.push_back(Group{growth.members, 0.});
        raise(growth, radius, found.first->second, recorded);
      }
      if(met != grown)
        leaders.leader[grown] = met;
      else
        active.insert(std::make_pair(growth.size(), grown));
    }
    m_shares = recorded.of_vertices(m_groups);
  }

  // the vertices that reach the terminal by arcs of reduced weight zero; ends early at a terminal of another leader,
  // which it returns, else `grown`
  int collect_inside(Growth& growth, const std::vector<int>& position, Leaders& leaders, int grown) const
  {
    for(std::size_t next = 0; next < growth.inside.indices().size(); ++next) {
      const int v = growth.inside.indices()[next], p = position[v];
      if(p >= 0) {
        if(leaders.find(p) != grown)
          return leaders.find(p);
        growth.members.push_back(p);
      }
      for(int i = m_graph->offsets[v]; i < m_graph->offsets[v + 1]; ++i)
        if(m_entering[i] == 0.)
          growth.inside.insert(m_graph->arcs[i].target);
    }
    return grown;
  }

  // Growing a set continuously is a search by reduced weights towards the terminal: up to the next terminal, whose
  // leader it returns, or as far as `limit` vertices. `radius` is how far it came.
  int grow(Growth& growth, const std::vector<int>& position, Leaders& leaders, int grown, double limit,
           double& radius) const
  {
    for(int v : growth.inside.indices())
      for(int i = m_graph->offsets[v]; i < m_graph->offsets[v + 1]; ++i)
        if(!growth.inside.contains(m_graph->arcs[i].target))
          growth.paths.add_source(m_graph->arcs[i].target, m_entering[i]);
    int met = grown;
    growth.paths.run([&](int v) {
      if(growth.inside.contains(v))
        return true;
      radius = growth.paths.distance(v);
      if(position[v] >= 0)
        met = leaders.find(position[v]);
      if(position[v] >= 0 || double(growth.size()) >= limit)
        return false;
      growth.reached.push_back(v);
      return true;
    }, [this](int i) { return m_entering[i]; });
    return met;
  }

  // gives the sets {v : distance(v) < x}, 0 < x < radius, their values
  void raise(const Growth& growth, double radius, int group, Recorded_shares& recorded)
  {
    const double former = m_groups[group].value;
    m_bound += radius;
    m_groups[group].value += radius;
    const auto lower_entering_weights = [&](int v) {
      const double distance = growth.distance(v);
      for(int i = m_graph->offsets[v]; i < m_graph->offsets[v + 1]; ++i) {
        const Csr_graph::Arc& arc = m_graph->arcs[i];
        const double decrease = (std::min)(radius, growth.distance(arc.target)) - distance;
        if(decrease > 0.) {
          m_entering[i] -= decrease;
          if(m_entering[i] < 1e-13 * arc.weight) // rounding
            m_entering[i] = 0.;
        }
      }
    };
    for(int v : growth.inside.indices()) {
      recorded.add(v, group, former);
      lower_entering_weights(v);
    }
    for(int v : growth.reached)
      if(growth.distance(v) < radius) {
        recorded.add(v, group, former + growth.distance(v));
        lower_entering_weights(v);
      }
  }
};

} // namespace CGAL::internal::Steiner_tree

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_DUAL_ASCENT_H
