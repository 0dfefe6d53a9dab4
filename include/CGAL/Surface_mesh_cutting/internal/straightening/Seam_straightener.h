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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_STRAIGHTENING_SEAM_STRAIGHTENER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_STRAIGHTENING_SEAM_STRAIGHTENER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/context/work.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Incremental_parameterization.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/final_map.h>
#include <CGAL/Surface_mesh_cutting/internal/result/Component_result.h>
#include <CGAL/Surface_mesh_cutting/internal/straightening/straightened.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Topology.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Replaces ways of a mapped cut by straighter ones, if they leave a disk and its map has nearly the same energy. Where all of them
// are too many, it tries halves.
class Seam_straightener
{
public:
  // The references to the problem and to what the context holds are kept.
  Seam_straightener(const Problem& problem, const Context& context, Component_result& result)
    : m_problem(problem), m_context(context), m_result(result),
      m_map(problem.mesh, problem.shapes, mapping_policy(context.parameters), context.control), m_limit(limit())
  {}

  void run()
  {
    constexpr int solves = 8; // of the whole surface, for each map
    const double share = 0.01 * m_context.parameters.smoothness();
    if(!(share > 0) || !m_result.has_map || affordable_steps(m_problem.mesh.number_of_faces(), solves) == 0 ||
       Connected_parts(m_result.chart.opposites()).number > 1)
      return;
    std::vector<char> is_kept = m_problem.terminal_marks();
    for(const int v : m_result.features)
      is_kept[v] = 1;
    m_straightenings = straightenings(m_problem.mesh, m_problem.constraints, m_result.cut, is_kept, share);
    take(0, m_straightenings.size());
  }

private:
  // A cut that keeps the bound keeps it, and gains energy that nobody sees.
  double limit() const
  {
    constexpr double tolerance = 0.003;
    const double bound = m_context.parameters.maximum_average_distortion;
    return m_result.energy <= bound ? (std::min)(m_result.energy + tolerance, bound) : m_result.energy;
  }

  void take(std::size_t begin, std::size_t end)
  {
    if(begin == end || m_maps_left-- <= 0 || !m_context.control.go_further() || take_all(begin, end) || end - begin == 1)
      return;
    const std::size_t middle = (begin + end) / 2;
    take(begin, middle);
    take(middle, end);
  }

  // False if the map is not as good.
  bool take_all(std::size_t begin, std::size_t end)
  {
    Cut cut = m_result.cut;
    for(std::size_t i = begin; i < end; ++i)
      m_straightenings[i].apply_to(cut);
    if(make_chart(m_problem.mesh, cut).euler_characteristic() != 1)
      return false;
    Open_chart former;
    former.cut = m_result.cut;
    former.chart = m_result.chart;
    former.uv = m_result.uv;
    m_map.restore(std::move(former));
    if(!m_map.initialize(cut, m_limit))
      return false;
    std::vector<Eigen::Vector2d> uv;
    const Newton_result newton = final_map(m_problem, m_map.state(), m_context, uv);
    if(newton.outcome == Newton_outcome::FAILED || !(newton.energy <= m_limit))
      return false;
    m_result.is_optimal = false;
    m_result.cut = std::move(cut);
    m_result.chart = m_map.chart();
    m_result.uv = std::move(uv);
    m_result.energy = newton.energy;
    m_result.length = cut_length(m_problem.mesh, m_result.cut);
    m_result.cost = cut_cost(m_problem.constraints, m_result.cut);
    m_result.keep_undominated_trade_offs();
    return true;
  }

  const Problem& m_problem;
  const Context m_context;
  Component_result& m_result;
  Incremental_parameterization m_map; // that may overlap
  const double m_limit;
  std::vector<Straightening> m_straightenings;
  int m_maps_left = 7; // with quarters of the ways
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_STRAIGHTENING_SEAM_STRAIGHTENER_H
