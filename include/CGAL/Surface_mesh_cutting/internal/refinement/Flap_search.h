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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_FLAP_SEARCH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_FLAP_SEARCH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Run_control.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Flap_layers.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Seam_gluings.h>

#include <CGAL/Surface_mesh_parameterization/internal/bijective/Border_overlaps.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Connected_parts.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// What a flap is cut off along, and glued along elsewhere.
struct Flap_move
{
  std::vector<int> neck, seam; // edges
  int face = -1;               // of the flap
  Rigid_motion motion;
};

// Looks for the flap of a disk to move so that what overlaps becomes less by most, against what that costs.
class Flap_search
{
public:
  // `chart`: the disk that `cut` leaves, mapped to `uv`. The references are kept.
  Flap_search(const Problem& problem, const Cut& cut, const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv)
    : m_problem(problem), m_cut(cut), m_chart(chart), m_uv(uv), m_border(problem, chart, uv), m_gluings(problem, m_border),
      m_overlap(Flap_layers(m_border, Neck()).least_overlap(-1, -1))
  {}

  // The length of the border where it lies in several layers, times the layers but the first.
  double overlap() const { return m_overlap; }

  // Of flaps that overlap the rest, the best first.
  std::vector<Neck> necks() const
  {
    using namespace Surface_mesh_parameterization::internal;
    const Border_overlaps overlaps(m_chart, Connected_parts(m_chart.opposites()), m_uv);
    if(overlaps.crossings().empty())
      return {};
    return Neck_search(m_problem, m_cut, m_border, overlaps.crossings())();
  }

  // `cost_of_overlap`: of getting a unit of length of the border out of where it lies in several layers, as slits do. False
  // if no flap is worth its cost.
  bool find(const std::vector<Neck>& necks, double cost_of_overlap, const Go_further& go_further, Flap_move& move) const
  {
    Gluing best;
    const Neck* best_neck = nullptr;
    double least = cost_of_overlap * m_overlap;
    int number_of_segments = 0;
    for(const Neck& neck : necks)
    {
      if(number_of_segments >= enough_segments || !go_further())
        break;
      if(improve(neck, cost_of_overlap, least, best, number_of_segments))
        best_neck = &neck;
    }
    if(!best_neck)
      return false;
    move = {best_neck->edges, {}, m_border.halfedges[best_neck->from] / 3, best.motion};
    for(int i = best.first;; i = m_border.next(i))
    {
      move.seam.push_back(m_problem.mesh.edge(m_border.halfedges[i]));
      if(i == best.last)
        return true;
    }
  }

private:
  static constexpr int enough_segments = 3000000; // of borders that are looked at

  // Takes the gluing of the flap that leaves less overlap and cost than `least`, if there is one.
  bool improve(const Neck& neck, double cost_of_overlap, double& least, Gluing& best, int& number_of_segments) const
  {
    const std::vector<Gluing> gluings = m_gluings(neck);
    if(gluings.empty() || gluings.front().cost >= least)
      return false;
    const Flap_layers layers(m_border, neck);
    number_of_segments += m_border.size();
    bool is_better = false;
    for(const Gluing& g : gluings)
    {
      if(g.cost >= least)
        break;
      if(g.cost + cost_of_overlap * layers.least_overlap(g.first, g.last) >= least)
        continue;
      number_of_segments += m_border.size();
      const double objective
        = g.cost + cost_of_overlap * layers.overlap(g.motion, g.first, g.last, (least - g.cost) / cost_of_overlap);
      if(objective < least)
      {
        least = objective;
        best = g;
        is_better = true;
      }
    }
    return is_better;
  }

  const Problem& m_problem;
  const Cut& m_cut;
  const Corner_table& m_chart;
  const std::vector<Eigen::Vector2d>& m_uv;
  const Chart_border m_border;
  const Seam_gluings m_gluings;
  const double m_overlap;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_FLAP_SEARCH_H
