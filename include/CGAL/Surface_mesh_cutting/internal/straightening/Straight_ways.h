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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_STRAIGHTENING_STRAIGHT_WAYS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_STRAIGHTENING_STRAIGHT_WAYS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/connection/Key_paths.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/connection/turnings_along.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Turning.h>

#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Finds ways near to those of a cut that turn less and hardly cost more. A search over pairs of consecutive edges minimizes the
// sum of cost and turning.
class Straight_ways
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  // The references are kept.
  Straight_ways(const Indexed_mesh& mesh, const Edge_constraints& constraints)
    : m_mesh(mesh), m_constraints(constraints), m_turning(mesh), m_corridor(mesh.number_of_vertices()),
      m_costs(mesh.number_of_halfedges(), infinity), m_last(mesh.number_of_halfedges(), -1)
  {}

  // A way with the same ends, off the vertices that are blocked, of at most this cost; empty if none turns less.
  std::vector<int> straighter(const Key_paths::Path& path, const std::vector<char>& is_blocked, double largest_cost)
  {
    constexpr double prices[] = {8, 4, 2, 1, 0.5, 0.25, 0.125}; // of a radian, in edges of average cost
    if(path.source == path.target || path.edges.size() < 3)
      return {};
    const double cost = total_cost(m_constraints, path.edges), turned = total_turning(path);
    find_corridor(path, is_blocked);
    std::vector<int> best;
    for(const double price : prices)
    {
      Key_paths::Path other{path.source, path.target, cheapest(path, price * cost / double(path.edges.size()))};
      constexpr double rounding = 1e-9;
      if(other.edges.empty() || total_cost(m_constraints, other.edges) > largest_cost)
        continue;
      if(total_turning(other) < (1 - rounding) * turned)
        best = std::move(other.edges);
      break;
    }
    m_corridor.clear();
    return best;
  }

private:
  double total_turning(const Key_paths::Path& path) const
  {
    double sum = 0;
    for(const double t : turnings_along(m_mesh, m_turning, path))
      sum += std::abs(t);
    return sum;
  }

  // The vertices around a path.
  void find_corridor(const Key_paths::Path& path, const std::vector<char>& is_blocked)
  {
    constexpr int rings = 4;
    int v = path.source;
    m_corridor.insert(v);
    for(const int e : path.edges)
      m_corridor.insert(v = m_mesh.graph().opposite(e, v));
    std::size_t begin = 0;
    for(int ring = 0; ring < rings; ++ring)
    {
      const std::size_t end = m_corridor.indices().size();
      for(; begin < end; ++begin)
      {
        const int u = m_corridor.indices()[begin];
        for(int a = m_mesh.graph().offsets[u]; a < m_mesh.graph().offsets[u + 1]; ++a)
          if(!is_blocked[m_mesh.graph().arcs[a].target])
            m_corridor.insert(m_mesh.graph().arcs[a].target);
      }
    }
  }

  // The way of least cost where a radian of turning has a price; states are halfedges, with the cost of the way up to their ends.
  std::vector<int> cheapest(const Key_paths::Path& path, double price)
  {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry> > queue;
    const auto relax = [&](int h, double cost, int last)
    {
      if(!(cost < m_costs[h]))
        return;
      if(m_costs[h] == infinity)
        m_touched.push_back(h);
      m_costs[h] = cost;
      m_last[h] = last;
      queue.emplace(cost, h);
    };
    for_each_edge_from(path.source, [&](int h) { relax(h, weight(h), -1); });
    int end = -1;
    while(!queue.empty() && end < 0)
    {
      const double cost = queue.top().first;
      const int h = queue.top().second;
      queue.pop();
      if(cost > m_costs[h])
        continue;
      if(const int v = m_mesh.target(h); v == path.target)
        end = h;
      else
        for_each_edge_from(v, [&](int g)
        {
          if(g != m_mesh.opposite(h) && m_mesh.target(g) != path.source)
            relax(g, cost + weight(g) + price * std::abs(m_turning(h, g)), h);
        });
    }
    std::vector<int> edges;
    for(int h = end; h >= 0; h = m_last[h])
      edges.push_back(m_mesh.edge(h));
    std::reverse(edges.begin(), edges.end());
    for(const int h : m_touched)
    {
      m_costs[h] = infinity;
      m_last[h] = -1;
    }
    m_touched.clear();
    return is_simple(path.source, edges) ? edges : std::vector<int>();
  }

  double weight(int h) const { return m_constraints.weights[m_mesh.edge(h)]; }

  // Calls `visit(h)` for the halfedges that lead from a vertex into the corridor along edges that may be cut.
  template <typename Visit>
  void for_each_edge_from(int v, const Visit& visit) const
  {
    const Csr_graph& graph = m_mesh.graph();
    for(int a = graph.offsets[v]; a < graph.offsets[v + 1]; ++a)
      if(const int e = graph.arcs[a].edge;
         m_corridor.contains(graph.arcs[a].target) && !m_mesh.is_border_edge(e) && !m_constraints.is_forbidden(e))
        visit(m_turning.halfedge_from(e, v));
  }

  // A way that turns at a price may come by a vertex twice.
  bool is_simple(int v, const std::vector<int>& edges) const
  {
    std::vector<int> vertices(1, v);
    for(const int e : edges)
      vertices.push_back(v = m_mesh.graph().opposite(e, v));
    std::sort(vertices.begin(), vertices.end());
    return std::adjacent_find(vertices.begin(), vertices.end()) == vertices.end();
  }

  const Indexed_mesh& m_mesh;
  const Edge_constraints& m_constraints;
  const Turning m_turning;
  CGAL::internal::Graph_kernel::Index_set m_corridor; // vertices
  std::vector<double> m_costs; // per halfedge
  std::vector<int> m_last;     // the halfedge before it
  std::vector<int> m_touched;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_STRAIGHTENING_STRAIGHT_WAYS_H
