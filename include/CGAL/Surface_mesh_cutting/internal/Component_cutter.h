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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_COMPONENT_CUTTER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_COMPONENT_CUTTER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Effort.h>
#include <CGAL/Surface_mesh_cutting/internal/Flat_component.h>
#include <CGAL/Surface_mesh_cutting/internal/Flat_status.h>
#include <CGAL/Surface_mesh_cutting/internal/Greedy_filter.h>
#include <CGAL/Surface_mesh_cutting/internal/Handle_loops.h>
#include <CGAL/Surface_mesh_cutting/internal/Phase_clock.h>
#include <CGAL/Surface_mesh_cutting/internal/connect_in_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/bijective_map.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// What is known about one component of the surface after a run.
struct Component_result
{
  Flat_status status;
  int candidates = 0, auxiliary = 0;
  std::vector<int> features;
  Cut cut;
  double length = 0, lower_bound = 0;
  bool is_optimal = false;
  Chart chart;
  std::vector<Eigen::Vector2d> uv;
  double energy = 0;
};

// The whole method for one connected surface: candidates, filtering, connection and, if asked for, UVs
// (paper, Section 3). A closed surface of genus 0 is treated as in the paper. Any other one is opened
// first, along loops that cut its handles and a tree that connects these and its borders: that leaves
// a disk, against which the candidates are judged. The final cut keeps the loops and connects
// everything anew.
template <typename LinearSolver, typename ConcurrencyTag>
class Component_cutter
{
public:
  // Nothing is mandatory, and some cut satisfies the constraints (`keep_one_island()`).
  Component_cutter(const Flat_component& component, const Edge_constraints& constraints,
                   const std::vector<int>& terminals, const Cutting_parameters& parameters,
                   Run_control& control, Phase_clock& clock)
    : m_mesh(component.mesh), m_topology(component.topology), m_parameters(parameters), m_control(control), m_clock(clock),
      m_shapes(Surface_mesh_parameterization::internal::rest_shapes(m_mesh.triangles(), m_mesh.points())),
      m_constraints(constraints), m_terminals(terminals)
  {}

  Component_result detect()
  {
    Component_result result;
    detect_features(random_start(0), result);
    return result;
  }

  // Runs from as many starts as the parameters say. The best is the shortest of those whose energy
  // is within epsilon_iso of the lowest.
  Component_result run(bool needs_uv)
  {
    const bool needs_energy = needs_uv || m_parameters.number_of_starts > 1;
    std::vector<Component_result> results;
    double lowest = std::numeric_limits<double>::infinity();
    for(int i = 0; i < m_parameters.number_of_starts; ++i)
    {
      results.push_back(run_from(random_start(i), needs_energy));
      if(!results.back().status)
        return results.back();
      lowest = (std::min)(lowest, results.back().energy);
    }
    const Component_result* best = nullptr;
    for(const Component_result& r : results)
      if(r.energy <= lowest + m_parameters.minimum_distortion_decrease &&
         (best == nullptr || r.length < best->length))
        best = &r;
    return *best;
  }

private:
  int random_start(int i) const
  {
    std::mt19937 engine(m_parameters.random_seed + 7919u * unsigned(i));
    return int(engine() % std::mt19937::result_type(m_mesh.number_of_vertices()));
  }

  Component_result run_from(int start, bool needs_uv)
  {
    Component_result result;
    detect_features(start, result);
    if(result.status)
      connect(result);
    if(result.status && needs_uv)
      parameterize(result);
    return result;
  }

  bool is_sphere() const { return m_topology.genus() == 0 && m_topology.border_loops == 0; }

  Flat_status failure() const
  {
    if(m_control.is_stopped())
      return Flat_status(Status_code::STOPPED, "the visitor ended the run");
    return Flat_status(Status_code::NUMERICAL_FAILURE, "no valid map of the opened surface was found");
  }

  void detect_features(int start, Component_result& result)
  {
    Cut opening;
    std::vector<Candidate> candidates;
    {
      const Phase_clock::Measurement measurement(m_clock, Phase::CANDIDATES);
      m_control.report(Phase::CANDIDATES, 0);
      if(!is_sphere())
      {
        result.status = open_to_disk(opening);
        if(!result.status)
          return;
      }
      candidates = is_sphere() ? find_candidates<LinearSolver>(m_mesh, m_shapes, start, m_parameters, m_control)
                               : find_candidates_of_disk<LinearSolver>(m_mesh, m_shapes, opening, m_parameters, m_control);
      result.candidates = int(candidates.size());
    }
    if(m_control.is_stopped())
    {
      result.status = failure();
      return;
    }
    const Phase_clock::Measurement measurement(m_clock, Phase::FILTER);
    keep_connectable(candidates);
    if(is_sphere())
      add_far_vertices(start, candidates);
    Greedy_filter<LinearSolver> filter(m_mesh, m_shapes, m_constraints, m_terminals, m_parameters, m_control);
    if(is_sphere() ? filter.run(candidates) : filter.run_on_disk(opening, candidates))
      result.features = with_terminals(filter.features());
    else
      result.status = failure();
  }

  // Cuts the handles, which is final, and connects the borders, which is not.
  Flat_status open_to_disk(Cut& opening)
  {
    const Handle_loops handles = cut_handles(m_mesh, m_constraints);
    if(!handles.status)
      return handles.status;
    m_constraints.mandatory = handles.cut;
    const Connected_cut connection = connect_points(m_terminals);
    opening = connection.cut;
    return connection.status;
  }

  Connected_cut connect_points(const std::vector<int>& points)
  {
    return connect_in_chart<ConcurrencyTag>(m_mesh, m_constraints, points, m_parameters.connection,
                                            [this] { return m_control.go_further(); });
  }

  // Drops candidates that only forbidden edges lead to. Terminals are candidates of infinite scope on a
  // sphere; on other surfaces, they are connected from the outset.
  void keep_connectable(std::vector<Candidate>& candidates) const
  {
    std::vector<char> is_kept = reachable_vertices(m_mesh, m_constraints);
    for(int v : m_terminals)
      is_kept[v] = 0;
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                    [&](const Candidate& c) { return !is_kept[c.vertex]; }),
                     candidates.end());
    if(is_sphere())
      for(int v : m_terminals)
        candidates.push_back({v, std::numeric_limits<double>::infinity()});
  }

  std::vector<int> with_terminals(std::vector<int> features) const
  {
    features.insert(features.end(), m_terminals.begin(), m_terminals.end());
    std::sort(features.begin(), features.end());
    features.erase(std::unique(features.begin(), features.end()), features.end());
    return features;
  }

  // A surface as even as a sphere may have a single maximizer, or none where the map failed; a cut
  // needs two ends.
  void add_far_vertices(int start, std::vector<Candidate>& candidates) const
  {
    if(candidates.size() >= 2)
      return;
    const Cut allowed = allowed_edges(m_mesh, m_constraints);
    const std::vector<char> is_reachable = reachable_vertices(m_mesh, m_constraints);
    if(!is_reachable[start])
      start = int(std::find(is_reachable.begin(), is_reachable.end(), char(1)) - is_reachable.begin());
    Shortest_paths paths(m_mesh.graph());
    const int one_end = candidates.empty() ? farthest_vertex(m_mesh, paths, start, allowed)
                                           : candidates.front().vertex;
    const int other_end = farthest_vertex(m_mesh, paths, one_end, allowed);
    const double infinity = std::numeric_limits<double>::infinity();
    candidates = {{one_end, infinity}, {other_end, infinity}};
  }

  void connect(Component_result& result)
  {
    const Phase_clock::Measurement measurement(m_clock, Phase::CONNECT);
    m_control.report(Phase::CONNECT, 0);
    const Connected_cut connection = connect_points(result.features);
    if(m_control.is_stopped() || !connection.status)
    {
      result.status = m_control.is_stopped() ? failure() : connection.status;
      return;
    }
    result.cut = connection.cut;
    result.length = cut_length(m_mesh, result.cut);
    result.lower_bound = connection.lower_bound + cut_length(m_mesh, m_constraints.mandatory);
    result.is_optimal = connection.is_optimal;
    result.auxiliary = connection.number_of_auxiliary_points;
    m_control.report(Phase::CONNECT, 1);
  }

  void parameterize(Component_result& result)
  {
    const Phase_clock::Measurement measurement(m_clock, Phase::PARAMETERIZE);
    m_control.report(Phase::PARAMETERIZE, 0);
    result.chart = make_chart(m_mesh, result.cut);
    Newton_options options;
    options.stop = [this](const Newton_state&) { return !m_control.go_further(); };
    const Newton_result newton = final_map(result.chart, result.uv, options);
    result.energy = newton.energy;
    if(newton.outcome == Newton_outcome::FAILED || m_control.is_stopped())
      result.status = failure();
    m_control.report(Phase::PARAMETERIZE, 1);
  }

  Newton_result final_map(const Chart& chart, std::vector<Eigen::Vector2d>& uv,
                          const Newton_options& options) const
  {
    const std::vector<Eigen::Vector3d> points = chart_points(m_mesh, chart);
    if(m_parameters.do_bijective)
      return Surface_mesh_parameterization::internal::bijective_map<LinearSolver>(chart, points, m_shapes,
                                                                                  uv, options);
    return Chart_parameterizer<LinearSolver>(chart, points, m_shapes).isometric_map(uv, options);
  }

  const Flat_mesh& m_mesh;
  const Topology m_topology;
  const Cutting_parameters& m_parameters;
  Run_control& m_control;
  Phase_clock& m_clock;
  const std::vector<Rest_shape> m_shapes;
  Edge_constraints m_constraints;
  const std::vector<int> m_terminals;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_COMPONENT_CUTTER_H
