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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_HANDLE_LOOPS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_HANDLE_LOOPS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Topology.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Contracted_surface.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_component.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>
#include <CGAL/Surface_mesh_cutting/internal/handles/Shortest_loop.h>
#include <CGAL/Surface_mesh_cutting/internal/handles/Tree_cotree.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Go_further.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using CGAL::internal::Graph_kernel::Go_further;
using CGAL::internal::Graph_kernel::always_go_further;

// A halfedge of an indexed mesh, passed along its direction or against it.
struct Directed_edge
{
  int halfedge;
  bool is_forward;
};

// Loops along which a surface loses its handles, and the cut that consists of them and of what was
// mandatory. A loop may run along edges that are open already, in particular along the border.
struct Handle_loops
{
  Indexed_status status;
  std::vector<std::vector<Directed_edge> > loops;
  Cut cut;
};

// Completes a cycle of the contracted surface to a closed walk: where it enters a border loop at
// one vertex and leaves it at another one, it follows the border the shorter way round.
class Loop_closing
{
public:
  Loop_closing(const Indexed_mesh& mesh, const Corner_table& chart, const Contracted_surface& surface)
    : m_mesh(mesh), m_chart(chart), m_surface(surface)
  {}

  std::vector<Directed_edge> operator()(const Loop& loop) const
  {
    std::vector<Directed_edge> walk;
    int node = loop.start, end = -1;
    for(int e : loop.edges)
    {
      const int h = m_surface.halfedges[e];
      const Directed_edge step{h, m_surface.nodes[m_chart.source(h)] == node};
      if(end >= 0)
        follow_border(end, source(step), walk);
      walk.push_back(step);
      end = target(step);
      node = m_surface.nodes[end];
    }
    follow_border(end, source(walk.front()), walk);
    return walk;
  }

private:
  int source(Directed_edge e) const
  {
    return e.is_forward ? m_chart.source(e.halfedge) : m_chart.target(e.halfedge);
  }
  int target(Directed_edge e) const { return source({e.halfedge, !e.is_forward}); }

  void follow_border(int from, int to, std::vector<Directed_edge>& walk) const
  {
    if(from == to)
      return;
    std::vector<int> loop = m_surface.border_loops[m_surface.nodes[from]];
    const auto halfedge_from = [&](int v)
    {
      return std::find_if(loop.begin(), loop.end(), [&](int h) { return m_chart.source(h) == v; });
    };
    std::rotate(loop.begin(), halfedge_from(from), loop.end());
    const auto middle = halfedge_from(to);
    if(length(loop.begin(), middle) <= length(middle, loop.end()))
      for(auto it = loop.begin(); it != middle; ++it)
        walk.push_back({*it, true});
    else
      for(auto it = loop.end(); it != middle; --it)
        walk.push_back({*std::prev(it), false});
  }

  template <typename Iterator>
  double length(Iterator begin, Iterator end) const
  {
    double sum = 0;
    for(; begin != end; ++begin)
      sum += m_mesh.length(m_mesh.edge(*begin));
    return sum;
  }

  const Indexed_mesh& m_mesh;
  const Corner_table& m_chart;
  const Contracted_surface& m_surface;
};

// Finds loops after which each part that the mandatory cut leaves is as connected as before and has
// genus 0. They are chosen one after the other, each close to the shortest that the former ones
// leave. Several loops may meet and overlap, as they must on coarse meshes with many handles.
// Each is longer by at most `tolerance`, relative, than the shortest. O(g (n log n + g n) + s), where s is the total
// size of the balls searched. `go_further` is asked before each loop.
inline Handle_loops cut_handles(const Indexed_mesh& mesh, const Edge_constraints& constraints,
                                const Go_further& go_further = always_go_further, double tolerance = 0.05)
{
  Handle_loops result{check_handles_can_be_cut(mesh, constraints), {}, constraints.mandatory};
  if(!result.status)
    return result;
  Corner_table chart = make_chart(mesh, result.cut);
  CGAL_postcondition_code(const int number_of_parts = Connected_parts(chart.opposites()).number;)
  for(;;)
  {
    const Contracted_surface surface(chart,
                                     [&](int h) { return constraints.weights[mesh.edge(h)]; });
    const Tree_cotree tree_cotree(chart, surface);
    if(tree_cotree.generators().empty())
      break;
    if(!go_further())
    {
      result.status = stopped_status();
      return result;
    }
    Shortest_loop shortest_loop(surface, tree_cotree, tolerance);
    shortest_loop.search(tree_cotree.cut_graph_nodes());
    const Loop& loop = shortest_loop.loop();
    result.loops.push_back(Loop_closing(mesh, chart, surface)(loop));
    std::vector<int> halfedges;
    for(int e : loop.edges)
    {
      halfedges.push_back(surface.halfedges[e]);
      result.cut[mesh.edge(halfedges.back())] = 1;
    }
    chart.open(halfedges);
  }
  // by Euler's formula, a part without generators has genus 0
  CGAL_postcondition(Connected_parts(chart.opposites()).number == number_of_parts);
  return result;
}

// The same for each component of a mesh, which may have isolated vertices.
inline Handle_loops cut_handles_of_components(const Indexed_mesh& whole, const Edge_constraints& constraints,
                                              const Go_further& go_further)
{
  Handle_loops result{Indexed_status(), {}, constraints.mandatory};
  for(const Indexed_component& component : split_into_components(whole))
  {
    const Handle_loops handles = cut_handles(component.mesh, restriction(constraints, component), go_further);
    if(!handles.status)
      return Handle_loops{component.in_whole(handles.status), {}, constraints.mandatory};
    component.add_to(handles.cut, result.cut);
    for(const std::vector<Directed_edge>& loop : handles.loops)
    {
      result.loops.emplace_back();
      for(const Directed_edge& e : loop)
        result.loops.back().push_back(
          {3 * component.faces[e.halfedge / 3] + e.halfedge % 3, e.is_forward});
    }
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_HANDLE_LOOPS_H
