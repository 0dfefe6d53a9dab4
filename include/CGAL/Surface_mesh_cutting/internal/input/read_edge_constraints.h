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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_READ_EDGE_CONSTRAINTS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_READ_EDGE_CONSTRAINTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/base.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>

#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The weights given by the named parameter `edge_weight_map`, at the scale of the indexed mesh. One that is
// too large for that stays finite: it is to be refused and not to forbid the edge.
template <typename Adapter, typename EdgeWeightMap>
std::vector<double> read_weights(const Adapter& adapter, EdgeWeightMap edge_weight_map)
{
  const Indexed_mesh& mesh = adapter.mesh();
  std::vector<double> weights(mesh.number_of_edges(), 0.);
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    if(!mesh.is_border_edge(e) && !adapter.is_diagonal(e))
    {
      const double weight = CGAL::to_double(get(edge_weight_map, adapter.to_edge(e)));
      weights[e] = std::ldexp(weight, -adapter.exponent());
      if(std::isinf(weights[e]) && std::isfinite(weight))
        weights[e] = std::copysign((std::numeric_limits<double>::max)(), weight);
    }
  return weights;
}

template <typename Adapter>
std::vector<double> read_weights(const Adapter& adapter, internal_np::Param_not_found)
{
  return adapter.mesh().lengths();
}

// Reads the named parameters `edge_weight_map`, `edge_is_constrained_map` and
// `edge_is_forbidden_map`.
template <typename Adapter, typename NamedParameters>
Indexed_status read_edge_constraints(const Adapter& adapter, const NamedParameters& np, Edge_constraints& constraints)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  using edge_descriptor = typename Adapter::edge_descriptor;
  const Static_boolean_property_map<edge_descriptor, false> none;
  const auto is_forbidden
    = choose_parameter(get_parameter(np, internal_np::edge_is_forbidden), none);
  const auto is_constrained
    = choose_parameter(get_parameter(np, internal_np::edge_is_constrained), none);

  const Indexed_mesh& mesh = adapter.mesh();
  constraints.mandatory = adapter.read_cut(is_constrained);
  constraints.weights = read_weights(adapter, get_parameter(np, internal_np::edge_weight));
  if(adapter.has_diagonals())
    constraints.diagonals.resize(mesh.number_of_edges());
  std::vector<int> invalid;
  for(int e = 0; e < mesh.number_of_edges(); ++e)
  {
    if(!(constraints.weights[e] >= 0))
      invalid.push_back(e);
    const bool is_diagonal = adapter.is_diagonal(e);
    if(is_diagonal)
      constraints.diagonals[e] = 1;
    if(is_diagonal || (!mesh.is_border_edge(e) && get(is_forbidden, adapter.to_edge(e))))
      constraints.weights[e] = std::numeric_limits<double>::infinity();
  }
  if(!invalid.empty())
    return Indexed_status(Status_code::WRONG_PARAMETER,
                          "edge_weight_map: weights that are negative or not a number",
                          Element_kind::EDGE, std::move(invalid));
  double sum = 0;
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    if(!constraints.is_forbidden(e))
      sum += constraints.weights[e];
  if(!std::isfinite(4 * sum)) // no path and no bound is heavier
    return Indexed_status(Status_code::WRONG_PARAMETER,
                          "edge_weight_map: the sum of the weights is infinite");
  return Indexed_status();
}

// Reads `vertex_is_constrained_map` and `initial_cut_map` besides the parameters about edges.
template <typename Adapter, typename NamedParameters>
Indexed_status read_constraints(const Adapter& adapter, const NamedParameters& np, Cutting_constraints& constraints)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  using vertex_descriptor = typename Adapter::vertex_descriptor;
  const auto is_terminal
    = choose_parameter(get_parameter(np, internal_np::vertex_is_constrained),
                       Static_boolean_property_map<vertex_descriptor, false>());
  for(int v = 0; v < adapter.mesh().number_of_vertices(); ++v)
    if(get(is_terminal, adapter.to_vertex(v)))
      constraints.terminals.push_back(v);
  using edge_descriptor = typename Adapter::edge_descriptor;
  constraints.initial = adapter.read_cut(choose_parameter(get_parameter(np, internal_np::initial_cut),
                                                          Static_boolean_property_map<edge_descriptor, false>()));
  return read_edge_constraints(adapter, np, constraints.edges);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_READ_EDGE_CONSTRAINTS_H
