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
#include <CGAL/Surface_mesh_cutting/internal/handles/Growing_opening.h>
#include <CGAL/Surface_mesh_cutting/internal/handles/Short_loop_search.h>
#include <CGAL/Surface_mesh_cutting/internal/handles/Tree_cotree.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Execution.h>

#include <CGAL/assertions.h>

#include <algorithm>
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

// Completes a cycle to a closed walk: where it enters a border loop at one vertex and leaves it at another one, it
// follows the border the shorter way round.
inline std::vector<Directed_edge> closed_walk(const Indexed_mesh& mesh, const Growing_opening& surface,
                                              const std::vector<int>& cycle)
{
  const auto length = [&](int h) { return mesh.length(mesh.edge(h)); };
  std::vector<Directed_edge> walk;
  int end = surface.chart().target(cycle.back());
  for(int h : cycle)
  {
    for(const auto& [border, is_forward] : surface.along_border(end, surface.chart().source(h), length))
      walk.push_back({border, is_forward});
    walk.push_back({h, true});
    end = surface.chart().target(h);
  }
  return walk;
}

// Of the graph that a `Growing_opening` starts with: the nodes of a cut graph and the border loops.
inline std::vector<int> roots_of_loops(const Growing_opening& surface, const Contracted_surface& contracted,
                                       const Tree_cotree& tree_cotree)
{
  std::vector<char> is_root(contracted.graph.number_of_vertices(), 0);
  std::fill_n(is_root.begin(), contracted.border_loops.size(), char(1));
  for(int node : tree_cotree.cut_graph_nodes())
    is_root[node] = 1;
  std::vector<int> roots;
  for(int v = 0; v < surface.number_of_vertices(); ++v)
    if(surface.node(v) == v && is_root[contracted.nodes[v]])
      roots.push_back(v);
  return roots;
}

inline int total_genus(const Corner_table& chart)
{
  int genus = 0;
  for(const Topology& t : topologies(chart, Connected_parts(chart.opposites())))
    genus += t.genus();
  return genus;
}

// Finds loops after which each part that the mandatory cut leaves is as connected as before and has
// genus 0. They are chosen one after the other, each close to the shortest that the former ones
// leave. Several loops may meet and overlap, as they must on coarse meshes with many handles.
// Each is longer by at most `tolerance`, relative, than the shortest. O(n log n + s), where s is the total size of the
// balls searched, for each 192 handles. `go_further` is asked before each loop.
inline Handle_loops cut_handles(const Indexed_mesh& mesh, const Edge_constraints& constraints,
                                const Go_further& go_further = always_go_further, double tolerance = 0.02)
{
  Handle_loops result{check_handles_can_be_cut(mesh, constraints), {}, constraints.mandatory};
  if(!result.status)
    return result;
  const auto weight = [&](int h) { return constraints.weights[mesh.edge(h)]; };
  Corner_table chart = make_chart(mesh, result.cut);
  CGAL_postcondition_code(const int number_of_parts = Connected_parts(chart.opposites()).number;)
  for(int remaining = total_genus(chart); remaining > 0;)
  {
    const Contracted_surface contracted(chart, weight);
    const Tree_cotree tree_cotree(chart, contracted, (unsigned int)remaining);
    Growing_opening surface(chart, tree_cotree);
    Short_loop_search search(surface, weight, roots_of_loops(surface, contracted, tree_cotree), tolerance);
    for(int i = (std::min)(remaining, tree_cotree.number_of_loops()); i > 0; --i, --remaining)
    {
      if(!go_further())
      {
        result.status = stopped_status();
        return result;
      }
      const Short_loop loop = search.find();
      CGAL_assertion(!loop.halfedges.empty()); // a surface with handles has one
      result.loops.push_back(closed_walk(mesh, surface, loop.halfedges));
      for(int h : loop.halfedges)
        result.cut[mesh.edge(h)] = 1;
      search.open(loop);
    }
  }
  CGAL_postcondition(total_genus(chart) == 0);
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
