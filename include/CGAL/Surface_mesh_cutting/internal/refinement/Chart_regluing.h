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
#include <CGAL/Surface_mesh_parameterization/internal/chart/corner_uvs.h>

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using Surface_mesh_parameterization::internal::Connected_parts;

// A cut to one disk, and of each halfedge, where its source lies. The sides of a seam that was glued may lie apart.
struct Arrangement
{
  Cut cut;
  std::vector<Eigen::Vector2d> corners;
};

// Rearranges a disk whose flip-free map overlaps itself: a flap that lies on other parts is cut off and glued to another
// seam of the cut, which gains the neck of the flap and loses that seam. So it goes on as long as what overlaps becomes less by
// more than the cut becomes more expensive. Flaps move as they lie in the plane; what gluing distorts, a new map has to show.
class Chart_regluing
{
public:
  // The problem is kept as a reference.
  Chart_regluing(const Problem& problem, const Open_chart& overlapping) : m_problem(problem)
  {
    m_given.cut = overlapping.cut;
    m_given.corners = corner_uvs(overlapping.chart, overlapping.uv);
    const Corner_table chart = make_chart(problem.mesh, m_given.cut);
    if(is_disk(chart))
    {
      const std::vector<Eigen::Vector2d> uv = vertex_uvs(chart, m_given.corners);
      m_necks = Flap_search(problem, m_given.cut, chart, uv).necks();
    }
  }

  // `cost_of_overlap`: see `Flap_search`. What is mandatory, and the terminals, stay on the cut.
  Arrangement rearranged(double cost_of_overlap, const Go_further& go_further) const
  {
    constexpr int maximum_number_of_flaps = 12;
    Arrangement best = m_given, next = m_given;
    double least = std::numeric_limits<double>::infinity();
    for(int i = 0; i <= maximum_number_of_flaps && go_further(); ++i)
    {
      const Corner_table chart = make_chart(m_problem.mesh, next.cut);
      if(!is_disk(chart))
        return best;
      const std::vector<Eigen::Vector2d> uv = vertex_uvs(chart, next.corners);
      const Flap_search search(m_problem, next.cut, chart, uv);
      const double objective = cut_cost(m_problem.constraints, next.cut) + cost_of_overlap * search.overlap();
      if(!(objective < least)) // what was found does not keep what it seemed to
        return best;
      least = objective;
      best = next;
      Flap_move move;
      if(i == maximum_number_of_flaps || !search.find(i == 0 ? m_necks : search.necks(), cost_of_overlap, go_further, move))
        return best;
      apply(move, next);
    }
    return best;
  }

private:
  static bool is_disk(const Corner_table& chart) { return chart.border_loops().size() == 1; }

  void apply(const Flap_move& move, Arrangement& arrangement) const
  {
    for(int e : move.neck)
      arrangement.cut[e] = 1;
    const Connected_parts parts(make_chart(m_problem.mesh, arrangement.cut).opposites());
    for(int h = 0; h < int(arrangement.corners.size()); ++h)
      if(parts.part[h / 3] == parts.part[move.face])
        arrangement.corners[h] = move.motion(arrangement.corners[h]);
    for(int e : move.seam)
      arrangement.cut[e] = 0;
  }

  const Problem& m_problem;
  Arrangement m_given;
  std::vector<Neck> m_necks; // of flaps of the given one
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_REGLUING_H
