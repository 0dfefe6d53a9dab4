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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_REGLUING_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_REGLUING_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/mapping/Open_chart.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Flap_search.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Connected_parts.h>

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using Surface_mesh_parameterization::internal::Connected_parts;

// Rearranges a disk whose flip-free map overlaps itself: a flap that lies on other parts is cut off and glued to another
// seam of the cut, which gains the neck of the flap and loses that seam. So it goes on as long as what overlaps becomes less by
// more than the cut becomes more expensive. Flaps move as they lie in the plane; what gluing distorts, a new map has to show.
class Chart_regluing
{
public:
  // `cost_of_overlap`: see `Flap_search`. The problem is kept as a reference.
  Chart_regluing(const Problem& problem, const Open_chart& overlapping, double cost_of_overlap)
    : m_problem(problem), m_cut(overlapping.cut)
  {
    constexpr int maximum_number_of_flaps = 12;
    for(int h = 0; h < problem.mesh.number_of_halfedges(); ++h)
      m_corners.push_back(overlapping.uv[overlapping.chart.source(h)]);
    Cut cut = m_cut;
    std::vector<Eigen::Vector2d> corners = m_corners;
    double least = std::numeric_limits<double>::infinity();
    for(int i = 0; i <= maximum_number_of_flaps; ++i)
    {
      const Corner_table chart = make_chart(problem.mesh, cut);
      if(chart.border_loops().size() != 1) // not a disk
        return;
      const std::vector<Eigen::Vector2d> uv = positions(chart, corners);
      const Flap_search search(problem, cut, chart, uv, cost_of_overlap);
      const double objective = cut_cost(problem.constraints, cut) + search.overlap();
      if(!(objective < least)) // what was found does not keep what it seemed to
        return;
      least = objective;
      m_cut = cut;
      m_corners = corners;
      Flap_move move;
      if(i == maximum_number_of_flaps || !search.find(move))
        return;
      apply(move, cut, corners);
    }
  }

  // Leaves one disk, too. What is mandatory, and the terminals, stay on it.
  const Cut& cut() const { return m_cut; }

  // Of each halfedge, where its source lies; the sides of a seam that was glued may lie apart.
  const std::vector<Eigen::Vector2d>& corners() const { return m_corners; }

private:
  static std::vector<Eigen::Vector2d> positions(const Corner_table& chart, const std::vector<Eigen::Vector2d>& corners)
  {
    std::vector<Eigen::Vector2d> uv(chart.number_of_vertices());
    for(int h = 0; h < int(corners.size()); ++h)
      uv[chart.source(h)] = corners[h];
    return uv;
  }

  void apply(const Flap_move& move, Cut& cut, std::vector<Eigen::Vector2d>& corners) const
  {
    for(int e : move.neck)
      cut[e] = 1;
    const Connected_parts parts(make_chart(m_problem.mesh, cut).opposites());
    for(int h = 0; h < int(corners.size()); ++h)
      if(parts.part[h / 3] == parts.part[move.face])
        corners[h] = move.motion(corners[h]);
    for(int e : move.seam)
      cut[e] = 0;
  }

  const Problem& m_problem;
  Cut m_cut;
  std::vector<Eigen::Vector2d> m_corners; // of each halfedge, where its source lies
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_REGLUING_H
