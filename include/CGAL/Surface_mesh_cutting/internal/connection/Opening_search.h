// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_OPENING_SEARCH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_OPENING_SEARCH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/connection/Key_paths.h>
#include <CGAL/Surface_mesh_cutting/internal/connection/Cheapest_opening.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Execution.h>
#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using CGAL::internal::Graph_kernel::Go_further;
using CGAL::internal::Graph_kernel::Shortest_paths;

// Makes a cut to one disk cheaper, loops and tree alike, a path here for a path there: proposes paths all over the
// surface and takes of these and of the cut what `Cheapest_opening` leaves.
class Opening_search
{
public:
  // The cut leaves one disk and passes through all vertices with `is_kept`. The references are kept.
  Opening_search(const Indexed_mesh& mesh, const Edge_constraints& constraints, std::vector<char> is_kept, Cut cut)
    : m_mesh(mesh), m_constraints(constraints), m_is_kept(std::move(is_kept)), m_cut(std::move(cut)),
      m_cost(cut_cost(constraints, m_cut)), m_paths(mesh.graph())
  {}

  const Cut& cut() const { return m_cut; }

  // O(n log n) for each round
  void run(const Go_further& go_further)
  {
    constexpr int maximum_number_of_rounds = 30; // most end before
    constexpr double worthwhile = 1e-4;          // of the cost, for another round
    for(int i = 0; i < maximum_number_of_rounds && go_further(); ++i)
    {
      const double former = m_cost;
      while(go_further() && take(with_chords()))
        continue;
      take(with_stars(i));
      if(m_cost > (1 - worthwhile) * former && i % 2 == 1)
        return;
    }
  }

private:
  bool take(const Cut& graph)
  {
    const Cut cut = make_cut(m_mesh, Cheapest_opening(m_mesh, m_constraints, graph, m_is_kept).edges());
    const double cost = cut_cost(m_constraints, cut);
    constexpr double rounding = 1e-9;
    if(!(cost < (1 - rounding) * m_cost) || !leaves_disk(m_mesh, cut))
      return false;
    m_cut = cut;
    m_cost = cost;
    return true;
  }

  // The cut with the cheapest paths across the disk, from each path on its border to each other one nearby.
  Cut with_chords()
  {
    const Corner_table chart = make_chart(m_mesh, m_cut);
    const Indexed_mesh disk(chart_points(m_mesh, chart), chart.triangles(), chart.opposites());
    const auto edge = [&](int e) { return m_mesh.edge(disk.halfedge(e)); };
    const std::vector<int> sides = sides_of_paths(chart);
    Shortest_paths paths(disk.graph());
    for(int v = 0; v < disk.number_of_vertices(); ++v)
      if(sides[v] >= 0)
        paths.add_source(v);
    std::vector<int> nearest = sides;
    paths.run([&](int v)
              {
                if(paths.last_edge(v) >= 0)
                  nearest[v] = nearest[paths.predecessor(v)];
                return true;
              },
              [&](int a) { return m_constraints.weights[edge(disk.graph().arcs[a].edge)]; });

    std::map<std::pair<int, int>, std::pair<double, int> > chords; // between two sides: cost and edge in the middle
    for(int e = 0; e < disk.number_of_edges(); ++e)
    {
      const int s = disk.source(disk.halfedge(e)), t = disk.target(disk.halfedge(e));
      if(disk.is_border_edge(e) || nearest[s] == nearest[t])
        continue;
      const double cost = paths.distance(s) + m_constraints.weights[edge(e)] + paths.distance(t);
      if(cost == std::numeric_limits<double>::infinity())
        continue;
      const auto chord = chords.try_emplace(std::minmax(nearest[s], nearest[t]), cost, e).first;
      chord->second = (std::min)(chord->second, std::make_pair(cost, e));
    }
    Cut graph = m_cut;
    for(const auto& [between, chord] : chords)
    {
      std::vector<int> edges(1, chord.second);
      for(int v : {disk.source(disk.halfedge(chord.second)), disk.target(disk.halfedge(chord.second))})
        paths.path(v, std::back_inserter(edges));
      for(int e : edges)
        graph[edge(e)] = 1;
    }
    return graph;
  }

  // For each vertex on the border of the disk, which side of which path it lies on; -1 inside. Where paths meet, it
  // is that of the next one.
  std::vector<int> sides_of_paths(const Corner_table& chart) const
  {
    const Key_paths key(m_mesh, m_cut, m_is_kept);
    std::vector<int> sides(chart.number_of_vertices(), -1);
    int side = -1;
    for(const std::vector<int>& loop : chart.border_loops())
      for(int h : loop)
      {
        if(h == loop.front() || key.is_key(m_mesh.source(h)))
          ++side;
        sides[chart.source(h)] = side;
      }
    return sides;
  }

  // The cut with other paths from forks of it to where their paths lead, through vertices from which those are
  // nearer together; forks of one of `round` classes next to none of the same.
  Cut with_stars(int round)
  {
    const Key_paths key(m_mesh, m_cut, m_is_kept);
    std::vector<std::vector<int> > paths_at(m_mesh.number_of_vertices());
    for(int i = 0; i < int(key.paths().size()); ++i)
      for(int v : {key.paths()[i].source, key.paths()[i].target})
        paths_at[v].push_back(i);
    std::vector<char> is_taken(m_mesh.number_of_vertices(), 0);
    Cut graph = m_cut;
    const std::vector<char> is_on_cut = open_vertices(m_mesh, m_cut);
    for(int i = 0; i < m_mesh.number_of_vertices(); ++i)
    {
      const int fork = round % 2 == 0 ? i : m_mesh.number_of_vertices() - 1 - i;
      if(paths_at[fork].size() < 3 || is_taken[fork])
        continue;
      is_taken[fork] = 1;
      for(int p : paths_at[fork])
        is_taken[key.paths()[p].source] = is_taken[key.paths()[p].target] = 1;
      add_star(fork, key, paths_at[fork], is_on_cut, graph);
    }
    return graph;
  }

  void add_star(int fork, const Key_paths& key, const std::vector<int>& legs, const std::vector<char>& is_on_cut,
                Cut& graph)
  {
    double cost = 0;
    std::vector<int> ends;
    std::map<int, char> is_passable; // on the cut
    is_passable[fork] = 1;
    for(int p : legs)
    {
      const Key_paths::Path& path = key.paths()[p];
      if(path.source == path.target)
        return;
      ends.push_back(path.source == fork ? path.target : path.source);
      cost += total_cost(m_constraints, path.edges);
      for(int e : path.edges)
        for(int v : {m_mesh.source(m_mesh.halfedge(e)), m_mesh.target(m_mesh.halfedge(e))})
          if(!key.is_key(v))
            is_passable[v] = 1;
    }
    std::map<int, std::pair<int, double> > sums; // of the distances, and how many
    std::vector<std::vector<int> > last_edges;
    const auto& arcs = m_mesh.graph().arcs;
    const auto search = [&](int end, const std::function<bool(int)>& settle)
    {
      m_paths.clear();
      m_paths.add_source(end);
      m_paths.run(settle, [&](int a)
                  {
                    const int v = arcs[a].target;
                    return is_on_cut[v] && is_passable.count(v) == 0 ? std::numeric_limits<double>::infinity()
                                                                     : m_constraints.weights[arcs[a].edge];
                  });
    };
    for(int end : ends)
      search(end, [&](int v)
             {
               if(m_paths.distance(v) > cost)
                 return false;
               auto& sum = sums[v];
               ++sum.first;
               sum.second += m_paths.distance(v);
               return true;
             });
    int best = -1;
    for(const auto& [v, sum] : sums)
      if(sum.first == int(ends.size()) && sum.second < cost)
      {
        best = v;
        cost = sum.second;
      }
    if(best < 0)
      return;
    for(int end : ends)
    {
      search(end, [&](int v) { return v != best; });
      std::vector<int> edges;
      m_paths.path(best, std::back_inserter(edges));
      for(int e : edges)
        graph[e] = 1;
    }
  }

  const Indexed_mesh& m_mesh;
  const Edge_constraints& m_constraints;
  const std::vector<char> m_is_kept;
  Cut m_cut;
  double m_cost;
  Shortest_paths m_paths;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_OPENING_SEARCH_H
