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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_SEAM_GLUINGS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_SEAM_GLUINGS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Chart_border.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Neck_search.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/best_motion.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sort_by_key.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A flap, glued along the halfedges first..last of its border to their mates.
struct Gluing
{
  int first = -1, last = -1;
  double cost = 0; // added to the cut, and for what does not fit
  Rigid_motion motion;
};

// The seams of a cut along which a flap may be glued to the rest of its disk.
class Seam_gluings
{
  using Vector2d = Eigen::Vector2d;

public:
  // The references are kept.
  Seam_gluings(const Problem& problem, const Chart_border& border)
    : m_problem(problem), m_border(border), m_is_terminal(problem.terminal_marks())
  {}

  // Along the runs of the flap's border that lie across from the rest of the disk, and along halves of them; the cheapest
  // first. Linear in the border of the flap, but for sorting them.
  std::vector<Gluing> operator()(const Neck& neck) const
  {
    std::vector<Gluing> gluings;
    for(int i = neck.from; i != neck.to; i = m_border.next(i))
    {
      if(!faces_rest(neck, i))
        continue;
      const int first = i;
      int length = 1;
      for(int next = m_border.next(i); next != neck.to && faces_rest(neck, next) && is_run(i, next); next = m_border.next(i))
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

private:
  bool faces_rest(const Neck& neck, int i) const
  {
    return m_border.mates[i] >= 0 &&
           m_border.distance(neck.from, m_border.mates[i]) >= m_border.distance(neck.from, neck.to) &&
           !m_problem.constraints.mandatory[m_problem.mesh.edge(m_border.halfedges[i])];
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
  const Chart_border& m_border;
  const std::vector<char> m_is_terminal;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_SEAM_GLUINGS_H
