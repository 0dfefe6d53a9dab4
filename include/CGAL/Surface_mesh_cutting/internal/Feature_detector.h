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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_FEATURE_DETECTOR_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_FEATURE_DETECTOR_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/Flat_status.h>
#include <CGAL/Surface_mesh_cutting/internal/Greedy_filter.h>
#include <CGAL/Surface_mesh_cutting/internal/Handle_loops.h>
#include <CGAL/Surface_mesh_cutting/internal/Initial_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/Phase_clock.h>
#include <CGAL/Surface_mesh_cutting/internal/connect_in_chart.h>

#include <algorithm>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

inline Flat_status failure(const Run_control& control)
{
  if(control.is_stopped())
    return stopped_status();
  return Flat_status(Status_code::NUMERICAL_FAILURE, "no valid map of the opened surface was found");
}

struct Detected_features
{
  Flat_status status;
  int number_of_candidates = 0;
  std::vector<int> features; // sorted, with the terminals
  Open_chart chart;          // opened along the paths that led to them
  std::vector<Trade_off> trade_offs;
};

// Candidates and filtering for one connected surface (paper, Section 3.1). A closed surface of genus
// 0 is treated as in the paper. Any other one is opened first, along loops that cut its handles
// and a tree that connects these and its borders; the same is done with a cut that was given. That
// leaves a disk, against which the candidates are judged.
template <typename ConcurrencyTag>
class Feature_detector
{
public:
  // The handles are cut by what is mandatory in the constraints, and some cut satisfies these
  // (`keep_one_island()`). The references are kept.
  Feature_detector(const Flat_mesh& mesh, const std::vector<Rest_shape>& shapes, bool is_sphere,
                   const Edge_constraints& constraints, const std::vector<int>& terminals,
                   const Initial_cut& initial, const Cutting_parameters& parameters, Run_control& control,
                   Phase_clock& clock)
    : m_mesh(mesh), m_shapes(shapes), m_is_sphere(is_sphere), m_constraints(constraints), m_terminals(terminals),
      m_initial(initial), m_parameters(parameters), m_control(control), m_clock(clock)
  {}

  // From the `i`-th start.
  Detected_features run(int i)
  {
    std::mt19937 engine(m_parameters.random_seed + 7919u * unsigned(i));
    const int start = int(engine() % std::mt19937::result_type(m_mesh.number_of_vertices()));
    Detected_features result;
    Cut opening;
    std::vector<Candidate> candidates = find(start, opening, result);
    if(result.status)
      filter(start, opening, std::move(candidates), result);
    return result;
  }

private:
  // Whether the first cut is to be found yet.
  bool is_closed() const { return m_is_sphere && !m_initial.is_given(); }

  std::vector<Candidate> find(int start, Cut& opening, Detected_features& result)
  {
    const Phase_clock::Measurement measurement(m_clock, Phase::CANDIDATES);
    m_control.report(Phase::CANDIDATES, 0);
    if(!is_closed())
    {
      const auto go_further = [this] { return m_control.go_further(); };
      Connected_cut connection
        = m_initial.is_given()
        ? m_initial.connected<ConcurrencyTag>(m_mesh, m_constraints, m_terminals, go_further)
        : connect_in_chart<ConcurrencyTag>(m_mesh, m_constraints, m_terminals, m_parameters.connection, go_further);
      result.status = connection.status;
      if(!result.status)
        return {};
      opening = std::move(connection.cut);
    }
    std::vector<Candidate> candidates
      = is_closed() ? find_candidates(m_mesh, m_shapes, start, m_parameters, m_control)
                    : find_candidates_of_disk(m_mesh, m_shapes, opening, m_parameters, m_control);
    result.number_of_candidates = int(candidates.size());
    if(m_control.is_stopped())
      result.status = failure(m_control);
    return candidates;
  }

  void filter(int start, const Cut& opening, std::vector<Candidate> candidates, Detected_features& result)
  {
    const Phase_clock::Measurement measurement(m_clock, Phase::FILTER);
    keep_connectable(candidates);
    if(is_closed())
      add_far_vertices(start, candidates);
    Greedy_filter<ConcurrencyTag> filter(m_mesh, m_shapes, m_constraints, m_terminals, m_parameters, m_control);
    if(is_closed() ? filter.run(candidates) : filter.run_on_disk(opening, candidates))
      result.features = filter.features();
    else
      result.status = failure(m_control);
    if(m_initial.is_given())
      add(ends_and_forks(m_mesh, opening), result.features);
    add(m_terminals, result.features);
    result.chart = filter.map().state();
    result.trade_offs = filter.trade_offs();
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
    if(is_closed())
      for(int v : m_terminals)
        candidates.push_back({v, std::numeric_limits<double>::infinity()});
  }

  static void add(const std::vector<int>& vertices, std::vector<int>& features)
  {
    features.insert(features.end(), vertices.begin(), vertices.end());
    std::sort(features.begin(), features.end());
    features.erase(std::unique(features.begin(), features.end()), features.end());
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

  const Flat_mesh& m_mesh;
  const std::vector<Rest_shape>& m_shapes;
  const bool m_is_sphere;
  const Edge_constraints& m_constraints;
  const std::vector<int>& m_terminals;
  const Initial_cut& m_initial;
  const Cutting_parameters& m_parameters;
  Run_control& m_control;
  Phase_clock& m_clock;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_FEATURE_DETECTOR_H
