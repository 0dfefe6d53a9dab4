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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_FEATURE_DETECTOR_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_FEATURE_DETECTOR_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/Greedy_filter.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/connection/connect_terminals.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <algorithm>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

struct Detected_features
{
  Indexed_status status;
  int number_of_candidates = 0;
  std::vector<int> features; // sorted, with the terminals
  Open_chart chart;          // opened along the paths that led to them; empty if found on a coarser version
  std::vector<Trade_off> trade_offs;
  // Whether their map has so much distortion that no cut seems to lead to a useful one.
  bool is_hopeless = false;
};

// Candidates and filtering for one connected surface (paper, Section 3.1). A closed surface of genus
// 0 is treated as in the paper. Any other one is opened first, along loops that cut its handles
// and a tree that connects these and its borders; the same is done with a cut that was given. That
// leaves a disk, against which the candidates are judged.
class Feature_detector
{
public:
  // The references are kept.
  Feature_detector(const Problem& problem, const Context& context)
    : m_problem(problem), m_mesh(problem.mesh), m_parameters(context.parameters), m_context(context),
      m_control(context.control)
  {}

  Detected_features run()
  {
    std::mt19937 engine(m_parameters.random_seed);
    const int start = int(engine() % std::mt19937::result_type(m_mesh.number_of_vertices()));
    Detected_features result;
    Cut opening;
    std::vector<Candidate> candidates = find(start, opening, result);
    if(result.status)
      filter(start, opening, std::move(candidates), result);
    result.is_hopeless = !result.trade_offs.empty() && result.trade_offs.back().average_distortion > hopeless_energy;
    return result;
  }

private:
  // Whether the first cut is to be found yet.
  bool is_closed() const { return m_problem.is_sphere && !m_problem.initial.is_given(); }

  std::vector<Candidate> find(int start, Cut& opening, Detected_features& result)
  {
    const Phase_clock::Measurement measurement(m_context.clock, Phase::CANDIDATES);
    m_control.report(Phase::CANDIDATES, 0);
    if(!is_closed())
    {
      Connected_cut connection
        = m_problem.initial.is_given()
        ? m_problem.initial.connected(m_mesh, m_problem.constraints, m_problem.terminals, m_context.execution, m_control)
        : connect_terminals(m_mesh, m_problem.constraints, m_problem.terminals, m_parameters.connection,
                                            m_context.execution, m_control);
      result.status = connection.status;
      if(!result.status)
        return {};
      opening = std::move(connection.cut);
    }
    std::vector<Candidate> candidates
      = is_closed() ? find_candidates(m_mesh, m_problem.shapes, start, m_parameters, m_control)
                    : find_candidates_of_disk(m_mesh, m_problem.shapes, opening, m_parameters, m_control);
    result.number_of_candidates = int(candidates.size());
    if(m_control.is_stopped())
      result.status = failure(m_control);
    return candidates;
  }

  void filter(int start, const Cut& opening, std::vector<Candidate> candidates, Detected_features& result)
  {
    const Phase_clock::Measurement measurement(m_context.clock, Phase::FILTER);
    keep_connectable(candidates);
    if(is_closed())
      add_far_vertices(start, candidates);
    Greedy_filter filter(m_problem, m_context);
    if(is_closed() ? filter.run(candidates) : filter.run_on_disk(opening, candidates))
      result.features = filter.features();
    else
      result.status = failure(m_control);
    if(m_problem.initial.is_given())
      CGAL::internal::Graph_kernel::add_unique(ends_and_forks(m_mesh, opening), result.features);
    CGAL::internal::Graph_kernel::add_unique(m_problem.terminals, result.features);
    result.chart = filter.map().state();
    result.trade_offs = filter.trade_offs();
  }

  // Drops candidates that only forbidden edges lead to. Terminals are candidates of infinite scope on a
  // sphere; on other surfaces, they are connected from the outset.
  void keep_connectable(std::vector<Candidate>& candidates) const
  {
    std::vector<char> is_kept = reachable_vertices(m_mesh, m_problem.constraints);
    for(int v : m_problem.terminals)
      is_kept[v] = 0;
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                    [&](const Candidate& c) { return !is_kept[c.vertex]; }),
                     candidates.end());
    if(is_closed())
      for(int v : m_problem.terminals)
        candidates.push_back({v, std::numeric_limits<double>::infinity()});
  }

  // A surface as even as a sphere may have a single maximizer, or none where the map failed; a cut
  // needs two ends.
  void add_far_vertices(int start, std::vector<Candidate>& candidates) const
  {
    if(candidates.size() >= 2)
      return;
    const Cut allowed = allowed_edges(m_mesh, m_problem.constraints);
    const std::vector<char> is_reachable = reachable_vertices(m_mesh, m_problem.constraints);
    if(!is_reachable[start])
      start = int(std::find(is_reachable.begin(), is_reachable.end(), char(1)) - is_reachable.begin());
    Shortest_paths paths(m_mesh.graph());
    const int one_end = candidates.empty() ? farthest_vertex(m_mesh, paths, start, allowed)
                                           : candidates.front().vertex;
    const int other_end = farthest_vertex(m_mesh, paths, one_end, allowed);
    const double infinity = std::numeric_limits<double>::infinity();
    candidates = {{one_end, infinity}, {other_end, infinity}};
  }

  const Problem& m_problem;
  const Indexed_mesh& m_mesh;
  const Cutting_parameters& m_parameters;
  const Context m_context;
  Run_control& m_control;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_FEATURE_DETECTOR_H
