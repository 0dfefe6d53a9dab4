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

#include <CGAL/boost/graph/internal/Graph_kernel/Go_further.h>
#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

using Graph_kernel::Csr_graph;
using Graph_kernel::Go_further;
using Graph_kernel::Shortest_paths;

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
  const Csr_graph* m_graph;
  std::vector<int> m_terminals;
  int m_root; // position among the terminals
  double m_bound = 0.;
  std::vector<double> m_entering; // for arc i in the row of v: reduced weight of the arc that enters v along its edge
  std::vector<int> m_opposite;
  std::vector<Group> m_groups;
  std::vector<std::vector<Share>> m_shares;

public:
  // raises the sets around the terminals, the smallest first, until all are reached from the root along arcs of
  // reduced weight zero. All terminals must be in one component. Stopped earlier, it is a solution, too.
  Dual_ascent(const Csr_graph& graph, const std::vector<int>& terminals, int root,
              const Go_further& go_further)
    : m_graph(&graph)
    , m_terminals(terminals)
    , m_root(root)
    , m_opposite(graph.opposite_arcs())
    , m_shares(graph.number_of_vertices())
  {
    m_entering.reserve(graph.arcs.size());
    for(const Csr_graph::Arc& arc : graph.arcs)
      m_entering.push_back(arc.weight);
    ascend(go_further);
  }

  int root() const { return m_root; }
  double bound() const { return m_bound; }
  const std::vector<Group>& groups() const { return m_groups; }
  const std::vector<Share>& shares(int v) const { return m_shares[v]; }

  // reduced weight of the arc that enters (leaves) v along the i-th arc, which is in the row of v
  double entering_weight(int i) const { return m_entering[i]; }
  double leaving_weight(int i) const { return m_entering[m_opposite[i]]; }
  bool is_saturated(int i) const { return entering_weight(i) == 0. || leaving_weight(i) == 0.; }

  // distances by reduced weights from the root
  std::vector<double> distances_from_root() const
  {
    Shortest_paths paths(*m_graph);
    paths.add_source(m_terminals[m_root]);
    paths.run([](int) { return true; }, [this](int i) { return leaving_weight(i); });
    return paths.distances();
  }

  // distances by reduced weights to the nearest terminal other than the root
  std::vector<double> distances_to_terminal() const
  {
    Shortest_paths paths(*m_graph);
    for(int i = 0; i < int(m_terminals.size()); ++i)
      if(i != m_root)
        paths.add_source(m_terminals[i]);
    paths.run([](int) { return true; }, [this](int i) { return entering_weight(i); });
    return paths.distances();
  }

  // for each edge a lower bound on the length of the trees that use it, in either direction
  std::vector<double> bounds_with_edge() const
  {
    const std::vector<double> from_root = distances_from_root(), to_terminal = distances_to_terminal();
    std::vector<double> result(m_graph->number_of_edges(), Shortest_paths::infinity());
    for(int v = 0; v < m_graph->number_of_vertices(); ++v)
      for(int i = m_graph->offsets[v]; i < m_graph->offsets[v + 1]; ++i) {
        const Csr_graph::Arc& arc = m_graph->arcs[i];
        result[arc.edge] = (std::min)(result[arc.edge],
                                      m_bound + from_root[arc.target] + m_entering[i] + to_terminal[v]);
      }
    return result;
  }

private:
  // What the terminals' sets have met. The sets of a terminal that was reached from another one by arcs of reduced
  // weight zero stop growing: the other's sets will contain them. Terminals that reach each other grow as one.
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
    Shortest_paths paths(*m_graph);
    std::map<std::vector<int>, int> group_index;
    std::vector<int> settled, members;
    while(!active.empty() && go_further()) {
      const int size = active.begin()->first, grown = active.begin()->second;
      active.erase(active.begin());
      // growing beyond the size of the next set by a factor keeps the total cost in proportion to the final sizes
      const double limit = active.empty() ? double(m_graph->number_of_vertices())
                                          : 2. * (std::max)(size, active.begin()->first);

      // growing a set continuously is a search by reduced weights towards the terminal
      int met = grown;
      double radius = 0.;
      paths.clear();
      paths.add_source(m_terminals[grown]);
      settled.clear();
      members.clear();
      paths.run([&](int v) {
        radius = paths.distance(v);
        const int p = position[v];
        if(p >= 0) {
          met = leaders.find(p);
          if(met != grown || radius > 0.)
            return false;
          members.push_back(p);
        }
        if(radius > 0. && double(settled.size()) >= limit)
          return false;
        settled.push_back(v);
        return true;
      }, [this](int i) { return m_entering[i]; });

      if(radius > 0.) {
        std::sort(members.begin(), members.end());
        const auto found = group_index.insert(std::make_pair(members, int(m_groups.size())));
        if(found.second)
          m_groups.push_back(Group{members, 0.});
        raise(paths, settled, radius, found.first->second);
      }
      if(met != grown)
        leaders.leader[grown] = met;
      else
        active.insert(std::make_pair(int(settled.size()), grown));
    }
  }

  // gives the sets {v : distance(v) < x}, 0 < x < radius, their values
  void raise(const Shortest_paths& paths, const std::vector<int>& settled, double radius, int group)
  {
    m_bound += radius;
    m_groups[group].value += radius;
    for(int v : settled) {
      const double distance = paths.distance(v);
      if(!(distance < radius))
        continue;
      std::vector<Share>& shares = m_shares[v];
      auto share = std::find_if(shares.begin(), shares.end(), [&](const Share& s) { return s.group == group; });
      if(share == shares.end())
        share = shares.insert(shares.end(), Share{group, 0.});
      share->value += radius - distance;
      for(int i = m_graph->offsets[v]; i < m_graph->offsets[v + 1]; ++i) {
        const Csr_graph::Arc& arc = m_graph->arcs[i];
        const double decrease = (std::min)(radius, paths.distance(arc.target)) - distance;
        if(decrease > 0.) {
          m_entering[i] -= decrease;
          if(m_entering[i] < 1e-13 * arc.weight) // rounding
            m_entering[i] = 0.;
        }
      }
    }
  }
};

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_DUAL_ASCENT_H
