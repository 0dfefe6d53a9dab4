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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_LEAST_TRIANGULATION_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_LEAST_TRIANGULATION_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Twice the area vector of a closed polygon, which need not be flat (Newell).
inline Point area_vector(const std::vector<Point>& polygon)
{
  using Surface_mesh_parameterization::internal::cross_product;
  Point sum(0, 0, 0);
  for(std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += cross_product(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return sum;
}

// Whether the diagonal between two corners of a polygon is not wanted: the surface has such an edge already.
using Is_taken = std::function<bool(int, int)>;

// Whether a triangle of a polygon with this area vector is flat or turned over.
inline bool is_turned_over(const Point& p, const Point& q, const Point& r, const Point& area)
{
  using Surface_mesh_parameterization::internal::cross_product;
  constexpr double flat = 1e-10; // of the products of lengths that rounding spoils
  const Point a = q - p, b = r - p;
  return cross_product(a, b).dot(area) <= flat * area.norm() * (a.squaredNorm() + b.squaredNorm());
}

// The fan of the first corner, as most programs triangulate polygons; empty if that turns a triangle over.
inline std::vector<Triangle> fan_triangulation(const std::vector<Point>& polygon)
{
  const Point area = area_vector(polygon);
  std::vector<Triangle> triangles;
  for(int i = 1; i + 1 < int(polygon.size()); ++i)
  {
    if(is_turned_over(polygon[0], polygon[i], polygon[i + 1], area))
      return {};
    triangles.push_back({0, i, i + 1});
  }
  return triangles;
}

// The triangulation of a polygon that has, in this order, as few unwanted diagonals, as few triangles that are
// flat or turned over, and as short diagonals as possible: dynamic programming in O(n^3) time. A simple flat polygon
// is triangulated without a triangle turned over, hence without overlaps. What CGAL has for holes cannot leave out
// diagonals.
class Least_triangulation
{
public:
  Least_triangulation(const std::vector<Point>& polygon, const Is_taken& is_taken)
    : m_polygon(polygon), m_is_taken(is_taken), m_area(area_vector(polygon)), m_size(int(polygon.size())),
      m_costs(polygon.size() * polygon.size()), m_apexes(polygon.size() * polygon.size(), -1)
  {
    for(int width = 2; width < m_size; ++width)
      for(int i = 0; i + width < m_size; ++i)
        choose_apex(i, i + width);
    std::vector<std::pair<int, int> > bases = {{0, m_size - 1}};
    while(!bases.empty())
    {
      const auto [i, j] = bases.back();
      bases.pop_back();
      if(j - i < 2)
        continue;
      const int k = m_apexes[index(i, j)];
      m_triangles.push_back({i, k, j});
      bases.emplace_back(k, j);
      bases.emplace_back(i, k);
    }
  }

  // Of corners, oriented like the polygon.
  const std::vector<Triangle>& triangles() const { return m_triangles; }
  bool has_unwanted_diagonal() const { return m_costs[index(0, m_size - 1)].unwanted > 0; }

private:
  struct Cost
  {
    int unwanted = 0, turned_over = 0;
    double squared_length = 0;

    Cost operator+(const Cost& other) const
    {
      return {unwanted + other.unwanted, turned_over + other.turned_over, squared_length + other.squared_length};
    }
    bool operator<(const Cost& other) const
    {
      return std::tie(unwanted, turned_over, squared_length)
             < std::tie(other.unwanted, other.turned_over, other.squared_length);
    }
  };

  std::size_t index(int i, int j) const { return std::size_t(i) * std::size_t(m_size) + std::size_t(j); }

  // Of the triangle above the base from i to j.
  void choose_apex(int i, int j)
  {
    Cost best = {(std::numeric_limits<int>::max)(), 0, 0};
    for(int k = i + 1; k < j; ++k)
    {
      Cost cost = m_costs[index(i, k)] + m_costs[index(k, j)];
      cost.turned_over += is_turned_over(m_polygon[i], m_polygon[k], m_polygon[j], m_area);
      if(cost < best)
      {
        best = cost;
        m_apexes[index(i, j)] = k;
      }
    }
    if(j - i < m_size - 1) // a diagonal
      best = best + Cost{m_is_taken(i, j), 0, (m_polygon[i] - m_polygon[j]).squaredNorm()};
    m_costs[index(i, j)] = best;
  }

  const std::vector<Point>& m_polygon;
  const Is_taken& m_is_taken;
  const Point m_area;
  const int m_size;
  std::vector<Cost> m_costs; // of what lies above the base from i to j
  std::vector<int> m_apexes;
  std::vector<Triangle> m_triangles;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_LEAST_TRIANGULATION_H
