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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_OFF_GRID_GROWTH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_OFF_GRID_GROWTH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Effort.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Run_control.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Chart_separator.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Joint_growth.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Packed_charts.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Packing_random.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Raises the common scale of charts that lie apart in the unit square, as long as a number of lookups of distances
// allows. All grow together until they are jammed; then they are separated at scales slightly too large for the way in
// which they lie, which finds another way.
class Off_grid_growth
{
public:
  static constexpr double tolerance = 2e-4; // of the outlines of `charts`

  // Up to which distance the fields of charts that start at `scale` are asked for.
  static double reach(double margin, double scale) { return margin / scale + 4 * tolerance; }

  // References are kept. `limit`: of the scale.
  Off_grid_growth(const std::vector<Rigid_chart>& charts, double margin, double limit, Effort effort, Run_control& control)
    : m_charts(charts), m_margin(margin), m_limit(limit), m_effort(effort), m_control(control), m_separator(charts),
      m_joint_growth(charts, control), m_random(0)
  {
    for(int i = 0; i < int(charts.size()); ++i)
    {
      m_kinds.push_back(0);
      while(!are_alike(charts[m_kinds.back()], charts[i]))
        ++m_kinds.back();
    }
  }

  Packed_charts grow(Packed_charts packed)
  {
    m_scale = packed.scale;
    m_motions = rigid_motions(packed.motions);
    grow_jointly();
    search();
    return {m_scale, chart_motions()};
  }

private:
  // Grows by small steps. Where the smallest one fails, two charts change places before the next attempt; few charts have few
  // places to change. It ends where it has not grown for a share of the budget.
  void search()
  {
    constexpr double first = 1.02, finest = 1.0015, quick = 0.02, patience = 0.3;
    constexpr int changes_per_chart = 4;
    const double budget = most_lookups();
    double last = lookups(); // when it grew
    bool is_stuck = false;
    int changes = 0; // that did not help
    double factor = first;
    while(m_scale * finest <= m_limit && lookups() < (std::min)(budget, last + patience * budget) &&
          changes < changes_per_chart * int(m_charts.size()) && m_control.go_further())
    {
      const double former = lookups();
      const double scale = (std::min)(m_scale * factor, m_limit);
      std::vector<Rigid_motion> motions = narrowed(m_motions, room_at(scale).side / room_at(m_scale).side);
      if(is_stuck)
      {
        swap_two(motions);
        ++changes;
      }
      is_stuck = false;
      const long long end = m_separator.lookups() + (long long)(budget - former);
      if(m_separator.separate(motions, room_at(scale), end, m_control))
      {
        m_scale = scale;
        m_motions.swap(motions);
        changes = 0;
        if(lookups() - former < quick * budget)
          factor = (std::min)(first, factor * factor);
        grow_jointly();
        last = lookups();
      }
      else
      {
        is_stuck = factor == finest;
        if(is_stuck && !has_kinds())
          return;
        factor = (std::max)(finest, std::sqrt(factor));
      }
    }
  }

  // Few charts need more attempts each. Many charts take longer for each lookup: all pairs are asked whether they can meet.
  double most_lookups() const
  {
    constexpr double lookups_per_chart = 2.7e6;
    constexpr double fast_share = 0.1, best_share = 4;
    constexpr int few = 4, several = 40, many = 100;
    const int number = int(m_charts.size());
    const double share = m_effort == Effort::FAST ? fast_share : m_effort == Effort::BEST ? best_share : 1;
    const double most = share * lookups_per_chart * (std::min)((std::max)(number, few), several);
    return number > many ? most * 2 / 3 : most;
  }

  double lookups() const { return double(m_separator.lookups() + m_joint_growth.lookups()); }

  void grow_jointly()
  {
    const long long enough = (long long)(most_lookups()) - m_separator.lookups();
    m_scale = m_joint_growth.grow(m_motions, m_scale, m_limit, enough, [this](double scale) { return room_at(scale); });
  }

  // In units of the charts.
  Square_room room_at(double scale) const
  { return {(1 - 2 * m_margin) / scale - 2 * tolerance, m_margin / scale + 2 * tolerance, tolerance}; }

  // Of that room.
  Eigen::Vector2d corner(double scale) const { return Eigen::Vector2d::Constant(m_margin + tolerance * scale); }

  std::vector<Rigid_motion> rigid_motions(const std::vector<Chart_motion>& motions) const
  {
    std::vector<Rigid_motion> rigid;
    for(const Chart_motion& motion : motions)
      rigid.emplace_back(motion.angle, (motion.translation - corner(m_scale)) / m_scale);
    return rigid;
  }

  std::vector<Chart_motion> chart_motions() const
  {
    std::vector<Chart_motion> motions;
    for(const Rigid_motion& motion : m_motions)
      motions.push_back({motion.angle(), corner(m_scale) + m_scale * motion.translation()});
    return motions;
  }

  // As far as it is known without a comparison of their outlines.
  static bool are_alike(const Rigid_chart& chart, const Rigid_chart& other)
  {
    return std::abs(chart.radius - other.radius) <= tolerance && chart.outline.size() == other.outline.size() &&
           std::abs(chart.perimeter - other.perimeter) <= tolerance;
  }

  bool has_kinds() const { return *std::max_element(m_kinds.begin(), m_kinds.end()) > 0; }

  // The larger one of two charts takes the place of any other one of another kind: large charts decide what is possible.
  void swap_two(std::vector<Rigid_motion>& motions)
  {
    const int number = int(m_charts.size()), first = m_random.below(number), second = m_random.below(number);
    const int i = m_charts[first].radius > m_charts[second].radius ? first : second;
    int j = (i + 1 + m_random.below(number - 1)) % number;
    while(m_kinds[i] == m_kinds[j])
      j = (j + 1) % number;
    const Rigid_motion former = motions[i];
    motions[i] = Rigid_motion(former.angle(), motions[j].translation());
    motions[j] = Rigid_motion(motions[j].angle(), former.translation());
  }

  const std::vector<Rigid_chart>& m_charts;
  const double m_margin, m_limit;
  const Effort m_effort;
  Run_control& m_control;
  Chart_separator m_separator;
  Joint_growth m_joint_growth;
  Packing_random m_random;
  double m_scale = 0;
  std::vector<int> m_kinds;            // of charts: the first chart that is alike
  std::vector<Rigid_motion> m_motions; // in the room at that scale
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_OFF_GRID_GROWTH_H
