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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_INJECTIVE_TRIMMER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_INJECTIVE_TRIMMER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/context/work.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/final_map.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Branch_removal_search.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Injective_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Objective.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Closes branches of a cut, or their outer parts, as long as the map without overlaps keeps a bound. Slits that made
// room for it gained in whole paths, and have lowered the distortion where other branches did before. Each part that is
// tried is closed, and the surface mapped anew.
class Injective_trimmer
{
public:
  // The references to the problem and to what the context holds are kept.
  Injective_trimmer(const Problem& problem, const Context& context)
    : m_problem(problem), m_context(context),
      m_map(problem.mesh, problem.shapes, mapping_policy(context.parameters), context.control),
      m_parts(problem.mesh, problem.constraints), m_is_kept(problem.terminal_marks())
  {}

  // The cut keeps the bound before and afterwards.
  void trim(const Objective& objective, Injective_cut& cut)
  {
    const double least = m_context.parameters.least_removal();
    const auto allowed_energy = [&](double cost) { return cost < least ? 0 : objective.largest_energy(cut.map.energy, cost) - cut.map.energy; };
    int parts_left = maximum_number_of_parts();
    if(parts_left == 0 || !m_map.initialize(cut.cut))
      return;
    while(parts_left-- > 0 && m_context.control.go_further())
    {
      const Branch_removal part = m_parts.best(m_map, cut.ends, m_is_kept, allowed_energy);
      if(part.tip < 0)
        return;
      Open_chart former = m_map.state();
      const double bound = objective.largest_energy(cut.map.energy, part.cost);
      Injective_cut shorter = closed(part, bound, cut);
      m_parts.remember(part, shorter.map.energy - cut.map.energy);
      if(shorter.map.energy <= bound)
        cut = std::move(shorter);
      else
        m_map.restore(std::move(former));
    }
  }

private:
  int maximum_number_of_parts() const
  {
    constexpr int solves = 8; // of the whole surface, for each part: with and without overlaps
    return affordable_steps(m_problem.mesh.number_of_faces(), solves);
  }

  // Without the part. If its energy is above the bound even where parts of the chart may overlap, then that one, as far as
  // it was followed: how much is missing tells whether less of the part can be closed.
  Injective_cut closed(const Branch_removal& part, double bound, const Injective_cut& cut)
  {
    Injective_cut result;
    result.map.energy = std::numeric_limits<double>::infinity();
    result.cut = cut.cut;
    for(int e : part.edges)
      result.cut[e] = 0;
    std::remove_copy(cut.ends.begin(), cut.ends.end(), std::back_inserter(result.ends), part.tip);
    if(part.new_tip >= 0)
      result.ends.push_back(part.new_tip);
    if(!m_map.initialize(result.cut, bound))
    {
      if(m_map.energy() > bound)
        result.map.energy = m_map.energy();
      return result;
    }
    const Newton_result newton = final_map(m_problem, m_map.state(), m_context, result.map.uv);
    if(newton.outcome != Newton_outcome::FAILED)
      result.map.energy = newton.energy;
    result.chart = m_map.chart();
    return result;
  }

  const Problem& m_problem;
  const Context m_context;
  Incremental_parameterization m_map; // that may overlap
  Branch_removal_search m_parts;
  const std::vector<char> m_is_kept; // per vertex, whether a branch that ends there stays
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_INJECTIVE_TRIMMER_H
