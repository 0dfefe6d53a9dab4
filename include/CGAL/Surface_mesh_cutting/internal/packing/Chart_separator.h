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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_SEPARATOR_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_SEPARATOR_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/Contact_finder.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Crowding_map.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Packing_random.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Execution.h>

#include <CGAL/number_utils.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using CGAL::internal::Graph_kernel::Go_further;

// Moves charts in a square until none is too close to another one: each is pushed out of the others by Gauss-Newton
// steps, or tries other places. Pairs that stay too close weigh more and more (guided local search).
class Chart_separator
{
public:
  explicit Chart_separator(const std::vector<Rigid_chart>& charts)
    : m_charts(charts), m_finder(charts), m_map(charts), m_random(0), m_order(charts.size())
  {
    std::iota(m_order.begin(), m_order.end(), 0);
  }

  // How many distances were looked up so far, which takes most of the time; every attempt adds some.
  long long lookups() const { return m_finder.lookups() + m_attempts * Crowding_map::number_of_cells; }

  // Whether it succeeded, before there were `most_lookups` in all; the motions are then those found. Attempts that
  // stagnate are given up: where charts do not come apart steadily, they hardly ever do.
  bool separate(std::vector<Rigid_motion>& motions, const Square_room& room, long long most_lookups,
                const Go_further& go_further)
  {
    const int patience = 20 + 200 / int(m_charts.size()); // sweeps: luck is cheap where there are few charts
    ++m_attempts;
    m_finder.set_room(room);
    m_motions.swap(motions);
    m_map.put_all(m_motions, room.side, room.distance + room.slack);
    m_weights.assign(m_charts.size() * (m_charts.size() + 1), 1.);
    bool is_separated = false;
    double least = std::numeric_limits<double>::infinity();
    for(int i = 0, last = 0; lookups() < most_lookups && !is_separated && i - last < patience && go_further(); ++i)
    {
      const double depth = sweep(i >= sweeps_without_search);
      is_separated = depth == 0;
      if(depth < least)
      {
        least = depth;
        last = i;
      }
      if(!is_separated)
        reweight();
    }
    is_separated = is_separated && !m_finder.has_overlap(m_motions);
    m_motions.swap(motions);
    return is_separated;
  }

private:
  static constexpr int sweeps_without_search = 4; // before charts try other places

  struct Weighted_contact
  {
    Contact contact;
    double weight;
  };

  double& weight(int i, int j) { return m_weights[std::size_t((std::max)(i, j)) * m_charts.size() + (std::min)(i, j)]; }
  double& border_weight(int i) { return m_weights[m_charts.size() * m_charts.size() + i]; }

  // By how much charts were too close, summed up as each had its turn; 0 if there was nothing to move.
  double sweep(bool do_search)
  {
    for(int i = int(m_order.size()) - 1; i > 0; --i)
      std::swap(m_order[i], m_order[m_random.below(i + 1)]);
    double depth = 0;
    for(const int i : m_order)
    {
      find_contacts(i, m_motions[i]);
      if(m_deepest <= m_finder.room().slack)
        continue;
      depth += m_deepest;
      Rigid_motion best = m_motions[i];
      double least = descend(i, best, 4);
      if(do_search && least > 0)
        search(i, best, least);
      m_motions[i] = best;
      m_map.put(i, best);
    }
    return depth;
  }

  // The best of many places anywhere.
  void search(int i, Rigid_motion& best, double& least)
  {
    constexpr int turns = 16;
    std::vector<Rated_place> found;
    m_map.look_from(i, [&](int j) { return weight(i, j); });
    for(int k = 0; k < turns; ++k)
    {
      const double angle = other_angle(i, k % 2 == 0);
      m_map.try_places(i, angle, m_random, found);
    }
    for(auto& [energy, motion] : found)
    {
      energy = descend(i, motion, 4);
      if(energy < least)
      {
        least = energy;
        best = motion;
      }
    }
  }

  // As the chart may be turned: as before, by quarters, or anyhow.
  double other_angle(int i, bool prefers_quarters)
  {
    const double angle = m_motions[i].angle();
    switch(m_charts[i].rotation)
    {
      case Chart_rotation::NONE: return angle;
      case Chart_rotation::QUARTER: return m_random.below(4) * CGAL_PI / 2 + angle;
      default: return prefers_quarters ? m_random.below(4) * CGAL_PI / 2 + angle : m_random.share() * 2 * CGAL_PI;
    }
  }

  double descend(int i, Rigid_motion& motion, int steps)
  {
    double energy = find_contacts(i, motion);
    for(int step = 0; step < steps && m_deepest > m_finder.room().slack; ++step)
    {
      const Eigen::Vector3d move = newton_step(i, motion);
      const double former = energy;
      for(const double length : {1., 0.4})
      {
        const Rigid_motion next(motion.angle() + length * move.z(), motion.translation() + length * move.head<2>());
        energy = find_contacts(i, next, former);
        if(energy < former)
        {
          motion = next;
          break;
        }
      }
      if(!(energy < former))
        return former;
    }
    return energy;
  }

  // Of Gauss and Newton, damped where contacts leave the chart free to move.
  Eigen::Vector3d newton_step(int i, const Rigid_motion& motion) const
  {
    constexpr double damping = 1e-3;
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d side = Eigen::Vector3d::Zero();
    const double lever = m_charts[i].lever();
    double weights = 0;
    for(const auto& [contact, weight] : m_contacts)
    {
      const Eigen::Vector3d direction = contact.direction(motion.translation(), lever);
      matrix += weight * direction * direction.transpose();
      side += weight * contact.depth * direction;
      weights += weight;
    }
    matrix.diagonal().array() += damping * weights;
    Eigen::Vector3d step = limited_step(matrix.ldlt().solve(side), m_charts[i].radius);
    step.z() /= lever;
    return step;
  }

  // The weighted squares of the depths, or `limit` if they are more.
  double find_contacts(int i, const Rigid_motion& motion, double limit = std::numeric_limits<double>::infinity())
  {
    m_contacts.clear();
    m_deepest = 0;
    double energy = 0;
    const auto add = [&](const Contact& contact, double weight)
    {
      m_contacts.push_back({contact, weight});
      m_deepest = (std::max)(m_deepest, contact.depth);
      energy += weight * contact.depth * contact.depth;
      return energy < limit;
    };
    m_finder.at_border(i, motion, [&](const Contact& contact) { return add(contact, border_weight(i)); });
    for(int j = 0; j < int(m_charts.size()) && energy < limit; ++j)
    {
      if(j == i || !m_finder.can_meet(i, motion, j, m_motions[j]))
        continue;
      const double pair_weight = weight(i, j);
      m_finder.in_chart(i, motion, j, m_motions[j],
                        [&](const Contact& contact) { return add(contact, pair_weight); });
      if(energy < limit)
        m_finder.in_chart(j, m_motions[j], i, motion, [&](const Contact& contact)
                          { return add({contact.point, -contact.normal, contact.depth}, pair_weight); });
    }
    return (std::min)(energy, limit);
  }

  // Raises the weights of what is too close.
  void reweight()
  {
    constexpr double raise = 1.3, decay = 0.95, most = 1e100; // not infinity, which hundreds of sweeps would lead to
    for(int i = 0; i < int(m_charts.size()); ++i)
    {
      bool is_close = false;
      const auto look = [&](const Contact& contact)
      {
        is_close = contact.depth > m_finder.room().slack;
        return !is_close;
      };
      m_finder.at_border(i, m_motions[i], look);
      if(is_close)
        border_weight(i) = (std::min)(raise * border_weight(i), most);
      for(int j = 0; j < i; ++j)
      {
        if(!m_finder.can_meet(i, m_motions[i], j, m_motions[j]))
          continue;
        is_close = false;
        m_finder.in_chart(i, m_motions[i], j, m_motions[j], look);
        if(!is_close)
          m_finder.in_chart(j, m_motions[j], i, m_motions[i], look);
        weight(i, j) = (std::min)((std::max)(weight(i, j) * (is_close ? raise : decay), 1.), most);
      }
    }
  }

  const std::vector<Rigid_chart>& m_charts;
  Contact_finder m_finder;
  Crowding_map m_map;
  Packing_random m_random;
  std::vector<Rigid_motion> m_motions;
  std::vector<double> m_weights; // of pairs, and of charts at the border
  std::vector<int> m_order;
  std::vector<Weighted_contact> m_contacts;
  double m_deepest = 0;
  long long m_attempts = 0;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_SEPARATOR_H
