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

#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/star_placement.h>

#include <Eigen/Core>

#include <algorithm>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Nonlinear elimination [LRW96]: a few triangles that a step brought near a flip make the quadratic model useless and the
// next steps short, for all others as well. Their vertices are moved one by one, each to where the energy of its star is
// least, before the next direction is found.
class Star_relaxation
{
public:
  Star_relaxation() = default;

  // The triangles with their vertices are those of the system and of all arguments to come.
  Star_relaxation(const std::vector<Triangle>& triangles, int number_of_vertices) : m_starts(number_of_vertices + 1, 0)
  {
    for(const Triangle& t : triangles)
      for(int v : t)
        ++m_starts[v + 1];
    for(int v = 0; v < number_of_vertices; ++v)
      m_starts[v + 1] += m_starts[v];
    m_corners.resize(m_starts.back());
    std::vector<int> ends(m_starts.begin(), m_starts.end() - 1);
    for(int c = 0; c < int(m_corners.size()); ++c)
      m_corners[ends[triangles[c / 3][c % 3]]++] = c;
  }

  // Moves vertices whose own decrement is above `threshold`, unless these are most. The system holds the gradient at `uv`,
  // of the area-averaged energy, and does so afterwards. Returns by how much that became less. No triangle flips.
  template <typename Energy>
  double relax(const std::vector<Triangle>& triangles, const std::vector<Rest_shape>& shapes,
               const std::vector<double>& weights, double threshold, Newton_system& system,
               std::vector<Eigen::Vector2d>& uv)
  {
    constexpr int maximum_number_of_rounds = 4;
    constexpr double most = 0.5; // of the vertices: a global step serves more of them better
    std::vector<int> active;
    for(int v = 0; v < int(uv.size()); ++v)
      if(system.decrement(v) > threshold)
        active.push_back(v);
    if(double(active.size()) > most * double(uv.size()))
      return 0;
    double gain = 0;
    for(int round = 0; round < maximum_number_of_rounds && !active.empty(); ++round)
    {
      std::vector<int> touched;
      for(int v : active)
      {
        const double decrease = move<Energy>(v, triangles, shapes, weights, uv);
        gain += decrease;
        if(decrease > 0)
          for(int i = m_starts[v]; i < m_starts[v + 1]; ++i)
            touched.insert(touched.end(), triangles[m_corners[i] / 3].begin(), triangles[m_corners[i] / 3].end());
      }
      std::sort(touched.begin(), touched.end());
      touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
      active.clear();
      for(int v : touched)
      {
        system.set_gradient(v, gradient<Energy>(v, triangles, shapes, weights, uv));
        if(system.decrement(v) > threshold)
          active.push_back(v);
      }
    }
    return gain;
  }

private:
  // Returns what that gains, 0 if the vertex stays.
  template <typename Energy>
  double move(int v, const std::vector<Triangle>& triangles, const std::vector<Rest_shape>& shapes,
              const std::vector<double>& weights, std::vector<Eigen::Vector2d>& uv)
  {
    m_star.clear();
    for(int i = m_starts[v]; i < m_starts[v + 1]; ++i)
    {
      const int f = m_corners[i] / 3, k = m_corners[i] % 3;
      const Triangle& t = triangles[f];
      m_star.push_back({uv[t[(k + 1) % 3]], uv[t[(k + 2) % 3]], rotated(shapes[f], k)});
      m_star.back().shape.area = weights[f];
    }
    const Eigen::Vector2d former = uv[v];
    const double former_energy = energy<Energy>(v, triangles, shapes, weights, uv);
    Star_placement<Energy>::improve(m_star, uv[v]);
    const double decrease = former_energy - energy<Energy>(v, triangles, shapes, weights, uv);
    if(decrease > 0)
      return decrease;
    uv[v] = former;
    return 0;
  }

  // Of the star, with the corners in the order in which the solver takes them, so that rounding cannot make it see a flip.
  template <typename Energy>
  double energy(int v, const std::vector<Triangle>& triangles, const std::vector<Rest_shape>& shapes,
                const std::vector<double>& weights, const std::vector<Eigen::Vector2d>& uv) const
  {
    double sum = 0;
    for(int i = m_starts[v]; i < m_starts[v + 1]; ++i)
    {
      const int f = m_corners[i] / 3;
      const Triangle& t = triangles[f];
      const Wirtinger_derivatives w = wirtinger_derivatives(shapes[f], uv[t[0]], uv[t[1]], uv[t[2]]);
      if(!(w.x() > w.y()))
        return std::numeric_limits<double>::infinity();
      sum += weights[f] * Energy::value(w.x(), w.y());
    }
    return sum;
  }

  template <typename Energy>
  Eigen::Vector2d gradient(int v, const std::vector<Triangle>& triangles, const std::vector<Rest_shape>& shapes,
                           const std::vector<double>& weights, const std::vector<Eigen::Vector2d>& uv) const
  {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero(), at_corners[3];
    for(int i = m_starts[v]; i < m_starts[v + 1]; ++i)
    {
      const int f = m_corners[i] / 3;
      const Triangle& t = triangles[f];
      triangle_gradient<Energy>(shapes[f], uv[t[0]], uv[t[1]], uv[t[2]], at_corners);
      sum += weights[f] * at_corners[m_corners[i] % 3];
    }
    return sum;
  }

  std::vector<int> m_starts;  // per vertex, its first corner in the list of
  std::vector<int> m_corners; // 3 * triangle + place
  std::vector<Star_triangle> m_star;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_STAR_RELAXATION_H
