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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_STAR_RELAXATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_STAR_RELAXATION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/star_placement.h>

#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>

#include <Eigen/Core>

#include <algorithm>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

using CGAL::internal::Graph_kernel::Index_set;

// What is minimized: the sum of weight times energy over triangles.
struct Weighted_triangles
{
  const std::vector<Triangle>& triangles;
  const std::vector<Rest_shape>& shapes;
  const std::vector<double>& weights;
};

// Nonlinear elimination [LRW96]: a few triangles that a step brought near a flip make the quadratic model useless and the
// next steps short, for all others as well. Their vertices are moved one by one, each to where the energy of its star is
// least, before the next direction is found.
class Star_relaxation
{
public:
  explicit Star_relaxation(Execution execution) : m_execution(execution) {}

  // Moves vertices whose own decrement is above `threshold`, unless these are the majority: a global step serves more of
  // them better. The system holds the gradient of the sum at `uv`, and does so afterwards. Returns by how much the sum
  // became less. No triangle flips. The triangles are the same in all calls.
  template <typename Energy>
  double relax(const Weighted_triangles& sum, double threshold, Newton_system& system, std::vector<Eigen::Vector2d>& uv)
  {
    constexpr int maximum_number_of_rounds = 4;
    std::vector<int> active = system.vertices_above(threshold);
    if(2 * active.size() > uv.size())
      return 0;
    if(!active.empty() && m_corners.number_of_buckets() == 0)
    {
      m_corners = corners_at_vertices(sum.triangles, int(uv.size()));
      m_touched = Index_set(int(uv.size()));
    }
    double gain = 0;
    for(int round = 0; round < maximum_number_of_rounds && !active.empty(); ++round)
    {
      m_touched.clear();
      for(int v : active)
      {
        const double decrease = move<Energy>(v, sum, uv);
        gain += decrease;
        if(decrease > 0)
          for(int c : m_corners[v])
            for(int w : sum.triangles[c / 3])
              m_touched.insert(w);
      }
      m_touched.sort();
      const std::vector<int>& touched = m_touched.indices();
      execute_blocks(m_execution, int(touched.size()), [&](int begin, int end)
      {
        for(int i = begin; i < end; ++i)
          system.set_gradient(touched[i], gradient<Energy>(touched[i], sum, uv));
      });
      active.clear();
      std::copy_if(touched.begin(), touched.end(), std::back_inserter(active),
                   [&](int v) { return system.decrement(v) > threshold; });
    }
    return gain;
  }

private:
  // Returns what that gains, 0 if the vertex stays.
  template <typename Energy>
  double move(int v, const Weighted_triangles& sum, std::vector<Eigen::Vector2d>& uv)
  {
    const auto shape_of = [&](int c)
    {
      Rest_shape shape = rotated(sum.shapes[c / 3], c % 3);
      shape.area = sum.weights[c / 3];
      return shape;
    };
    collect_star(m_corners[v], sum.triangles, uv, shape_of, m_star);
    const Eigen::Vector2d former = uv[v];
    const double former_energy = energy<Energy>(v, sum, uv);
    Star_placement<Energy>::improve(m_star, uv[v]);
    const double decrease = former_energy - energy<Energy>(v, sum, uv);
    if(decrease > 0)
      return decrease;
    uv[v] = former;
    return 0;
  }

  // Of the star, with the corners in the order in which the solver takes them, so that rounding cannot make it see a flip.
  template <typename Energy>
  double energy(int v, const Weighted_triangles& sum, const std::vector<Eigen::Vector2d>& uv) const
  {
    double result = 0;
    for(int c : m_corners[v])
    {
      const Triangle& t = sum.triangles[c / 3];
      result += triangle_energy<Energy>(sum.weights[c / 3], sum.shapes[c / 3], uv[t[0]], uv[t[1]], uv[t[2]]);
    }
    return result;
  }

  template <typename Energy>
  Eigen::Vector2d gradient(int v, const Weighted_triangles& sum, const std::vector<Eigen::Vector2d>& uv) const
  {
    Eigen::Vector2d result = Eigen::Vector2d::Zero(), at_corners[3];
    for(int c : m_corners[v])
    {
      const Triangle& t = sum.triangles[c / 3];
      triangle_gradient<Energy>(sum.shapes[c / 3], uv[t[0]], uv[t[1]], uv[t[2]], at_corners);
      result += sum.weights[c / 3] * at_corners[c % 3];
    }
    return result;
  }

  Execution m_execution;
  Buckets<int> m_corners; // at each vertex; found when a vertex is to move
  Index_set m_touched;    // vertices, in each round
  std::vector<Star_triangle> m_star;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_STAR_RELAXATION_H
