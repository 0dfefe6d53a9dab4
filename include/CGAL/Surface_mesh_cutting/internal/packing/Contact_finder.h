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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CONTACT_FINDER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CONTACT_FINDER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/Rigid_chart.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// What charts are to keep in a square.
struct Square_room
{
  double side;
  double distance; // between charts
  double slack;    // aimed at in addition, since steps approach what they aim at
};

// Where a chart is too close to another one or to the border of the square.
struct Contact
{
  Eigen::Vector2d point, normal; // along which the chart has to move
  double depth;

  // By how much a chart with that center moves along the normal, for its translation and for a turn, which is measured
  // as a length at the end of a lever.
  Eigen::Vector3d direction(const Eigen::Vector2d& center, double lever) const
  {
    const Eigen::Vector2d arm = point - center;
    return {normal.x(), normal.y(), (arm.x() * normal.y() - arm.y() * normal.x()) / lever};
  }
};

// Contacts tell nothing about what is far away: a step is at most half a radius long.
inline Eigen::Vector3d limited_step(const Eigen::Vector3d& step, double radius)
{
  const double length = step.norm();
  return length > 0.5 * radius ? Eigen::Vector3d(0.5 * radius / length * step) : step;
}

// Finds contacts of charts in a square.
class Contact_finder
{
public:
  explicit Contact_finder(const std::vector<Rigid_chart>& charts) : m_charts(charts) {}

  void set_room(const Square_room& room) { m_room = room; }
  const Square_room& room() const { return m_room; }

  // How many distances were looked up so far, which takes most of the time.
  long long lookups() const { return m_lookups; }

  bool can_meet(int i, const Rigid_motion& at_i, int j, const Rigid_motion& at_j) const
  {
    const double reach = m_charts[i].radius + m_charts[j].radius + m_room.distance + m_room.slack;
    return (at_i.translation() - at_j.translation()).squaredNorm() < reach * reach;
  }

  // The pairs that can meet, with the higher index first, in order. Only charts that share some abscissa are compared.
  std::vector<std::pair<int, int> > meeting_pairs(const std::vector<Rigid_motion>& motions) const
  {
    const double gap = m_room.distance + m_room.slack;
    std::vector<double> lefts;
    for(std::size_t i = 0; i < motions.size(); ++i)
      lefts.push_back(motions[i].translation().x() - m_charts[i].radius - 0.5 * gap);
    const std::vector<int> order = CGAL::internal::Graph_kernel::ascending_places(lefts);
    std::vector<std::pair<int, int> > pairs;
    for(std::size_t k = 0; k < order.size(); ++k)
    {
      const int i = order[k];
      const double right = lefts[i] + 2 * m_charts[i].radius + gap;
      for(std::size_t l = k + 1; l < order.size() && lefts[order[l]] < right; ++l)
        if(const int j = order[l]; can_meet(i, motions[i], j, motions[j]))
          pairs.emplace_back((std::max)(i, j), (std::min)(i, j));
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  // Calls `add(contact)` for the samples of chart `i` that are too close to the border, as long as that returns true.
  template <typename Add>
  void at_border(int i, const Rigid_motion& at, Add add)
  {
    const double inner = m_charts[i].radius + m_room.slack;
    if(at.translation().minCoeff() >= inner && at.translation().maxCoeff() <= m_room.side - inner)
      return;
    m_lookups += (long long)m_charts[i].samples.size();
    for(const Eigen::Vector2d& sample : m_charts[i].samples)
    {
      const Eigen::Vector2d p = at(sample);
      for(int k = 0; k < 2; ++k)
      {
        const double low = m_room.slack - p[k], high = p[k] - m_room.side + m_room.slack;
        if((low > 0 || high > 0)
           && !add(Contact{p, Eigen::Vector2d::Unit(k) * (low > 0 ? 1 : -1), (std::max)(low, high)}))
          return;
      }
    }
  }

  // The same for samples of chart `i` that are too close to chart `j`, with normals that lead out of the latter. Blocks
  // of samples that are far away are not looked at.
  template <typename Add>
  void in_chart(int i, const Rigid_motion& at_i, int j, const Rigid_motion& at_j, Add add)
  {
    const double reach = m_room.distance + m_room.slack;
    const Rigid_motion relative = at_i.relative_to(at_j);
    const Distance_field& field = m_charts[j].field;
    for(const Sample_block& block : m_charts[i].blocks)
    {
      ++m_lookups;
      if(field.least_distance(relative(block.center)) >= reach + block.radius)
        continue;
      m_lookups += block.end - block.begin;
      for(int k = block.begin; k < block.end; ++k)
      {
        const Eigen::Vector2d p = relative(m_charts[i].samples[k]);
        const Signed_distance found = field(p, reach);
        if(found.distance < reach && !add(Contact{at_j(p), at_j.turned(found.direction), reach - found.distance}))
          return;
      }
    }
  }

  // Samples may miss where narrow charts cross.
  bool has_overlap(const std::vector<Rigid_motion>& motions) const
  {
    for(const auto& [i, j] : meeting_pairs(motions))
      if(do_overlap(m_charts[i], motions[i], m_charts[j], motions[j]))
        return true;
    return false;
  }

private:
  const std::vector<Rigid_chart>& m_charts;
  Square_room m_room = {0, 0, 0};
  long long m_lookups = 0;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CONTACT_FINDER_H
