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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_SHORT_LOOP_SEARCH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_SHORT_LOOP_SEARCH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/handles/Growing_opening.h>
#include <CGAL/Surface_mesh_cutting/internal/handles/Homology_class.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A cycle in the graph of an opened surface.
struct Short_loop
{
  double weight = std::numeric_limits<double>::infinity();
  std::vector<int> halfedges; // in order, none on the border
  Homology_class homology;
};

// Finds one short cycle after the other, each of which leaves the surface, opened along those before it, in one
// piece.
//
// The shortest such cycle through a root consists of two shortest paths from the root and an edge (Erickson and
// Har-Peled 2004). It lies within half its length from the root, so that only a ball around the root is searched. As
// every such cycle meets each cut graph or a border, the nodes of one cut graph and the border loops suffice as roots.
//
// For roots at distance d, the lengths of their shortest cycles differ by at most 2d: a search tells lower bounds
// for all nodes of its ball. Opening the surface shortens no cycle but those that touch the new border, which have a new
// root. So the bounds last, and roots wait in the order of theirs: most are searched once or never.
class Short_loop_search
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  // The loops found are at most 1 / (1 - tolerance) times as long as the shortest one that the former ones leave.
  // `weight(h)` is that of the edge of the halfedge `h`. `roots` are nodes, all border loops among them.
  Short_loop_search(Growing_opening& surface, std::function<double(int)> weight, const std::vector<int>& roots,
                    double tolerance)
    : m_surface(surface), m_weight(std::move(weight)), m_tolerance(tolerance)
  {
    resize();
    for(int root : roots)
      m_roots.emplace(0., root);
  }

  // There must be one.
  Short_loop find()
  {
    Short_loop best;
    while(!m_roots.empty() && m_roots.top().first < (1 - m_tolerance) * best.weight)
    {
      const auto [bound, root] = m_roots.top();
      m_roots.pop();
      if(m_surface.node(root) != root)
        continue; // on a border loop by now
      if(bound < m_bounds[root])
        m_roots.emplace(m_bounds[root], root);
      else if(search(root, (std::min)(reach * best.weight, first_limit(bound)), best))
        for(int h : best.halfedges)
          m_roots.emplace(m_bounds[m_surface.source(h)], m_surface.source(h));
    }
    return best;
  }

  // Goes on with the surface opened along the loop.
  void open(const Short_loop& loop)
  {
    m_span.add(loop.homology);
    m_length_of_former = loop.weight;
    const std::vector<int> nodes = m_surface.open(loop.halfedges);
    resize();
    for(int node : nodes)
    {
      m_bounds[node] = 0;
      m_roots.emplace(0., node);
    }
  }

private:
  // How far beyond the length of the present loop to search: larger lower bounds spare more roots than they cost.
  static constexpr double reach = 1.25;

  // The edge at which the two paths from a root meet.
  struct Closure
  {
    double weight;
    int halfedge;
  };

  // As long as no loop is known, searches grow with what is known to be in vain.
  double first_limit(double bound) const
  {
    constexpr double growth = 1.5;
    const double limit = growth * (std::max)(bound, m_length_of_former);
    return limit > 0 ? limit : infinity;
  }

  void resize()
  {
    const std::size_t size = m_surface.number_of_vertices();
    m_bounds.resize(size, 0.);
    m_distances.resize(size, infinity);
    m_last.resize(size, -1);
    m_positions.resize(size, -1);
    m_is_settled.resize(size, 0);
    m_classes.resize(size);
  }

  // Replaces `best` by a shorter loop through `root` of less than `limit` if there is one; the root waits with what
  // is known then.
  bool search(int root, double limit, Short_loop& best)
  {
    Closure closure{limit, -1};
    grow_ball(root, closure);
    for(int v : m_touched)
      if(m_is_settled[v])
        m_bounds[v] = (std::max)(m_bounds[v], closure.weight - 2 * m_distances[v]);
    m_roots.emplace(m_bounds[root], root);
    const bool is_shorter = closure.halfedge >= 0 && closure.weight < best.weight;
    if(is_shorter)
      best = extract(closure);
    for(int v : m_touched)
    {
      m_distances[v] = infinity;
      m_last[v] = m_positions[v] = -1;
      m_is_settled[v] = 0;
    }
    m_touched.clear();
    return is_shorter;
  }

  void grow_ball(int root, Closure& best)
  {
    CGAL::internal::Graph_kernel::Distance_heap heap(m_distances, m_positions);
    m_distances[root] = 0;
    m_touched.push_back(root);
    heap.push_or_update(root);
    while(!heap.empty())
    {
      const int v = heap.extract_top();
      if(2 * m_distances[v] >= best.weight)
        return;
      m_is_settled[v] = 1;
      const int last = m_last[v];
      m_classes[v] = last < 0 ? Homology_class() : m_classes[m_surface.source(last)] ^ m_surface.signature(last);
      m_surface.for_each_halfedge(v, [&](int h)
      {
        const int w = m_surface.target(h);
        const double distance = m_distances[v] + m_weight(h);
        if(m_is_settled[w])
          close(h, distance + m_distances[w], best);
        else if(distance < m_distances[w])
        {
          if(m_distances[w] == infinity)
            m_touched.push_back(w);
          m_distances[w] = distance;
          m_last[w] = h;
          heap.push_or_update(w);
        }
      });
    }
  }

  void close(int h, double weight, Closure& best) const
  {
    if(weight < best.weight && !m_span.contains(homology(h)))
      best = Closure{weight, h};
  }

  // Of the cycle that the edge closes.
  Homology_class homology(int h) const
  {
    return m_classes[m_surface.source(h)] ^ m_classes[m_surface.target(h)] ^ m_surface.signature(h);
  }

  // The cycle that the edge closes in the tree; what the paths to its two ends share is left out.
  Short_loop extract(const Closure& closure) const
  {
    std::vector<int> forth = path_to(m_surface.source(closure.halfedge)),
                     back = path_to(m_surface.target(closure.halfedge));
    Short_loop loop{closure.weight, {}, homology(closure.halfedge)};
    while(!forth.empty() && !back.empty() && forth.back() == back.back())
    {
      loop.weight -= 2 * m_weight(forth.back());
      forth.pop_back();
      back.pop_back();
    }
    loop.halfedges.assign(forth.rbegin(), forth.rend());
    loop.halfedges.push_back(closure.halfedge);
    for(int h : back)
      loop.halfedges.push_back(m_surface.chart().opposite(h));
    return loop;
  }

  // From its end.
  std::vector<int> path_to(int node) const
  {
    std::vector<int> path;
    for(; m_last[node] >= 0; node = m_surface.source(m_last[node]))
      path.push_back(m_last[node]);
    return path;
  }

  Growing_opening& m_surface;
  const std::function<double(int)> m_weight;
  const double m_tolerance;
  Homology_span m_span; // of the loops found
  double m_length_of_former = 0;
  // Nodes with lower bounds for the loops through them, some of them outdated.
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int> >, std::greater<> > m_roots;
  std::vector<double> m_bounds; // for the loops through a node, but not through a younger border loop
  // Of the ball of a search, per node:
  std::vector<double> m_distances;
  std::vector<int> m_last; // halfedges that lead there from the root
  std::vector<int> m_positions, m_touched;
  std::vector<char> m_is_settled;
  std::vector<Homology_class> m_classes; // of the paths from the root
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_SHORT_LOOP_SEARCH_H
