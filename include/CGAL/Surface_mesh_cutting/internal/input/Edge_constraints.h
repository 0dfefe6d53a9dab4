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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_EDGE_CONSTRAINTS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_EDGE_CONSTRAINTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Topology.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_component.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// What a caller may say about the edges. An edge of infinite weight is forbidden: it is never cut.
struct Edge_constraints
{
  std::vector<double> weights; // not negative; those of border edges do not matter
  Cut mandatory;               // open from the start
  Cut diagonals;               // of polygons, which are never cut; empty if there are none

  bool is_forbidden(int e) const { return weights[e] == std::numeric_limits<double>::infinity(); }
};

// What a caller may say about edges and vertices.
struct Cutting_constraints
{
  Edge_constraints edges;
  std::vector<int> terminals; // vertices that the cut passes through
  Cut initial;                // what the search starts from; no edge: nothing is known
};

inline Edge_constraints unconstrained(const Indexed_mesh& mesh)
{
  return Edge_constraints{mesh.lengths(), Cut(mesh.number_of_edges(), 0), Cut()};
}

// Whether the caller forbids an edge. A diagonal alone keeps nothing from being cut: the sides of its polygon lead
// around it.
inline bool has_forbidden_sides(const Edge_constraints& constraints)
{
  for(std::size_t e = 0; e < constraints.weights.size(); ++e)
    if(constraints.is_forbidden(int(e)) && (constraints.diagonals.empty() || !constraints.diagonals[e]))
      return true;
  return false;
}

// What cutting these edges costs.
inline double total_cost(const Edge_constraints& constraints, const std::vector<int>& edges)
{
  double cost = 0;
  for(int e : edges)
    cost += constraints.weights[e];
  return cost;
}

inline double cut_cost(const Edge_constraints& constraints, const Cut& cut)
{
  double cost = 0;
  for(std::size_t e = 0; e < cut.size(); ++e)
    if(cut[e])
      cost += constraints.weights[e];
  return cost;
}

// What a unit of length costs on average, where the surface may be cut.
inline double cost_per_length(const Indexed_mesh& mesh, const Edge_constraints& constraints)
{
  double cost = 0, length = 0;
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    if(!mesh.is_border_edge(e) && !constraints.is_forbidden(e))
    {
      cost += constraints.weights[e];
      length += mesh.length(e);
    }
  return cost > 0 && length > 0 ? cost / length : 1;
}

// Makes a unit of length cost 1 on average, so that results do not depend on the unit of the weights; weights that are
// lengths up to rounding become lengths. Returns what the unit cost before.
inline double normalize_weights(const Indexed_mesh& mesh, Edge_constraints& constraints)
{
  constexpr double rounding = 1e-9;
  const double unit = cost_per_length(mesh, constraints);
  for(int e = 0; e < mesh.number_of_edges(); ++e)
  {
    double& weight = constraints.weights[e];
    weight /= unit;
    if(std::abs(weight - mesh.length(e)) <= rounding * mesh.length(e))
      weight = mesh.length(e);
  }
  return unit;
}

// Whether the weights of the edges that may be cut are their lengths.
inline bool weights_are_lengths(const Indexed_mesh& mesh, const Edge_constraints& constraints)
{
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    if(!mesh.is_border_edge(e) && !constraints.is_forbidden(e) &&
       constraints.weights[e] != mesh.length(e))
      return false;
  return true;
}

inline std::vector<int> forbidden_edges(const Indexed_mesh& mesh, const Edge_constraints& constraints)
{
  std::vector<int> forbidden;
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    if(!mesh.is_border_edge(e) && constraints.is_forbidden(e))
      forbidden.push_back(e);
  return forbidden;
}

// The edges that may be cut.
inline Cut allowed_edges(const Indexed_mesh& mesh, const Edge_constraints& constraints)
{
  Cut allowed(mesh.number_of_edges());
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    allowed[e] = !mesh.is_border_edge(e) && !constraints.is_forbidden(e);
  return allowed;
}

// The vertices at edges that may be cut.
inline std::vector<char> reachable_vertices(const Indexed_mesh& mesh, const Edge_constraints& constraints)
{
  std::vector<char> is_reachable(mesh.number_of_vertices(), 0);
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    if(!mesh.is_border_edge(e) && !constraints.is_forbidden(e))
      is_reachable[mesh.source(mesh.halfedge(e))] = is_reachable[mesh.target(mesh.halfedge(e))] = 1;
  return is_reachable;
}

inline Edge_constraints restriction(const Edge_constraints& whole, const Indexed_component& component)
{
  Edge_constraints constraints;
  for(int e : component.edges)
    constraints.weights.push_back(whole.weights[e]);
  constraints.mandatory = component.restriction(whole.mandatory);
  if(!whole.diagonals.empty())
    constraints.diagonals = component.restriction(whole.diagonals);
  return constraints;
}

inline Indexed_status check_no_edge_is_mandatory_and_forbidden(const Indexed_mesh& mesh,
                                                               const Edge_constraints& constraints)
{
  std::vector<int> conflicts;
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    if(constraints.mandatory[e] && constraints.is_forbidden(e))
      conflicts.push_back(e);
  if(conflicts.empty())
    return Indexed_status();
  return Indexed_status(Status_code::INFEASIBLE_CONSTRAINTS, "edges both mandatory and forbidden",
                        Element_kind::EDGE, std::move(conflicts));
}

// Cuts every permitted edge and checks what remains: each part, held together by forbidden edges,
// must be `is_possible(topology)`. Otherwise the forbidden edges in the first part that is not are
// the witness. O(n).
//
// Handles can be cut iff no part has a handle: cycles of allowed edges span the orthogonal
// complement of the cycles within the parts, with respect to the number of crossings, and contain g
// independent ones that do not cross each other iff no two cycles within the parts cross. Disks can
// be reached iff all parts are disks.
template <typename IsPossible>
Indexed_status check_forbidden_edges(const Indexed_mesh& mesh, const Edge_constraints& constraints,
                                     IsPossible is_possible, const std::string& message)
{
  const std::vector<int> forbidden = forbidden_edges(mesh, constraints);
  if(forbidden.empty()) // each part is a triangle
    return Indexed_status();
  const Corner_table chart = make_chart(mesh, allowed_edges(mesh, constraints));
  const Connected_parts parts(chart.opposites());
  const std::vector<Topology> topology = topologies(chart, parts);
  const auto bad = std::find_if_not(topology.begin(), topology.end(), is_possible);
  if(bad == topology.end())
    return Indexed_status();
  std::vector<int> edges;
  for(int e : forbidden)
    if(parts.part[mesh.halfedge(e) / 3] == bad - topology.begin())
      edges.push_back(e);
  return Indexed_status(Status_code::INFEASIBLE_CONSTRAINTS, message, Element_kind::EDGE,
                        std::move(edges));
}

// Whether the constraints leave a way to cut all handles.
inline Indexed_status check_handles_can_be_cut(const Indexed_mesh& mesh,
                                               const Edge_constraints& constraints)
{
  Indexed_status status = check_no_edge_is_mandatory_and_forbidden(mesh, constraints);
  if(status)
    status = check_forbidden_edges(mesh, constraints,
                                   [](const Topology& t) { return t.genus() == 0; },
                                   "forbidden edges keep a handle from being cut");
  return status;
}

// Whether the constraints leave a way to cut the surface to disks, which have no handles: those are named if they are
// in the way.
inline Indexed_status check_disks_can_be_reached(const Indexed_mesh& mesh,
                                                 const Edge_constraints& constraints)
{
  Indexed_status status = check_no_edge_is_mandatory_and_forbidden(mesh, constraints);
  if(!status)
    return status;
  status = check_forbidden_edges(mesh, constraints, [](const Topology& t) { return t.is_disk(); },
                                 "forbidden edges keep a part from becoming a disk");
  if(status)
    return status;
  const Indexed_status handles = check_handles_can_be_cut(mesh, constraints);
  return handles ? status : handles;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_EDGE_CONSTRAINTS_H
