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

#include <CGAL/Surface_mesh_cutting/internal/refinement/Neck_search.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Winding_rows.h>

#include <CGAL/Surface_mesh_parameterization/internal/bijective/Border_overlaps.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Connected_parts.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sort_by_key.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A motion of the plane that keeps distances.
struct Flap_motion
{
  double cosine = 1, sine = 0;
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();

  Eigen::Vector2d turned(const Eigen::Vector2d& p) const
  { return {cosine * p.x() - sine * p.y(), sine * p.x() + cosine * p.y()}; }

  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const { return turned(p) + shift; }
};

// The one that brings points nearest to others, in the sum of squares.
inline Flap_motion best_motion(const std::vector<Eigen::Vector2d>& from, const std::vector<Eigen::Vector2d>& to)
{
  Eigen::Vector2d p = Eigen::Vector2d::Zero(), q = Eigen::Vector2d::Zero();
  for(std::size_t i = 0; i < from.size(); ++i)
  {
    p += from[i] / double(from.size());
    q += to[i] / double(from.size());
  }
  Flap_motion motion;
  double cosine = 0, sine = 0;
  for(std::size_t i = 0; i < from.size(); ++i)
  {
    const Eigen::Vector2d u = from[i] - p, v = to[i] - q;
    cosine += u.dot(v);
    sine += u.x() * v.y() - u.y() * v.x();
  }
  const double norm = std::hypot(cosine, sine);
  if(norm > 0)
  {
    motion.cosine = cosine / norm;
    motion.sine = sine / norm;
  }
  motion.shift = q - motion.turned(p);
  return motion;
}

// What a flap is cut off along, and glued along elsewhere.
struct Flap_move
{
  std::vector<int> neck, seam; // edges
  int face = -1;               // of the flap
  Flap_motion motion;
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
    : m_problem(problem), m_cost_of_overlap(cost_of_overlap), m_cut(cut), m_is_terminal(problem.terminal_marks()), m_border(problem, chart, uv),
      m_crossings(Surface_mesh_parameterization::internal::Border_overlaps(
                    chart, Surface_mesh_parameterization::internal::Connected_parts(chart.opposites()), uv).crossings()),
      m_overlap(overlap(Neck(), Gluing(), std::numeric_limits<double>::infinity()))
  {}

  // What it may cost to get the border out of where it lies in several layers.
  double overlap() const { return m_overlap; }

  // False if no flap is worth its cost.
  bool find(Flap_move& move) const
  {
    if(m_crossings.empty())
      return false;
    const std::vector<Neck> necks = Neck_search(m_problem, m_cut, m_border, m_crossings)();
    std::vector<Gluing> gluings;
    for(int i = 0; i < int(necks.size()); ++i)
      add_gluings(i, necks[i], gluings);
    const Gluing best = best_of(std::move(gluings), necks);
    if(best.neck < 0)
      return false;
    const Neck& neck = necks[best.neck];
    move = {neck.edges, {}, m_border.halfedges[neck.from] / 3, best.motion};
    for(int i = best.first;; i = m_border.next(i))
    {
      move.seam.push_back(m_problem.mesh.edge(m_border.halfedges[i]));
      if(i == best.last)
        return true;
    }
  }

private:
  // Of a flap along the halfedges first..last of its border.
  struct Gluing
  {
    int neck = -1, first = -1, last = -1;
    double cost = 0; // added to the cut, and for what does not fit
    Flap_motion motion;
  };

  // That which leaves the least overlap and cost.
  Gluing best_of(std::vector<Gluing> gluings, const std::vector<Neck>& necks) const
  {
    constexpr int enough_segments = 3000000; // of borders that are looked at
    CGAL::internal::Graph_kernel::sort_by_key(gluings, [](const Gluing& gluing) { return gluing.cost; });
    gluings.resize((std::min)(gluings.size(), std::size_t(enough_segments / m_border.size())));
    Gluing best;
    double least = m_overlap;
    for(const Gluing& g : gluings)
    {
      if(g.cost >= least)
        break;
      const double objective = g.cost + overlap(necks[g.neck], g, least - g.cost);
      if(objective < least)
      {
        least = objective;
        best = g;
      }
    }
    return best;
  }

  // Along the runs of the flap's border that lie across from the rest of the disk, and along halves of them.
  void add_gluings(int number, const Neck& neck, std::vector<Gluing>& gluings) const
  {
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
      add_gluing(number, neck, first, i, gluings);
      if(length < 4)
        continue;
      const int middle = (first + length / 2) % m_border.size();
      add_gluing(number, neck, first, m_border.previous(middle), gluings);
      add_gluing(number, neck, middle, i, gluings);
    }
  }

  // Whether nothing else is cut, and no terminal lies, between two halfedges.
  bool is_run(int i, int next) const
  {
    return m_border.mates[next] == m_border.previous(m_border.mates[i]) &&
           !m_is_terminal[m_problem.mesh.source(m_border.halfedges[next])];
  }

  void add_gluing(int number, const Neck& neck, int first, int last, std::vector<Gluing>& gluings) const
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
    const Flap_motion motion = best_motion(moved, fixed);
    double squares = 0, length = 0;
    for(std::size_t i = 0; i < moved.size(); ++i)
    {
      squares += (motion(moved[i]) - fixed[i]).squaredNorm();
      if(i > 0)
        length += (fixed[i] - fixed[i - 1]).norm();
    }
    const double gap = std::sqrt(squares / double(moved.size()));
    if(gap <= largest_gap * length)
      gluings.push_back({number, first, last, neck.cost - cost + cost_of_gap * gap * (length > 0 ? cost / length : 0), motion});
  }

  // See above; once the flap is glued, or now, without one. If it is not less than `enough`, something between.
  double overlap(const Neck& neck, const Gluing& gluing, double enough) const
  {
    const int b = m_border.size(), flap_size = gluing.neck < 0 ? 0 : m_border.distance(neck.from, neck.to);
    std::vector<Winding_rows::Segment> segments;
    const auto point = [&](int i, bool is_moved) { return is_moved ? gluing.motion(m_border.points[i]) : m_border.points[i]; };
    std::vector<double> costs = m_border.costs;
    for(int i = 0; i < b; ++i)
    {
      const bool is_moved = flap_size > 0 && m_border.distance(neck.from, i) < flap_size;
      segments.push_back({point(i, is_moved), point(m_border.next(i), is_moved)});
    }
    if(flap_size > 0)
    {
      segments.push_back({point(neck.to, true), point(neck.from, true)});
      segments.push_back({point(neck.from, false), point(neck.to, false)});
      for(int i = gluing.first;; i = m_border.next(i))
      {
        costs[i] = costs[m_border.mates[i]] = 0; // inside of the disk then
        if(i == gluing.last)
          break;
      }
    }
    const Winding_rows layers(segments);
    double result = 0;
    for(int i = 0; i < b && result < enough; ++i)
      if(costs[i] > 0)
        result += m_cost_of_overlap * costs[i] * (std::max)(0, layers(inner_point(segments[i])) - 1);
    return result;
  }

  // Slightly to the left of the middle.
  static Vector2d inner_point(const Winding_rows::Segment& s)
  {
    constexpr double share = 0.01; // of the length
    const Vector2d along = s.target - s.source;
    return 0.5 * (s.source + s.target) + share * Vector2d(-along.y(), along.x());
  }

  const Problem& m_problem;
  const double m_cost_of_overlap;
  const Cut& m_cut;
  const std::vector<char> m_is_terminal;
  const Chart_border m_border;
  const std::vector<std::pair<int, int> > m_crossings;
  const double m_overlap;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_FLAP_SEARCH_H
