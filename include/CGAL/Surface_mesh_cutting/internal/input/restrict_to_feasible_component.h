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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_RESTRICT_TO_FEASIBLE_COMPONENT_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_RESTRICT_TO_FEASIBLE_COMPONENT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Topology.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Contracted_surface.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_component.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>

#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The connected parts of the graph of the edges that may be cut, each border being one node.
//
// A cut that leaves one disk of a connected surface is connected together with the borders, so that
// it lies on one island: that of the borders and terminals, if there are any. There is such a cut on
// an island iff all its edges together leave only disks: where two of these meet, an edge can be left
// out.
class Islands
{
public:
  Islands(const Indexed_mesh& mesh, const Edge_constraints& constraints)
    : m_mesh(mesh), m_constraints(constraints),
      m_surface(make_chart(mesh, Cut(mesh.number_of_edges(), 0)),
                [&](int h) { return constraints.weights[mesh.edge(h)]; }),
      m_island(m_surface.graph.number_of_vertices()), m_nodes(m_island.size(), 0),
      m_edges(m_island.size(), 0)
  {
    CGAL::internal::Graph_kernel::Disjoint_sets sets(int(m_island.size()));
    for(int e = 0; e < m_surface.graph.number_of_edges(); ++e)
      if(is_allowed(e))
        sets.unite(m_surface.graph.edges[e].source, m_surface.graph.edges[e].target);
    for(int node = 0; node < int(m_island.size()); ++node)
    {
      m_island[node] = sets.find(node);
      ++m_nodes[m_island[node]];
    }
    for(int e = 0; e < m_surface.graph.number_of_edges(); ++e)
      if(is_allowed(e))
        ++m_edges[m_island[m_surface.graph.edges[e].source]];
  }

  int of_border() const { return m_island.front(); } // the first one; only if there is one
  int of_vertex(int v) const { return m_island[m_surface.nodes[v]]; }

  // Whether a tree in the island leaves a border of at least three edges on a closed surface.
  bool holds_path(int island) const { return m_nodes[island] > 2; }

  // Those that hold the loops which `genus` handles take, from large to small, ties by index.
  std::vector<int> large_enough(int genus) const
  {
    std::vector<std::pair<int, int> > order;
    for(int i = 0; i < int(m_nodes.size()); ++i)
      if(holds_path(i) && m_edges[i] - m_nodes[i] + 1 >= 2 * genus)
        order.emplace_back(-m_edges[i], i);
    std::sort(order.begin(), order.end());
    std::vector<int> islands;
    for(const auto& [size, i] : order)
      islands.push_back(i);
    return islands;
  }

  // The constraints with all edges outside the island forbidden.
  Edge_constraints restriction_to(int island) const
  {
    Edge_constraints result = m_constraints;
    for(int e = 0; e < m_surface.graph.number_of_edges(); ++e)
      if(m_island[m_surface.graph.edges[e].source] != island)
        result.weights[m_mesh.edge(m_surface.halfedges[e])] = std::numeric_limits<double>::infinity();
    return result;
  }

private:
  bool is_allowed(int e) const
  {
    return !m_constraints.is_forbidden(m_mesh.edge(m_surface.halfedges[e]));
  }

  const Indexed_mesh& m_mesh;
  const Edge_constraints& m_constraints;
  const Contracted_surface m_surface;
  std::vector<int> m_island;         // per node, the one that stands for its island
  std::vector<int> m_nodes, m_edges; // of the island that a node stands for, how many
};

// Forbids all edges but those of one island on which a connected surface can be cut to a disk with
// all terminals on its border. O(n); more only for closed surfaces with handles and many islands.
inline Indexed_status restrict_to_feasible_component(const Indexed_mesh& mesh, const Topology& topology,
                                   const std::vector<int>& terminals, Edge_constraints& constraints)
{
  if(!has_forbidden_sides(constraints))
    return Indexed_status();
  std::vector<int> forbidden = forbidden_edges(mesh, constraints);

  const Islands islands(mesh, constraints);
  const bool is_closed = topology.border_loops == 0;
  std::vector<int> choices;
  if(!is_closed)
    choices = {islands.of_border()};
  else if(!terminals.empty())
    choices = {islands.of_vertex(terminals.front())};
  else
    choices = islands.large_enough(topology.genus());

  std::vector<int> enclosed;
  for(int v : terminals)
    if(islands.of_vertex(v) != choices.front() || (is_closed && !islands.holds_path(choices.front())))
      enclosed.push_back(v);
  if(!enclosed.empty())
    return Indexed_status(Status_code::INFEASIBLE_CONSTRAINTS,
                          "vertices reachable only through forbidden edges",
                          Element_kind::VERTEX, std::move(enclosed));
  for(int island : choices)
  {
    Edge_constraints restricted = islands.restriction_to(island);
    if(check_disks_can_be_reached(mesh, restricted))
    {
      constraints = std::move(restricted);
      return Indexed_status();
    }
  }
  const Indexed_status status = check_disks_can_be_reached(mesh, constraints);
  if(!status)
    return status;
  return Indexed_status(Status_code::INFEASIBLE_CONSTRAINTS,
                        "forbidden edges leave no path of two edges to cut",
                        Element_kind::EDGE, std::move(forbidden));
}

// The vertices of a component that are terminals of the whole (in increasing order), but those that its
// border connects already.
inline std::vector<int> inner_terminals(const Indexed_component& component, const std::vector<int>& terminals)
{
  const std::vector<char> is_open
    = open_vertices(component.mesh, Cut(component.mesh.number_of_edges(), 0));
  std::vector<int> inner;
  for(int v = 0; v < component.mesh.number_of_vertices(); ++v)
    if(!is_open[v] && std::binary_search(terminals.begin(), terminals.end(), component.vertices[v]))
      inner.push_back(v);
  return inner;
}

// The same as `restrict_to_feasible_component()` for each part that the mandatory edges leave.
inline Indexed_status restrict_to_feasible_components(const Indexed_mesh& mesh, std::vector<int> terminals,
                                            Edge_constraints& constraints)
{
  std::sort(terminals.begin(), terminals.end());
  for(const Indexed_component& component : split_along(mesh, constraints.mandatory))
  {
    Edge_constraints part = restriction(constraints, component);
    part.mandatory.assign(component.edges.size(), 0); // it is on the border
    const Indexed_status status = restrict_to_feasible_component(component.mesh, component.topology,
                                               inner_terminals(component, terminals), part);
    if(!status)
      return component.in_whole(status);
    for(int e = 0; e < component.mesh.number_of_edges(); ++e)
      if(!component.mesh.is_border_edge(e))
        constraints.weights[component.edges[e]] = part.weights[e];
  }
  return Indexed_status();
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_RESTRICT_TO_FEASIBLE_COMPONENT_H
