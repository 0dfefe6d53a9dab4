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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_ROUNDING_REPAIR_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_ROUNDING_REPAIR_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/exact_flips.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/stars.h>

#include <Eigen/Core>

#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Rounds UVs to the caller's number type, as `float`, so that no triangle flips: where one does, a
// vertex of it moves towards the middle of the kernel of its star, no farther than needed.
class Rounding_repair
{
public:
  using Round = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

  // The vertices from `number_of_rounded` on are not kept: they need no rounding, and those that are
  // fixed must not move. The triangles are referred to.
  Rounding_repair(const std::vector<Triangle>& triangles, int number_of_vertices, Round round, int number_of_rounded,
                  std::vector<char> is_fixed)
    : m_triangles(triangles), m_round(std::move(round)), m_number_of_rounded(number_of_rounded),
      m_is_fixed(std::move(is_fixed)), m_number_of_vertices(number_of_vertices)
  {}

  // False if flips remain. O(n), and for each repair about the size of a star.
  bool operator()(std::vector<Eigen::Vector2d>& uv)
  {
    constexpr int maximum_number_of_passes = 20; // a limit
    for(int v = 0; v < m_number_of_rounded; ++v)
      uv[v] = m_round(uv[v]);
    std::vector<int> flipped;
    count_flips(m_triangles, uv, &flipped);
    if(!flipped.empty())
      m_corners = corners_at_vertices(m_triangles, m_number_of_vertices);
    for(int pass = 0; pass < maximum_number_of_passes && !flipped.empty(); ++pass)
    {
      bool is_changed = false;
      for(int t : flipped)
        for(int v : m_triangles[t])
          is_changed = (is_flipped(t, uv) && improve(v, uv)) || is_changed;
      if(!is_changed)
        return false;
      flipped.clear();
      count_flips(m_triangles, uv, &flipped);
    }
    return flipped.empty();
  }

private:
  bool is_flipped(int t, const std::vector<Eigen::Vector2d>& uv) const
  {
    const Triangle& v = m_triangles[t];
    return !is_counterclockwise(uv[v[0]], uv[v[1]], uv[v[2]]);
  }

  int number_of_flips_around(int v, const std::vector<Eigen::Vector2d>& uv) const
  {
    int number = 0;
    for(int c : m_corners[v])
      number += is_flipped(c / 3, uv);
    return number;
  }

  // Whether fewer triangles around the vertex are flipped now.
  bool improve(int v, std::vector<Eigen::Vector2d>& uv)
  {
    constexpr double shortest_move = 1e-6; // of the way to the middle: what `float` resolves
    Eigen::Vector2d middle;
    if((v < int(m_is_fixed.size()) && m_is_fixed[v]) || !kernel_centroid(v, uv, middle))
      return false;
    const Eigen::Vector2d former = uv[v], to_middle = middle - former;
    Eigen::Vector2d best = former;
    const int former_number = number_of_flips_around(v, uv);
    int least = former_number;
    for(double share = shortest_move; least > 0; share *= 2)
    {
      uv[v] = former + (share < 1 ? share : 1) * to_middle;
      if(v < m_number_of_rounded)
        uv[v] = m_round(uv[v]);
      const int number = number_of_flips_around(v, uv);
      if(number < least)
      {
        least = number;
        best = uv[v];
      }
      if(share >= 1)
        break;
    }
    uv[v] = best;
    return least < former_number;
  }

  bool kernel_centroid(int v, const std::vector<Eigen::Vector2d>& uv, Eigen::Vector2d& middle)
  {
    collect_star(m_corners[v], m_triangles, uv, [](int) { return no_shape(); }, m_star);
    return m_placement.kernel_centroid(m_star, middle);
  }

  const std::vector<Triangle>& m_triangles;
  const Round m_round;
  const int m_number_of_rounded;
  const std::vector<char> m_is_fixed;
  const int m_number_of_vertices;
  Buckets<int> m_corners;
  std::vector<Star_triangle> m_star;
  Star_placement<Symmetric_Dirichlet_energy> m_placement;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_ROUNDING_REPAIR_H
