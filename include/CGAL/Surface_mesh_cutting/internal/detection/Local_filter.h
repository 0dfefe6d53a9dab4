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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_LOCAL_FILTER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_LOCAL_FILTER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Trade_off.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Incremental_parameterization.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/local_maximizers.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Finds features on a disk that is a surface with many handles, opened. Each slit there changes a small part of the
// surface and next to nothing of the mean energy, which epsilon_iso is meant for: it has to gain what its cost is
// worth. Many slits are opened in each round, by what they gain around them, and the map converges once for all.
class Local_filter
{
public:
  // The references are kept.
  Local_filter(const Problem& problem, const Context& context)
    : m_mesh(problem.mesh), m_constraints(problem.constraints), m_parameters(context.parameters),
      m_control(context.control), m_paths(problem.mesh.graph()),
      m_map(problem.mesh, problem.shapes, mapping_policy(context.parameters), context.control)
  {}

  // False if no flip-free map was found or the run was stopped.
  bool run()
  {
    constexpr int maximum_number_of_rounds = 4; // later ones find little
    const Cut closed(m_mesh.number_of_edges(), 0);
    m_is_on_cut = open_vertices(m_mesh, closed);
    if(!m_map.initialize(closed))
      return false;
    record();
    for(int i = 0; i < maximum_number_of_rounds && !m_map.is_hopeless() && open_slits(); ++i)
    {
      m_map.converge();
      record();
    }
    std::sort(m_features.begin(), m_features.end());
    return !m_control.is_stopped();
  }

  const std::vector<int>& features() const { return m_features; }
  int number_of_candidates() const { return m_number_of_candidates; }
  // The cuts after each round.
  const std::vector<Trade_off>& trade_offs() const { return m_trade_offs; }

private:
  // False if there is none worth its cost.
  bool open_slits()
  {
    const std::vector<double> distortion = m_map.vertex_distortion();
    const std::vector<char> is_reachable = reachable_vertices(m_mesh, m_constraints);
    std::vector<std::pair<double, int> > candidates;
    for(int v : local_maximizers(m_mesh, distortion))
      if(!m_is_on_cut[v] && is_reachable[v])
        candidates.emplace_back(-distortion[v], v);
    std::sort(candidates.begin(), candidates.end());
    m_number_of_candidates = (std::max)(m_number_of_candidates, int(candidates.size()));
    const std::size_t before = m_features.size();
    for(const auto& candidate : candidates)
    {
      const std::vector<int> slit = path_to_cut(candidate.second);
      if(slit.empty() || !m_control.go_further() ||
         !m_map.open_if_locally_useful(slit, m_parameters.decrease_per_cost * total_cost(m_constraints, slit)))
        continue;
      m_features.push_back(candidate.second);
      for(int e : slit)
        for(int v : {m_mesh.source(m_mesh.halfedge(e)), m_mesh.target(m_mesh.halfedge(e))})
          m_is_on_cut[v] = 1;
    }
    return m_features.size() > before && m_control.go_further();
  }

  // Empty if `v` is on the cut by now, or if only forbidden edges lead there.
  std::vector<int> path_to_cut(int v)
  {
    int end = -1;
    m_paths.clear();
    m_paths.add_source(v);
    m_paths.run([&](int w)
                {
                  if(m_is_on_cut[w])
                    end = w;
                  return end < 0;
                },
                [this](int a) { return m_constraints.weights[m_mesh.graph().arcs[a].edge]; });
    std::vector<int> path;
    if(end >= 0)
      m_paths.path(end, std::back_inserter(path));
    return path;
  }

  void record()
  {
    m_trade_offs.push_back({cut_length(m_mesh, m_map.cut()), cut_cost(m_constraints, m_map.cut()), m_map.energy()});
  }

  const Indexed_mesh& m_mesh;
  const Edge_constraints& m_constraints;
  const Cutting_parameters& m_parameters;
  Run_control& m_control;
  Shortest_paths m_paths;
  Incremental_parameterization m_map;
  std::vector<char> m_is_on_cut; // per vertex
  std::vector<int> m_features;
  int m_number_of_candidates = 0;
  std::vector<Trade_off> m_trade_offs;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_LOCAL_FILTER_H
