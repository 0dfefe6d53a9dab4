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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_CONNECT_TERMINALS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_CONNECT_TERMINALS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/connection/Connected_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Topology.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Contracted_surface.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>
#include <CGAL/boost/graph/internal/Graph_kernel/Execution.h>
#include <CGAL/boost/graph/internal/Steiner_tree/solve.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using CGAL::internal::Graph_kernel::Execution;
using CGAL::internal::Graph_kernel::Go_further;

// Connects the borders and the terminals in each part of an opened surface by a Steiner tree in
// its contracted graph: each border is one terminal. If the parts have genus 0, they become disks.
class Terminal_connector
{
  using Options = CGAL::internal::Steiner_tree::Options;
  using Outcome = CGAL::internal::Steiner_tree::Outcome;

  // A part of the contracted graph, without forbidden edges.
  struct Part
  {
    Csr_graph graph;
    std::vector<int> nodes, edges; // in the whole
    std::vector<int> terminals;
    bool is_closed;
  };

public:
  Terminal_connector(const Indexed_mesh& mesh, const Edge_constraints& constraints)
    : m_mesh(mesh), m_constraints(constraints), m_chart(make_chart(mesh, constraints.mandatory)),
      m_connected(m_chart.opposites()), m_topologies(topologies(m_chart, m_connected)),
      m_surface(m_chart, [&](int h) { return constraints.weights[mesh.edge(h)]; }),
      m_part_of_node(m_surface.graph.number_of_vertices(), -1)
  {
    m_result.cut = constraints.mandatory;
    for(int h = 0; h < int(m_chart.opposites().size()); ++h)
      m_part_of_node[m_surface.nodes[m_chart.source(h)]] = m_connected.part[h / 3];
  }

  // `options` and `go_further` are those of the Steiner tree solver, which begins with the known cut where that connects
  // a part.
  Connected_cut connect(const std::vector<int>& terminals, const Options& options,
                        Execution execution, const Go_further& go_further, const Cut& known)
  {
    m_result.status = check_disks_can_be_reached(m_mesh, m_constraints);
    if(m_result.status)
      m_result.status = check_terminals(terminals);
    if(!m_result.status)
      return m_result;
    const std::vector<Part> parts = make_parts(terminals);
    for(std::size_t i = 0; i < parts.size() && m_result.status; ++i)
      m_result.status = check_part(parts[i], int(i));
    if(!m_result.status)
      return m_result;
    for(const Part& part : parts)
      add_tree(part, CGAL::internal::Steiner_tree::solve(part.graph, part.terminals, options,
                                                         execution, go_further, connecting_edges(part, known)));
    lengthen_short_borders();
    return m_result;
  }

private:
  int halfedge(int e) const { return m_surface.halfedges[e]; }

  Indexed_status check_terminals(const std::vector<int>& terminals) const
  {
    std::vector<int> isolated;
    for(int v : terminals)
      if(m_mesh.is_isolated(v))
        isolated.push_back(v);
    if(isolated.empty())
      return Indexed_status();
    return Indexed_status(Status_code::INFEASIBLE_CONSTRAINTS, "isolated vertices cannot be connected",
                          Element_kind::VERTEX, std::move(isolated));
  }

  std::vector<Part> make_parts(const std::vector<int>& terminals) const
  {
    std::vector<Part> parts(m_connected.number);
    std::vector<int> local(m_part_of_node.size());
    for(int node = 0; node < int(local.size()); ++node)
      if(m_part_of_node[node] >= 0)
      {
        std::vector<int>& nodes = parts[m_part_of_node[node]].nodes;
        local[node] = int(nodes.size());
        nodes.push_back(node);
      }

    std::vector<std::vector<CGAL::internal::Graph_kernel::Edge> > edges(parts.size());
    if(parts.size() == 1)
    {
      parts.front().edges.reserve(m_surface.graph.edges.size());
      edges.front().reserve(m_surface.graph.edges.size());
    }
    for(int e = 0; e < m_surface.graph.number_of_edges(); ++e)
    {
      if(m_constraints.is_forbidden(m_mesh.edge(halfedge(e))))
        continue;
      const auto& edge = m_surface.graph.edges[e];
      const int part = m_part_of_node[edge.source];
      parts[part].edges.push_back(e);
      edges[part].push_back({local[edge.source], local[edge.target], edge.weight});
    }

    std::vector<int> terminal_nodes;
    for(int i = 0; i < int(m_surface.border_loops.size()); ++i)
      terminal_nodes.push_back(i);
    for(int v : terminals)
      terminal_nodes.push_back(m_surface.nodes[v]); // a vertex has copies only on borders
    std::vector<char> is_terminal(local.size(), 0);
    for(int node : terminal_nodes)
      if(!std::exchange(is_terminal[node], char(1)))
        parts[m_part_of_node[node]].terminals.push_back(local[node]);

    for(std::size_t i = 0; i < parts.size(); ++i)
    {
      parts[i].graph = Csr_graph(int(parts[i].nodes.size()), std::move(edges[i]));
      parts[i].is_closed = m_topologies[i].border_loops == 0;
    }
    return parts;
  }

  Indexed_status check_part(const Part& part, int index) const
  {
    CGAL_assertion(m_topologies[index].genus() == 0); // handles are cut first
    if(part.is_closed && part.terminals.size() < 2)
      return Indexed_status(Status_code::WRONG_PARAMETER,
                            "a closed part with fewer than two vertices to connect",
                            Element_kind::FACE, faces(index));
    // What is allowed is connected, as it leaves only disks; only vertices inside those are not on
    // it.
    std::vector<int> enclosed;
    if(part.terminals.size() > 1)
      for(int t : part.terminals)
        if(part.graph.degree(t) == 0)
          enclosed.push_back(vertex(part.nodes[t]));
    if(enclosed.empty())
      return Indexed_status();
    return Indexed_status(Status_code::INFEASIBLE_CONSTRAINTS,
                          "vertices reachable only through forbidden edges",
                          Element_kind::VERTEX, std::move(enclosed));
  }

  std::vector<int> faces(int part) const
  {
    std::vector<int> result;
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      if(m_connected.part[f] == part)
        result.push_back(f);
    return result;
  }

  // Some vertex of the surface at a node.
  int vertex(int node) const
  {
    const std::vector<int>& nodes = m_surface.nodes;
    return int(std::find(nodes.begin(), nodes.end(), node) - nodes.begin());
  }

  // Those of the cut in a part if they connect its terminals.
  std::vector<int> connecting_edges(const Part& part, const Cut& cut) const
  {
    std::vector<int> result;
    const auto is_cut = [&](int e) { return cut[m_mesh.edge(halfedge(part.edges[e]))] != 0; };
    if(cut.empty() || !CGAL::internal::Graph_kernel::are_connected(part.graph, part.terminals, is_cut))
      return result;
    for(int e = 0; e < part.graph.number_of_edges(); ++e)
      if(is_cut(e))
        result.push_back(e);
    return result;
  }

  void add_tree(const Part& part, const CGAL::internal::Steiner_tree::Solution& solution)
  {
    if(solution.outcome == Outcome::budget_exceeded && solution.tree.edges.empty())
      m_result.status = Indexed_status(Status_code::WRONG_PARAMETER,
                                       "maximum_number_of_states is too small for the method");
    else if(solution.outcome == Outcome::cancelled && m_result.status)
      m_result.status = Indexed_status(Status_code::STOPPED, "stopped while connecting");
    std::vector<int> halfedges;
    for(int e : solution.tree.edges)
      halfedges.push_back(halfedge(part.edges[e]));
    open(halfedges);
    m_result.lower_bound += solution.lower_bound;
    m_result.is_optimal = m_result.is_optimal && solution.is_optimal;
    m_result.number_of_auxiliary_points += int(CGAL::internal::Steiner_tree::branch_vertices(
      part.graph, part.terminals, solution.tree).size());
  }

  void open(const std::vector<int>& halfedges)
  {
    for(int h : halfedges)
    {
      m_result.cut[m_mesh.edge(h)] = 1;
      m_result.weight += m_constraints.weights[m_mesh.edge(h)];
    }
    m_chart.open(halfedges);
  }

  // A disk in the plane has at least three border edges; one cut edge alone, or the border between
  // two parallel edges, gives two. The cheapest edge from there inwards makes them four.
  void lengthen_short_borders()
  {
    const auto weight = [this](int h) { return m_constraints.weights[m_mesh.edge(h)]; };
    for(const std::vector<int>& loop : m_chart.border_loops())
    {
      if(loop.size() != 2)
        continue;
      const int ends[2] = {m_chart.source(loop[0]), m_chart.source(loop[1])};
      int best = -1;
      for(int b : loop)
        for(int h = m_chart.next_around_source(b); h >= 0; h = m_chart.next_around_source(h))
          if(m_chart.target(h) != ends[0] && m_chart.target(h) != ends[1] &&
             (best < 0 || weight(h) < weight(best)))
            best = h;
      if(best < 0 || m_constraints.is_forbidden(m_mesh.edge(best)))
      {
        m_result.status = Indexed_status(Status_code::INFEASIBLE_CONSTRAINTS,
                                         "forbidden edges leave a border of two edges",
                                         Element_kind::FACE, {loop.front() / 3});
        return;
      }
      open({best});
      m_result.is_optimal = false; // a longer tree may have been better
    }
  }

  const Indexed_mesh& m_mesh;
  const Edge_constraints& m_constraints;
  Corner_table m_chart;
  const Connected_parts m_connected;
  const std::vector<Topology> m_topologies;
  const Contracted_surface m_surface;
  std::vector<int> m_part_of_node;
  Connected_cut m_result;
};

// Adds the edges of least weight to the mandatory ones that connect, within each part, all borders
// and all given vertices; a closed part needs two vertices. A part that is a disk without vertices
// to connect stays as it is. A known cut that connects the vertices saves much time if it is short.
inline Connected_cut connect_terminals(const Indexed_mesh& mesh, const Edge_constraints& constraints,
                                       const std::vector<int>& terminals,
                                       const CGAL::internal::Steiner_tree::Options& options, Execution execution,
                                       const Go_further& go_further, const Cut& known = Cut())
{
  return Terminal_connector(mesh, constraints).connect(terminals, options, execution, go_further, known);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_CONNECT_TERMINALS_H
