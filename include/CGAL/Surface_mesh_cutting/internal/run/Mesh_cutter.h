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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_MESH_CUTTER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_MESH_CUTTER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/input/restrict_to_feasible_component.h>
#include <CGAL/Surface_mesh_cutting/internal/result/Distortion_bounds.h>
#include <CGAL/Surface_mesh_cutting/internal/result/Mesh_result.h>
#include <CGAL/Surface_mesh_cutting/internal/result/certified_map.h>
#include <CGAL/Surface_mesh_cutting/internal/result/side_by_side.h>
#include <CGAL/Surface_mesh_cutting/internal/run/Component_cutter.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/lengths.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Map_measures.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Execution.h>
#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using Surface_mesh_parameterization::internal::Map_measures;
using Surface_mesh_parameterization::internal::execute_both;

// Runs the method on each component that the mandatory edges leave and puts the parts together. What
// is mandatory is opened first: it is border from then on, which the connection takes for connected.
class Mesh_cutter
{
public:
  // `round`: what becomes of a UV at the scale of the indexed mesh when it is handed out and read back.
  Mesh_cutter(const Indexed_mesh& mesh, Round round, const Cutting_constraints& constraints, const Context& context)
    : m_mesh(mesh), m_round(std::move(round)), m_constraints(constraints), m_context(context)
  {}

  Mesh_result run(Output_kind output)
  {
    Mesh_result result;
    result.diagonal = bounding_box_diagonal(m_mesh);
    result.status = check_constraints();
    const Cut& mandatory = m_constraints.edges.mandatory;
    std::vector<Indexed_component> components;
    execute_both(m_context.execution, [&] { describe_topology(result); }, [&]
    {
      if(result.status)
        components = split_along(m_mesh, mandatory);
    });
    if(!result.status)
      return result;
    result.cut = mandatory;
    result.length = result.lower_bound = cut_length(m_mesh, mandatory);
    result.cost = cut_cost(m_constraints.edges, mandatory);
    if(output == Output_kind::MAP)
      result.status = check_extents(components);
    if(!result.status)
      return result;
    std::vector<Component_result> parts = cut_components(components, output);
    for(std::size_t i = 0; i < components.size(); ++i)
      if(!add_part(components[i], std::move(parts[i]), output, result))
        return result;
    complete(result);
    if(components.size() > 1)
      result.trade_offs.clear();
    result.has_result = true;
    if(output == Output_kind::MAP)
      certify(result);
    return result;
  }

private:
  void describe_topology(Mesh_result& result) const
  {
    const Corner_table chart = make_chart(m_mesh, Cut(m_mesh.number_of_edges(), 0));
    for(const Topology& t : topologies(chart, Connected_parts(chart.opposites())))
    {
      ++result.components;
      result.genus += t.genus();
      result.borders += t.border_loops;
    }
  }

  Indexed_status check_constraints() const
  {
    std::vector<int> isolated;
    for(int v : m_constraints.terminals)
      if(m_mesh.is_isolated(v))
        isolated.push_back(v);
    if(!isolated.empty())
      return Indexed_status(Status_code::INFEASIBLE_CONSTRAINTS, "isolated vertices cannot be connected",
                            Element_kind::VERTEX, std::move(isolated));
    return check_no_edge_is_mandatory_and_forbidden(m_mesh, m_constraints.edges);
  }

  // Next to the chart of the largest component, the vertices of a far smaller one would get the same UVs.
  Indexed_status check_extents(const std::vector<Indexed_component>& components) const
  {
    constexpr double least_share = 1e-14; // of the largest extent, of which a UV resolves 1e-16
    std::vector<double> extents;
    for(const Indexed_component& c : components)
      extents.push_back(bounding_box_diagonal(c.mesh));
    const double largest = extents.empty() ? 0 : *std::max_element(extents.begin(), extents.end());
    std::vector<int> vertices;
    for(std::size_t i = 0; i < components.size(); ++i)
      if(extents[i] > 0 && extents[i] < least_share * largest) // those without extent get charts of some size
        vertices.insert(vertices.end(), components[i].vertices.begin(), components[i].vertices.end());
    if(vertices.empty())
      return Indexed_status();
    std::sort(vertices.begin(), vertices.end());
    return Indexed_status(Status_code::INVALID_POINT, "parts too small to be mapped next to the largest one",
                          Element_kind::VERTEX, std::move(vertices));
  }

  // All terminals are features, also those that needed no connection. No length is proven where
  // weights are minimized.
  void complete(Mesh_result& result) const
  {
    CGAL::internal::Graph_kernel::add_unique(m_constraints.terminals, result.features);
    if(!weights_are_lengths(m_mesh, m_constraints.edges))
      result.lower_bound = 0;
  }

  // Each in a place of its own, in parallel if the tag says so. What comes after a component that fails
  // is not needed.
  std::vector<Component_result> cut_components(const std::vector<Indexed_component>& components, Output_kind output)
  {
    std::vector<Component_result> parts(components.size());
    std::atomic<int> first_failure(int(components.size()));
    execute(m_context.execution, int(components.size()), [&](int i)
    {
      if(i > first_failure)
        return;
      parts[i] = cut_component(components[i], output);
      for(int first = first_failure; !has_result(parts[i], output) && i < first;)
        if(first_failure.compare_exchange_weak(first, i))
          return;
    });
    return parts;
  }

  Component_result cut_component(const Indexed_component& component, Output_kind output)
  {
    Component_result part;
    Edge_constraints constraints = restriction(m_constraints.edges, component);
    constraints.mandatory.assign(component.edges.size(), 0); // it is on the border
    const double cost_unit = normalize_weights(component.mesh, constraints);
    std::vector<int> terminals = inner_terminals(component, m_constraints.terminals);
    part.status = restrict_to_feasible_component(component.mesh, component.topology, terminals, constraints);
    if(!part.status)
      return part;
    Cutting_parameters parameters = m_context.parameters;
    const double diagonal = bounding_box_diagonal(component.mesh);
    parameters.connection.minimum_length_decrease = parameters.minimum_length_decrease * diagonal;
    parameters.decrease_per_cost /= diagonal;
    parameters.maximum_average_distortion
      = (std::min)(parameters.maximum_average_distortion, parameters.maximum_chart_distortion);
    const bool many_handles = has_many_handles(component.topology, terminals.size(), parameters);
    if(many_handles)
      parameters.connection.maximum_number_of_terminals = Cutting_parameters::many_terminals;
    parameters.has_weights = !weights_are_lengths(component.mesh, constraints);
    parameters.adapt_to_size(component.mesh.number_of_faces());
    const Indexed_mesh& mesh = component.mesh;
    Problem problem{mesh,
                    Surface_mesh_parameterization::internal::rest_shapes(mesh.triangles(), mesh.points(), m_context.execution),
                    std::move(constraints),
                    std::move(terminals),
                    Initial_cut(component.restriction(m_constraints.initial)),
                    component.topology.genus() == 0 && component.topology.border_loops == 0, many_handles};
    Run_control control(m_context.control, double(mesh.number_of_faces()) / m_mesh.number_of_faces());
    Component_cutter cutter(std::move(problem), Context{parameters, control, m_context.clock, m_context.execution});
    const bool needs_map = output == Output_kind::MAP || parameters.has_local_bounds();
    part = output == Output_kind::FEATURES ? cutter.detect() : cutter.run(needs_map);
    if(output != Output_kind::FEATURES && !has_result(part, output) && makes_do(mesh, part.status))
      part = cutter.completed_early(std::move(part), needs_map);
    part.cost *= cost_unit;
    for(Trade_off& t : part.trade_offs)
      t.cut_cost *= cost_unit;
    return part;
  }

  // Whether a run without a result makes do with a cut and map of a component that take little time: after a numerical
  // failure, since other components may be fine, and after a stop but on larger surfaces, where even these take too much.
  bool makes_do(const Indexed_mesh& component, const Indexed_status& status) const
  {
    if(status.finding.code == Status_code::NUMERICAL_FAILURE)
      return true;
    constexpr int largest = 50000, largest_sum = 150000; // faces; several components do not take long to map
    return m_context.control.is_stopped() && component.number_of_faces() <= largest &&
           m_mesh.number_of_faces() <= largest_sum;
  }

  // Whether loops that cut the handles may leave more borders than a tree that is proven shortest connects.
  static bool has_many_handles(const Topology& topology, std::size_t terminals, const Cutting_parameters& parameters)
  {
    return topology.genus() > 0 && !parameters.needs_optimal_tree && !parameters.use_published_method &&
           parameters.connection.method == CGAL::internal::Steiner_tree::Method::exact &&
           2 * topology.genus() + topology.border_loops + terminals > Cutting_parameters::many_terminals;
  }

  static bool has_result(const Component_result& part, Output_kind output)
  {
    return output == Output_kind::MAP ? part.has_map : output == Output_kind::CUT ? part.has_cut : bool(part.status);
  }

  // Adds what was found for a component; false if it failed.
  bool add_part(const Indexed_component& component, Component_result part, Output_kind output, Mesh_result& result) const
  {
    result.number_of_candidates += part.number_of_candidates;
    if(!part.status)
      result.status = component.in_whole(part.status);
    if(!has_result(part, output))
      return false;
    for(int v : part.features)
      result.features.push_back(component.vertices[v]);
    if(output == Output_kind::FEATURES)
      return true;
    component.add_to(part.cut, result.cut);
    result.number_of_auxiliary_points += part.number_of_auxiliary_points;
    for(const Trade_off& t : part.trade_offs) // of the first component: with the mandatory edges
      result.trade_offs.push_back({result.length + t.cut_length, result.cost + t.cut_cost, t.average_distortion});
    result.length += part.length;
    result.cost += part.cost;
    result.lower_bound += part.lower_bound;
    result.is_optimal = result.is_optimal && part.is_optimal;
    if(m_context.parameters.needs_optimal_tree && !part.is_tree_proven && result.status)
      result.status = Indexed_status(Status_code::BOUND_NOT_REACHED,
                                     "the tree through the points is not proven shortest within the budget");
    if(output == Output_kind::MAP)
      add_map(component, std::move(part), result);
    return true;
  }

  // Hands the UVs of the component's chart over to the chart of the whole.
  void add_map(const Indexed_component& component, Component_result part, Mesh_result& result) const
  {
    if(result.chart.number_of_triangles() == 0)
      result.chart = make_chart(m_mesh, m_constraints.edges.mandatory);
    std::vector<int> halfedges;
    for(std::size_t e = 0; e < component.edges.size(); ++e)
      if(part.cut[e])
        halfedges.push_back(m_mesh.halfedge(component.edges[e]));
    result.chart.open(halfedges);
    result.uv.resize(result.chart.number_of_vertices(), Eigen::Vector2d::Zero());
    component.add_map(part.chart, part.uv, result.chart, result.uv);
  }

  // The charts lie along the axes, unless the map does not stand being turned: triangles may be thinner than that rounds.
  Certified_map held_map(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv) const
  {
    Certified_map map;
    for(const bool do_align : {true, false})
    {
      map = certified_map(chart, side_by_side(chart, uv, do_align), m_context.parameters.do_bijective, m_round,
                          m_context.execution);
      if(map.certificate)
        break;
    }
    return map;
  }

  // Measures the map as the caller's map will hold it and proves it free of flips and, if asked for, of overlaps; a
  // map that fails is not handed out.
  void certify(Mesh_result& result) const
  {
    const bool do_bijective = m_context.parameters.do_bijective;
    const Map_measures measures(m_mesh.triangles(), m_mesh.points(), result.chart.triangles(), m_context.execution);
    const double scale = measures.best_scale(result.uv);
    for(Eigen::Vector2d& u : result.uv)
      u *= scale;
    Certified_map map;
    Indexed_status disks;
    execute_both(m_context.execution, [&] { disks = check_disks(result.chart); },
                 [&] { map = held_map(result.chart, result.uv); });
    result.uv = std::move(map.uv);
    result.flips = map.certificate.flips;
    if(do_bijective)
      result.overlaps = map.certificate.overlaps();
    result.has_result = disks && map.certificate;
    if(!disks)
      result.status.finding = disks.finding;
    else if(!map.certificate)
      result.status.finding = map.certificate.status().finding;
    else
      measure(measures, result);
  }

  // What decides whether a bound is kept is the map as it is: an energy of the whole, of faces as thin as they are.
  void measure(const Map_measures& measures, Mesh_result& result) const
  {
    const Map_measures::Energies energies = measures.energies(result.uv);
    if(!std::isfinite(energies.average))
    {
      result.has_result = false;
      result.status.finding = Finding{Status_code::NUMERICAL_FAILURE, "the surface has (nearly) no area",
                                      Element_kind::NONE, {}};
      return;
    }
    result.average_energy = energies.average;
    result.maximum_energy = energies.maximum;
    result.quantiles = energy_quantiles(energies.faces, energies.areas);
    result.chart_of_face = Connected_parts(result.chart.opposites()).part;
    result.charts = chart_energies(energies.faces, energies.areas, result.chart_of_face);
    for(Trade_off& t : result.trade_offs) // the result is one of them
      if(t.cut_length == result.length && t.cut_cost == result.cost)
        t.average_distortion = result.average_energy;
    if(measures.has_thickened_faces())
      result.status.warnings.push_back(Finding{Status_code::OK, "the mean energy without the faces of (nearly) no area is "
                                                                  + std::to_string(energies.average_of_others),
                                               Element_kind::NONE, {}});
    const bool keeps_bound = result.average_energy <= m_context.parameters.maximum_average_distortion;
    Finding& finding = result.status.finding;
    const bool misses_proof = m_context.parameters.needs_optimal_tree && finding.code == Status_code::BOUND_NOT_REACHED;
    if((finding.code != Status_code::OK && finding.code != Status_code::BOUND_NOT_REACHED) || misses_proof)
      return;
    if(!keeps_bound)
      finding = bound_missed(result.average_energy, m_context.parameters.maximum_average_distortion).finding;
    else if(m_context.parameters.has_local_bounds())
      finding = Distortion_bounds(m_context.parameters)
                  .status(energies.faces, energies.areas, result.charts, result.chart_of_face).finding;
    else
      finding = Finding(); // even if a component alone misses the bound
  }

  const Indexed_mesh& m_mesh;
  const Round m_round;
  const Cutting_constraints& m_constraints;
  const Context m_context;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_MESH_CUTTER_H
