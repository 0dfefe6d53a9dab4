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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_JOINT_GROWTH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_JOINT_GROWTH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/Contact_finder.h>

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Execution.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using CGAL::internal::Graph_kernel::Go_further;
using Surface_mesh_parameterization::internal::Solvers;
using Surface_mesh_parameterization::internal::Symmetric_solver;

// Grows charts in a square, or rather narrows the square, until they are jammed: no motion of all charts together makes
// more room. Gauss-Newton steps in all motions at once settle in a few steps what charts that move one after the other
// pass on from neighbor to neighbor.
class Joint_growth
{
public:
  Joint_growth(const std::vector<Rigid_chart>& charts, const Go_further& go_further)
    : m_charts(charts), m_finder(charts), m_go_further(go_further),
      m_linear_solvers(Surface_mesh_parameterization::internal::default_solvers(go_further))
  {}

  long long lookups() const { return m_finder.lookups(); }

  // The largest scale it finds from `scale` on, where charts are apart, up to `limit`; the motions are then those
  // there. `room_at(scale)` is the room at a scale. No step begins after `enough` lookups.
  template <typename Room_at>
  double grow(std::vector<Rigid_motion>& motions, double scale, double limit, long long enough, Room_at room_at)
  {
    constexpr double first = 1.01, finest = 1.0001;
    for(double factor = first; factor > finest && scale < limit && lookups() < enough && m_go_further();)
    {
      const double next = (std::min)(scale * factor, limit);
      std::vector<Rigid_motion> attempt = narrowed(motions, room_at(next).side / room_at(scale).side);
      m_finder.set_room(room_at(next));
      if(settle(attempt))
      {
        motions.swap(attempt);
        scale = next;
      }
      else
        factor = std::sqrt(factor);
    }
    return scale;
  }

private:
  struct Pair_contact
  {
    int chart, other; // pushed along the normal, and against it; -1 for the border
    Contact contact;
  };

  // Whether charts come apart by few steps; where that is possible, most of the depth is gone after the first ones.
  bool settle(std::vector<Rigid_motion>& motions)
  {
    constexpr int most_steps = 20;
    for(int k = 0; k < most_steps; ++k)
    {
      if(find_contacts(motions) <= m_finder.room().slack)
        return !m_finder.has_overlap(motions);
      if(!step(motions))
        return false;
    }
    return false;
  }

  // The depth of the deepest one.
  double find_contacts(const std::vector<Rigid_motion>& motions)
  {
    m_contacts.clear();
    double deepest = 0;
    const auto add_to = [&](int chart, int other)
    {
      return [&, chart, other](const Contact& contact)
      {
        m_contacts.push_back({chart, other, contact});
        deepest = (std::max)(deepest, contact.depth);
        return true;
      };
    };
    const std::vector<std::pair<int, int> > pairs = m_finder.meeting_pairs(motions);
    auto pair = pairs.begin();
    for(int i = 0; i < int(motions.size()); ++i)
    {
      m_finder.at_border(i, motions[i], add_to(i, -1));
      for(; pair != pairs.end() && pair->first == i; ++pair)
      {
        const int j = pair->second;
        m_finder.in_chart(i, motions[i], j, motions[j], add_to(i, j));
        m_finder.in_chart(j, motions[j], i, motions[i], add_to(j, i));
      }
    }
    return deepest;
  }

  // Of Gauss and Newton, damped where contacts leave charts free to move; false if there is none.
  bool step(std::vector<Rigid_motion>& motions)
  {
    constexpr double damping = 1e-3;
    const int number = int(motions.size());
    m_entries.clear();
    Eigen::VectorXd right = Eigen::VectorXd::Zero(3 * number);
    for(int k = 0; k < 3 * number; ++k)
      m_entries.emplace_back(k, k, damping);
    for(const auto& [chart, other, contact] : m_contacts)
    {
      const Eigen::Vector3d row = contact.direction(motions[chart].translation(), m_charts[chart].lever());
      add_product(chart, row, chart, row);
      right.segment<3>(3 * chart) += contact.depth * row;
      if(other < 0)
        continue;
      const Eigen::Vector3d other_row = -contact.direction(motions[other].translation(), m_charts[other].lever());
      add_product(other, other_row, other, other_row);
      right.segment<3>(3 * other) += contact.depth * other_row;
      if(chart > other)
        add_product(chart, row, other, other_row);
      else
        add_product(other, other_row, chart, row);
    }
    Eigen::SparseMatrix<double> lower(3 * number, 3 * number);
    lower.setFromTriplets(m_entries.begin(), m_entries.end());
    Symmetric_solver solver(m_linear_solvers);
    if(!solver.factorize(lower))
      return false;
    move(motions, solver.solve(right));
    return true;
  }

  // To the block of two charts in the lower triangle.
  void add_product(int i, const Eigen::Vector3d& row_i, int j, const Eigen::Vector3d& row_j)
  {
    for(int a = 0; a < 3; ++a)
      for(int b = 0; b < (i == j ? a + 1 : 3); ++b)
        m_entries.emplace_back(3 * i + a, 3 * j + b, row_i[a] * row_j[b]);
  }

  void move(std::vector<Rigid_motion>& motions, const Eigen::VectorXd& moves) const
  {
    for(std::size_t i = 0; i < motions.size(); ++i)
    {
      const Eigen::Vector3d move = limited_step(moves.segment<3>(3 * Eigen::Index(i)), m_charts[i].radius);
      motions[i] = Rigid_motion(motions[i].angle() + move.z() / m_charts[i].lever(), motions[i].translation() + move.head<2>());
    }
  }

  const std::vector<Rigid_chart>& m_charts;
  Contact_finder m_finder;
  const Go_further m_go_further;
  const Solvers m_linear_solvers;
  std::vector<Pair_contact> m_contacts;
  std::vector<Eigen::Triplet<double> > m_entries;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_JOINT_GROWTH_H
