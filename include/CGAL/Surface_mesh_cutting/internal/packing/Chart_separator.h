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

#include <CGAL/Surface_mesh_cutting/internal/packing/Crowding_map.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Go_further.h>

#include <CGAL/Random.h>
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

// What charts are to keep in a square.
struct Square_room
{
  double side;
  double distance; // between charts
  double slack;    // aimed at in addition, since steps approach what they aim at
};

// Moves charts in a square until none is too close to another one: each is pushed out of the others by Gauss-Newton
// steps, or tries other places. Pairs that stay too close weigh more and more (guided local search).
class Chart_separator
{
public:
  explicit Chart_separator(const std::vector<Rigid_chart>& charts)
    : m_charts(charts), m_map(charts), m_random(0), m_order(charts.size())
  {
    std::iota(m_order.begin(), m_order.end(), 0);
  }

  // How many distances were looked up so far, which takes most of the time; every attempt adds some.
  long long lookups() const { return m_lookups; }

  // Whether it succeeded, before there were `most_lookups` in all; the motions are then those found. Attempts that
  // stagnate are given up: where charts do not come apart steadily, they hardly ever do.
  bool separate(std::vector<Rigid_motion>& motions, const Square_room& room, long long most_lookups,
                const Go_further& go_further)
  {
    const int patience = 20 + 200 / int(m_charts.size()); // sweeps: luck is cheap where there are few charts
    m_room = room;
    m_motions.swap(motions);
    m_map.put_all(m_motions, room.side, room.distance + room.slack);
    m_lookups += Crowding_map::number_of_cells;
    m_weights.assign(m_charts.size() * (m_charts.size() + 1), 1.);
    bool is_separated = false;
    double least = std::numeric_limits<double>::infinity();
    for(int i = 0, last = 0; m_lookups < most_lookups && !is_separated && i - last < patience && go_further(); ++i)
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
    is_separated = is_separated && !has_overlap();
    m_motions.swap(motions);
    return is_separated;
  }

private:
  static constexpr int sweeps_without_search = 4; // before charts try other places

  struct Contact
  {
    Eigen::Vector2d point, normal; // along which the chart has to move
    double depth, weight;
  };

  double& weight(int i, int j) { return m_weights[std::size_t((std::max)(i, j)) * m_charts.size() + (std::min)(i, j)]; }
  double& border_weight(int i) { return m_weights[m_charts.size() * m_charts.size() + i]; }

  // By how much charts were too close, summed up as each had its turn; 0 if there was nothing to move.
  double sweep(bool do_search)
  {
    for(int i = int(m_order.size()) - 1; i > 0; --i)
      std::swap(m_order[i], m_order[m_random.get_int(0, i + 1)]);
    double depth = 0;
    for(const int i : m_order)
    {
      find_contacts(i, m_motions[i]);
      if(m_deepest <= m_room.slack)
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

  // Samples may miss where narrow charts cross.
  bool has_overlap() const
  {
    for(int i = 0; i < int(m_charts.size()); ++i)
      for(int j = 0; j < i; ++j)
        if(can_meet(i, m_motions[i], j) && do_overlap(m_charts[i], m_motions[i], m_charts[j], m_motions[j]))
          return true;
    return false;
  }

  // The best of many places anywhere, turned as before, by quarters, or anyhow.
  void search(int i, Rigid_motion& best, double& least)
  {
    constexpr int turns = 16;
    std::vector<Rated_place> found;
    m_map.look_from(i, [&](int j) { return weight(i, j); });
    for(int k = 0; k < turns; ++k)
    {
      const double angle = k % 2 == 0 ? m_random.get_int(0, 4) * CGAL_PI / 2 + m_motions[i].angle()
                                      : m_random.get_double(0, 2 * CGAL_PI);
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

  double descend(int i, Rigid_motion& motion, int steps)
  {
    double energy = find_contacts(i, motion);
    for(int step = 0; step < steps && m_deepest > m_room.slack; ++step)
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
    const double radius = m_charts[i].radius; // measures turns in lengths
    double weights = 0;
    for(const Contact& contact : m_contacts)
    {
      const Eigen::Vector2d arm = contact.point - motion.translation();
      const Eigen::Vector3d direction(contact.normal.x(), contact.normal.y(),
                                      (arm.x() * contact.normal.y() - arm.y() * contact.normal.x()) / radius);
      matrix += contact.weight * direction * direction.transpose();
      side += contact.weight * contact.depth * direction;
      weights += contact.weight;
    }
    matrix.diagonal().array() += damping * weights;
    Eigen::Vector3d step = matrix.ldlt().solve(side);
    const double length = step.norm();
    if(length > 0.5 * radius)
      step *= 0.5 * radius / length;
    step.z() /= radius;
    return step;
  }

  // The weighted squares of the depths, or `limit` if they are more.
  double find_contacts(int i, const Rigid_motion& motion, double limit = std::numeric_limits<double>::infinity())
  {
    m_contacts.clear();
    m_deepest = 0;
    double energy = border_contacts(i, motion);
    for(int j = 0; j < int(m_charts.size()) && energy < limit; ++j)
    {
      if(j == i || !can_meet(i, motion, j))
        continue;
      energy += field_contacts(i, motion, j, m_motions[j], 1, limit - energy);
      if(energy < limit)
        energy += field_contacts(j, m_motions[j], i, motion, -1, limit - energy);
    }
    return (std::min)(energy, limit);
  }

  bool can_meet(int i, const Rigid_motion& motion, int j) const
  {
    const double reach = m_charts[i].radius + m_charts[j].radius + m_room.distance + m_room.slack;
    return (motion.translation() - m_motions[j].translation()).squaredNorm() < reach * reach;
  }

  double add_contact(const Eigen::Vector2d& point, const Eigen::Vector2d& normal, double depth, double weight)
  {
    m_contacts.push_back({point, normal, depth, weight});
    m_deepest = (std::max)(m_deepest, depth);
    return weight * depth * depth;
  }

  double border_contacts(int i, const Rigid_motion& motion)
  {
    double energy = 0;
    const double inner = m_charts[i].radius + m_room.slack;
    const Eigen::Vector2d& center = motion.translation();
    if(center.minCoeff() >= inner && center.maxCoeff() <= m_room.side - inner)
      return energy;
    m_lookups += (long long)m_charts[i].samples.size();
    for(const Eigen::Vector2d& sample : m_charts[i].samples)
    {
      const Eigen::Vector2d p = motion(sample);
      for(int k = 0; k < 2; ++k)
      {
        const double low = m_room.slack - p[k], high = p[k] - m_room.side + m_room.slack;
        if(low > 0 || high > 0)
          energy += add_contact(p, Eigen::Vector2d::Unit(k) * (low > 0 ? 1 : -1), (std::max)(low, high),
                                border_weight(i));
      }
    }
    return energy;
  }

  // Samples of chart `i` in the field of chart `j`, which push the former for side 1 and the latter for side -1. Those
  // beyond `limit` are not looked for, nor those in blocks that are far away.
  double field_contacts(int i, const Rigid_motion& at_i, int j, const Rigid_motion& at_j, double side,
                        double limit = std::numeric_limits<double>::infinity())
  {
    const double reach = m_room.distance + m_room.slack;
    const Rigid_motion relative = at_i.relative_to(at_j);
    const Distance_field& field = m_charts[j].field;
    double energy = 0;
    for(const Sample_block& block : m_charts[i].blocks)
    {
      ++m_lookups;
      if(field.least_distance(relative(block.center)) >= reach + block.radius)
        continue;
      m_lookups += block.end - block.begin;
      for(int k = block.begin; k < block.end; ++k)
      {
        const Eigen::Vector2d p = relative(m_charts[i].samples[k]);
        const Signed_distance found = field(p);
        if(found.distance < reach)
          energy += add_contact(at_j(p), side * at_j.turned(found.direction), reach - found.distance, weight(i, j));
      }
      if(energy >= limit)
        break;
    }
    return energy;
  }

  // Raises the weights of what is too close.
  void reweight()
  {
    constexpr double raise = 1.3, decay = 0.95;
    for(int i = 0; i < int(m_charts.size()); ++i)
    {
      m_contacts.clear();
      m_deepest = 0;
      border_contacts(i, m_motions[i]);
      if(m_deepest > m_room.slack)
        border_weight(i) *= raise;
      for(int j = 0; j < i; ++j)
      {
        if(!can_meet(i, m_motions[i], j))
          continue;
        m_deepest = 0;
        field_contacts(i, m_motions[i], j, m_motions[j], 1);
        field_contacts(j, m_motions[j], i, m_motions[i], 1);
        weight(i, j) *= m_deepest > m_room.slack ? raise : decay;
        weight(i, j) = (std::max)(weight(i, j), 1.);
      }
    }
  }

  const std::vector<Rigid_chart>& m_charts;
  Crowding_map m_map;
  Random m_random;
  Square_room m_room;
  std::vector<Rigid_motion> m_motions;
  std::vector<double> m_weights; // of pairs, and of charts at the border
  std::vector<int> m_order;
  std::vector<Contact> m_contacts;
  double m_deepest = 0;
  long long m_lookups = 0;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_SEPARATOR_H
