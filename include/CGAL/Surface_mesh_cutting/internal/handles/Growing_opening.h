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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_GROWING_OPENING_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_GROWING_OPENING_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/handles/Homology_class.h>
#include <CGAL/Surface_mesh_cutting/internal/handles/Tree_cotree.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A surface that is opened loop by loop, as a graph in which each border loop is one node: moving along
// what is open already costs nothing. The graph is that of `Contracted_surface`; it follows each opening in
// time proportional to the border loops that change.
//
// A path that enters a border loop at one vertex and leaves it at another runs along it in between. What that
// contributes to the class of a cycle is the sum of two potentials; which way round does not matter, as the
// border loops are sums of the loops that were opened.
class Growing_opening
{
public:
  // The classes are those that `tree_cotree` gives to the edges of the chart as it is now.
  Growing_opening(Corner_table& chart, const Tree_cotree& tree_cotree)
    : m_chart(chart), m_tree_cotree(tree_cotree), m_loop_of(chart.number_of_vertices(), -1),
      m_nodes(chart.number_of_vertices(), -1), m_corners(chart.number_of_vertices(), -1),
      m_potentials(chart.number_of_vertices())
  {
    for(int h = 0; h < int(chart.opposites().size()); ++h)
      m_corners[chart.source(h)] = h;
    for(int v = 0; v < number_of_vertices(); ++v)
      m_nodes[v] = v;
    for(std::vector<int>& loop : chart.border_loops())
      add_border_loop(std::move(loop));
  }

  const Corner_table& chart() const { return m_chart; }
  int number_of_vertices() const { return m_chart.number_of_vertices(); }

  // A node is one of its vertices.
  int node(int v) const { return m_nodes[v]; }
  int source(int h) const { return m_nodes[m_chart.source(h)]; }
  int target(int h) const { return m_nodes[m_chart.target(h)]; }

  // Calls `visit(h)` for each halfedge off the border that leaves the node.
  template <typename Visit>
  void for_each_halfedge(int node, const Visit& visit) const
  {
    if(m_loop_of[node] < 0)
    {
      int h = m_corners[node];
      do
      {
        visit(h);
        h = m_chart.next_around_source(h);
      }
      while(h != m_corners[node]);
      return;
    }
    for(int b : m_loops[m_loop_of[node]])
      for(int h = m_chart.next_around_source(b); h >= 0; h = m_chart.next_around_source(h))
        visit(h);
  }

  // What moving along a halfedge off the border, from node to node, contributes to the class of a cycle.
  Homology_class signature(int h) const
  {
    Homology_class result = m_tree_cotree.signature(h);
    for(int v : {m_chart.source(h), m_chart.target(h)})
      if(m_loop_of[v] >= 0)
        result ^= m_potentials[v];
    return result;
  }

  // Opens the edges of a cycle, none of them on the border, and returns the nodes that it makes.
  std::vector<int> open(const std::vector<int>& cycle)
  {
    for(int h : cycle)
      for(int v : {m_chart.source(h), m_chart.target(h)})
        if(m_loop_of[v] >= 0)
          remove_border_loop(m_loop_of[v]);
    std::vector<int> border;
    for(int h : cycle)
      border.insert(border.end(), {h, m_chart.opposite(h)});
    m_chart.open(cycle);
    m_loop_of.resize(number_of_vertices(), -1);
    m_nodes.resize(number_of_vertices(), -1);
    m_corners.resize(number_of_vertices(), -1);
    m_potentials.resize(number_of_vertices());
    std::vector<int> nodes;
    for(int h : border)
    {
      if(m_loop_of[m_chart.source(h)] >= 0)
        continue;
      std::vector<int> loop(1, h);
      for(int b = m_chart.next_on_border(h); b != h; b = m_chart.next_on_border(b))
        loop.push_back(b);
      add_border_loop(std::move(loop));
      nodes.push_back(source(h));
    }
    return nodes;
  }

  // The border loop of a node, from the vertex `from` to the vertex `to` the shorter way round; pairs of a halfedge
  // and whether it is passed along its direction. `length(h)` is that of an edge.
  template <typename Length>
  std::vector<std::pair<int, bool> > along_border(int from, int to, const Length& length) const
  {
    std::vector<std::pair<int, bool> > walk;
    if(from == to)
      return walk;
    std::vector<int> loop = m_loops[m_loop_of[from]];
    const auto halfedge_from = [&](int v)
    { return std::find_if(loop.begin(), loop.end(), [&](int h) { return m_chart.source(h) == v; }); };
    std::rotate(loop.begin(), halfedge_from(from), loop.end());
    const auto middle = halfedge_from(to);
    const auto sum = [&](auto begin, auto end)
    {
      double result = 0;
      for(; begin != end; ++begin)
        result += length(*begin);
      return result;
    };
    if(sum(loop.begin(), middle) <= sum(middle, loop.end()))
      for(auto it = loop.begin(); it != middle; ++it)
        walk.emplace_back(*it, true);
    else
      for(auto it = loop.end(); it != middle; --it)
        walk.emplace_back(*std::prev(it), false);
    return walk;
  }

private:
  void add_border_loop(std::vector<int> loop)
  {
    Homology_class potential;
    for(int h : loop)
    {
      const int v = m_chart.source(h);
      m_loop_of[v] = int(m_loops.size());
      m_nodes[v] = m_chart.source(loop.front());
      m_potentials[v] = potential;
      potential ^= m_tree_cotree.signature(h);
    }
    m_loops.push_back(std::move(loop));
  }

  void remove_border_loop(int i)
  {
    for(int h : m_loops[i])
      m_loop_of[m_chart.source(h)] = -1;
    m_loops[i].clear();
  }

  Corner_table& m_chart;
  const Tree_cotree& m_tree_cotree;
  std::vector<std::vector<int> > m_loops;   // of border halfedges in order; empty if no longer there
  std::vector<int> m_loop_of;               // per chart vertex; -1: inside
  std::vector<int> m_nodes;                 // per chart vertex
  std::vector<int> m_corners;               // per chart vertex inside, a halfedge that leaves it
  std::vector<Homology_class> m_potentials; // per chart vertex on the border, of the way from its node
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_GROWING_OPENING_H
