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

#include <CGAL/Surface_mesh_cutting/internal/refinement/Flap_layers.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/best_motion.h>

#include <CGAL/Surface_mesh_parameterization/internal/bijective/Border_overlaps.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Connected_parts.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sort_by_key.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
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
  using Vector2d = Eigen::Vector2d;

public:
  // `chart`: the disk that `cut` leaves, mapped to `uv`; `cost_of_overlap`: of getting the border out of where it lies in
  // several layers, relative to what that border costs. The references are kept.
  Flap_search(const Problem& problem, const Cut& cut, const Corner_table& chart, const std::vector<Vector2d>& uv,
              double cost_of_overlap)
    : m_problem(problem), m_cut(cut), m_chart(chart), m_uv(uv), m_cost_of_overlap(cost_of_overlap),
      m_is_terminal(problem.terminal_marks()), m_border(problem, chart, uv),
      m_overlap(cost_of_overlap * Flap_layers(m_border, Neck()).least_overlap(-1, -1))
  {}

  // What it may cost to get the border out of where it lies in several layers.
  double overlap() const { return m_overlap; }

  // False if no flap is worth its cost.
  bool find(Flap_move& move) const
  {
    using namespace Surface_mesh_parameterization::internal;
    const Border_overlaps overlaps(m_chart, Connected_parts(m_chart.opposites()), m_uv);
    if(overlaps.crossings().empty())
      return false;
    Gluing best;
    Neck best_neck;
    double least = m_overlap;
    int number_of_segments = 0;
    for(const Neck& neck : Neck_search(m_problem, m_cut, m_border, overlaps.crossings())())
      if(number_of_segments < enough_segments && improve(neck, least, best, number_of_segments))
        best_neck = neck;
    if(best_neck.from < 0)
      return false;
    move = {best_neck.edges, {}, m_border.halfedges[best_neck.from] / 3, best.motion};
    for(int i = best.first;; i = m_border.next(i))
    {
      move.seam.push_back(m_problem.mesh.edge(m_border.halfedges[i]));
      if(i == best.last)
        return true;
    }
  }

private:
  static constexpr int enough_segments = 3000000; // of borders that are looked at

  // Of a flap along the halfedges first..last of its border.
  struct Gluing
  {
    int first = -1, last = -1;
    double cost = 0; // added to the cut, and for what does not fit
    Rigid_motion motion;
  };

  // Takes the gluing of the flap that leaves less overlap and cost than `least`, if there is one.
  bool improve(const Neck& neck, double& least, Gluing& best, int& number_of_segments) const
  {
    std::vector<Gluing> gluings = gluings_of(neck);
    if(gluings.empty() || gluings.front().cost >= least)
      return false;
    const Flap_layers layers(m_border, neck);
    number_of_segments += m_border.size();
    bool is_better = false;
    for(const Gluing& g : gluings)
    {
      if(g.cost >= least)
        break;
      if(g.cost + m_cost_of_overlap * layers.least_overlap(g.first, g.last) >= least)
        continue;
      number_of_segments += m_border.size();
      const double objective
        = g.cost + m_cost_of_overlap * layers.overlap(g.motion, g.first, g.last, (least - g.cost) / m_cost_of_overlap);
      if(objective < least)
      {
        least = objective;
        best = g;
        is_better = true;
      }
    }
    return is_better;
  }

  // Along the runs of the flap's border that lie across from the rest of the disk, and along halves of them; the cheapest
  // first.
  std::vector<Gluing> gluings_of(const Neck& neck) const
  {
    std::vector<Gluing> gluings;
    const int size = m_border.distance(neck.from, neck.to);
    const auto faces_rest = [&](int i)
    {
      return m_border.mates[i] >= 0 && m_border.distance(neck.from, m_border.mates[i]) >= size &&
             !m_problem.constraints.mandatory[m_problem.mesh.edge(m_border.halfedges[i])];
    };
    for(int i = neck.from; i != neck.to; i = m_border.next(i))
    {
      if(!faces_rest(i))
        continue;
      const int first = i;
      int length = 1;
      for(int next = m_border.next(i); next != neck.to && faces_rest(next) && is_run(i, next); next = m_border.next(i))
      {
        i = next;
        ++length;
      }
      add_gluing(neck, first, i, gluings);
      if(length < 4)
        continue;
      const int middle = (first + length / 2) % m_border.size();
      add_gluing(neck, first, m_border.previous(middle), gluings);
      add_gluing(neck, middle, i, gluings);
    }
    CGAL::internal::Graph_kernel::sort_by_key(gluings, [](const Gluing& gluing) { return gluing.cost; });
    return gluings;
  }

  // Whether nothing else is cut, and no terminal lies, between two halfedges.
  bool is_run(int i, int next) const
  {
    return m_border.mates[next] == m_border.previous(m_border.mates[i]) &&
           !m_is_terminal[m_problem.mesh.source(m_border.halfedges[next])];
  }

  void add_gluing(const Neck& neck, int first, int last, std::vector<Gluing>& gluings) const
  {
    constexpr double largest_gap = 0.15; // of the seam; beyond, its sides are bent too differently
    constexpr double cost_of_gap = 4;
    std::vector<Vector2d> moved(1, m_border.points[first]);
    std::vector<Vector2d> fixed(1, m_border.points[m_border.next(m_border.mates[first])]);
    double cost = 0;
    for(int i = first;; i = m_border.next(i))
    {
      moved.push_back(m_border.points[m_border.next(i)]);
      fixed.push_back(m_border.points[m_border.mates[i]]);
      cost += m_border.costs[i];
      if(i == last)
        break;
    }
    const Rigid_motion motion = best_motion(moved, fixed);
    double squares = 0, length = 0;
    for(std::size_t i = 0; i < moved.size(); ++i)
    {
      squares += (motion(moved[i]) - fixed[i]).squaredNorm();
      if(i > 0)
        length += (fixed[i] - fixed[i - 1]).norm();
    }
    const double gap = std::sqrt(squares / double(moved.size()));
    if(gap <= largest_gap * length)
      gluings.push_back({first, last, neck.cost - cost + cost_of_gap * gap * (length > 0 ? cost / length : 0), motion});
  }

  const Problem& m_problem;
  const Cut& m_cut;
  const Corner_table& m_chart;
  const std::vector<Vector2d>& m_uv;
  const double m_cost_of_overlap;
  const std::vector<char> m_is_terminal;
  const Chart_border m_border;
  const double m_overlap;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_FLAP_SEARCH_H
