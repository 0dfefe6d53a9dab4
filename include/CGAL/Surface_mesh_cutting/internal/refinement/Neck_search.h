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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_NECK_SEARCH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_NECK_SEARCH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/refinement/Chart_border.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_component.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>
#include <CGAL/boost/graph/internal/Graph_kernel/sort_by_key.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A path through a disk that cuts off a flap: what the border encloses from `from` to `to`.
struct Neck
{
  int from = -1, to = -1; // border vertices: the sources of these halfedges of the border
  double cost = 0;
  int number_of_separated = 0; // pairs of border halfedges that cross, one of them at the flap
  std::vector<int> edges;
};

// Finds cheap necks that separate parts of a disk which overlap each other: shortest paths from vertices spread over the
// border, each to where it separates most pairs for its cost.
class Neck_search
{
  using Shortest_paths = CGAL::internal::Graph_kernel::Shortest_paths;

  static constexpr double reach = 1. / 16; // of the cost of the border

public:
  // `cut` leaves the disk; `crossings`: pairs of halfedges of its border. The references are kept.
  Neck_search(const Problem& problem, const Cut& cut, const Chart_border& border,
              const std::vector<std::pair<int, int> >& crossings)
    : m_problem(problem), m_border(border), m_disk(std::move(split_along(problem.mesh, cut).front())),
      m_numbers(m_disk.mesh.number_of_vertices(), -1), m_partners(border.size()), m_paths(m_disk.mesh.graph()),
      m_largest_cost(reach * border.cost())
  {
    std::vector<int> places(problem.mesh.number_of_faces());
    for(int f = 0; f < int(m_disk.faces.size()); ++f)
      places[m_disk.faces[f]] = f;
    for(int i = 0; i < border.size(); ++i)
    {
      const int h = border.halfedges[i];
      m_vertices.push_back(m_disk.mesh.source(3 * places[h / 3] + h % 3));
      m_numbers[m_vertices.back()] = i;
    }
    for(const auto& [g, h] : crossings)
    {
      m_partners[border.numbers[g]].push_back(border.numbers[h]);
      m_partners[border.numbers[h]].push_back(border.numbers[g]);
    }
  }

  // The best first. O(k n log n) for k starts at worst; the paths that are looked at are short.
  std::vector<Neck> operator()()
  {
    constexpr int largest_number_of_starts = 100;
    constexpr int enough_vertices = 2000000; // so many can be reached from all starts
    const int number_of_starts
      = (std::max)(1, (std::min)(largest_number_of_starts, enough_vertices / m_disk.mesh.number_of_vertices()));
    std::vector<Neck> necks;
    for(int from = 0; from < m_border.size(); from += 1 + (m_border.size() - 1) / number_of_starts)
      add_necks(from, necks);
    CGAL::internal::Graph_kernel::sort_by_key(necks, [](const Neck& neck) { return -separated_per_cost(neck); });
    return necks;
  }

private:
  // Infinite for a neck along edges that cost nothing.
  static double separated_per_cost(const Neck& neck) { return neck.number_of_separated / neck.cost; }

  void add_necks(int from, std::vector<Neck>& necks)
  {
    constexpr std::size_t number_of_necks = 3; // from each start
    const std::vector<int> separated = separated_pairs(from);
    find_paths(from);
    std::vector<Neck> found;
    for(int to = 0; to < m_border.size(); ++to)
      if(separated[to] > 0 && m_costs[to] < Shortest_paths::infinity())
        found.push_back({from, to, m_costs[to], separated[to], {}});
    CGAL::internal::Graph_kernel::sort_by_key(found, [](const Neck& neck) { return -separated_per_cost(neck); });
    found.resize((std::min)(found.size(), number_of_necks));
    for(Neck& neck : found)
    {
      neck.edges = path_to(neck.to);
      necks.push_back(std::move(neck));
    }
  }

  // For each end of a flap that begins at `from`, the pairs of which one is at the flap.
  std::vector<int> separated_pairs(int from) const
  {
    std::vector<int> result(m_border.size(), 0);
    std::vector<char> is_at_flap(m_border.size(), 0);
    int number = 0;
    for(int i = from, k = 1; k < m_border.size(); ++k)
    {
      for(int j : m_partners[i])
        number += is_at_flap[j] ? -1 : 1;
      is_at_flap[i] = 1;
      i = m_border.next(i);
      result[i] = number;
    }
    return result;
  }

  // Through the interior, to all border vertices within reach.
  void find_paths(int from)
  {
    const auto& graph = m_disk.mesh.graph();
    m_costs.assign(m_border.size(), Shortest_paths::infinity());
    m_last_edges.assign(m_border.size(), -1);
    m_paths.clear();
    m_paths.add_source(m_vertices[from]);
    m_paths.run([&](int v)
                {
                  if(m_paths.distance(v) > m_largest_cost)
                    return false;
                  for(int a = graph.offsets[v]; a < graph.offsets[v + 1]; ++a)
                    end_path(v, graph.arcs[a].target, graph.arcs[a].edge);
                  return true;
                },
                [&](int a)
                {
                  const auto& arc = graph.arcs[a];
                  return m_numbers[arc.target] >= 0 ? Shortest_paths::infinity() : cost(arc.edge);
                });
  }

  double cost(int disk_edge) const { return m_problem.constraints.weights[m_disk.edges[disk_edge]]; }

  void end_path(int v, int border_vertex, int edge)
  {
    const int to = m_numbers[border_vertex];
    if(to < 0 || m_disk.mesh.is_border_edge(edge))
      return;
    const double total = m_paths.distance(v) + cost(edge);
    if(total <= m_largest_cost && total < m_costs[to])
    {
      m_costs[to] = total;
      m_last_edges[to] = edge;
    }
  }

  // Edges of the whole.
  std::vector<int> path_to(int to) const
  {
    std::vector<int> edges(1, m_last_edges[to]);
    m_paths.path(m_disk.mesh.graph().opposite(m_last_edges[to], m_vertices[to]), std::back_inserter(edges));
    for(int& e : edges)
      e = m_disk.edges[e];
    return edges;
  }

  const Problem& m_problem;
  const Chart_border& m_border;
  const Indexed_component m_disk;
  std::vector<int> m_vertices, m_numbers;   // border vertices in the disk, and which these are
  std::vector<std::vector<int> > m_partners; // of each halfedge of the border, those that it crosses
  Shortest_paths m_paths;
  const double m_largest_cost;
  std::vector<double> m_costs;   // of paths to border vertices
  std::vector<int> m_last_edges; // of these
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_NECK_SEARCH_H
