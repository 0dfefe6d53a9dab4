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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_POLYGON_TRIANGULATOR_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_POLYGON_TRIANGULATOR_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/soup/Least_triangulation.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Polygon_triangulation.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/constrained_triangulation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Triangulates the polygons of a surface one after the other, so that no two edges get the same two vertices where
// that can be avoided.
class Polygon_triangulator
{
public:
  // `opposites` holds the side across each side, or -1 on a border. Polygons may touch themselves, but no side has the same
  // vertex twice.
  Polygon_triangulator(const std::vector<Point>& points, const Polygons& polygons, const std::vector<int>& opposites,
                       const Go_further& go_further)
    : m_points(points), m_polygons(polygons), m_opposites(opposites), m_go_further(go_further),
      m_halfedges(polygons.vertices.size(), -1)
  {}

  // Linear in the number of corners on usual polygons. Stops within a polygon, too.
  Polygon_triangulation run()
  {
    if(m_polygons.number_of_corners() == 3 * m_polygons.number())
      return triangles_as_they_are();
    collect_edges();
    m_is_simple = m_polygons.are_simple(int(m_points.size()));
    for(int polygon = 0; polygon < m_polygons.number(); ++polygon)
    {
      add(polygon, m_polygons.size(polygon) == 3 ? std::vector<Triangle>{{0, 1, 2}} : triangulate(polygon));
      const bool has_taken_long
        = m_polygons.size(polygon) > maximal_size_of_least || (polygon + 1) % polygons_between_questions == 0;
      if(has_taken_long && !m_go_further())
      {
        m_result.is_stopped = true; // the last polygon may have a makeshift triangulation
        return std::move(m_result);
      }
    }
    for(std::size_t h = 0; h < m_result.sides.size(); ++h)
      if(const int side = m_result.sides[h]; side >= 0 && m_opposites[side] >= 0)
        m_result.opposites[h] = m_halfedges[m_opposites[side]];
    return std::move(m_result);
  }

private:
  static constexpr int maximal_size_of_repair = 500; // above, it takes too long
  static constexpr int polygons_between_questions = 1024;

  // All polygons have three corners or more.
  Polygon_triangulation triangles_as_they_are() const
  {
    Polygon_triangulation result;
    result.triangles.reserve(m_polygons.ends.size());
    for(int c = 0; c < m_polygons.number_of_corners(); c += 3)
      result.triangles.push_back({m_polygons.vertices[c], m_polygons.vertices[c + 1], m_polygons.vertices[c + 2]});
    result.opposites = m_opposites;
    result.polygons.resize(m_polygons.ends.size());
    std::iota(result.polygons.begin(), result.polygons.end(), 0);
    result.corners.resize(m_polygons.vertices.size());
    std::iota(result.corners.begin(), result.corners.end(), 0);
    result.sides = result.corners;
    return result;
  }

  static std::uint64_t key(int v, int w)
  {
    return (std::uint64_t(std::uint32_t((std::min)(v, w))) << 32) | std::uint32_t((std::max)(v, w));
  }

  void collect_edges()
  {
    m_edges.reserve(m_polygons.vertices.size());
    for(int polygon = 0; polygon < m_polygons.number(); ++polygon)
      for(int c = m_polygons.begin(polygon); c < m_polygons.end(polygon); ++c)
        m_edges.insert(key(m_polygons.vertices[c], m_polygons.vertices[m_polygons.next(polygon, c)]));
  }

  // Calls `visit(i, j)` for the diagonals of a local triangulation, once for each of their two sides.
  template <typename Visit>
  static void for_each_diagonal(const std::vector<Triangle>& triangles, int size, Visit visit)
  {
    for(std::size_t t = 0; t < triangles.size(); ++t)
      for(int k = 0; k < 3; ++k)
      {
        const int i = triangles[t][k], j = triangles[t][(k + 1) % 3];
        if(j != (i + 1) % size)
          visit(i, j, 3 * int(t) + k);
      }
  }

  std::vector<Triangle> triangulate(int polygon)
  {
    const int first = m_polygons.begin(polygon), size = m_polygons.size(polygon);
    std::vector<Point> corners;
    for(int c = first; c < first + size; ++c)
      corners.push_back(m_points[m_polygons.vertices[c]]);
    const auto vertex = [&](int i) { return m_polygons.vertices[first + i]; };
    const auto diagonal = [&](int i, int j) { return key(vertex(i), vertex(j)); };
    const Is_taken is_taken = [&](int i, int j)
    { return vertex(i) == vertex(j) || m_edges.count(diagonal(i, j)) > 0; };
    const auto has_unwanted_diagonal = [&](const std::vector<Triangle>& triangles)
    {
      bool result = false;
      for_each_diagonal(triangles, size, [&](int i, int j, int) { result = result || is_taken(i, j); });
      return result;
    };

    std::vector<Triangle> triangles = fan_triangulation(corners);
    if(!triangles.empty() && !has_unwanted_diagonal(triangles))
      return add_diagonals(triangles, size, diagonal);
    triangles.clear();
    if(size > maximal_size_of_least)
      triangles = constrained_triangulation(corners, m_go_further);
    if(triangles.empty() && size > maximal_size_of_repair)
      triangles = strip(size);
    if(triangles.empty() || (size <= maximal_size_of_repair && has_unwanted_diagonal(triangles)))
      triangles = Least_triangulation(corners, is_taken).triangles();
    const Point area = area_vector(corners);
    const auto is_bad = [&](const Triangle& t) { return is_turned_over(corners[t[0]], corners[t[1]], corners[t[2]], area); };
    if(has_unwanted_diagonal(triangles) ||
       (!m_is_simple[polygon] && std::any_of(triangles.begin(), triangles.end(), is_bad)))
      m_result.doubled.push_back(polygon);
    return add_diagonals(triangles, size, diagonal);
  }

  template <typename Diagonal>
  std::vector<Triangle> add_diagonals(const std::vector<Triangle>& triangles, int size, Diagonal diagonal)
  {
    for_each_diagonal(triangles, size, [&](int i, int j, int) { m_edges.insert(diagonal(i, j)); });
    return triangles;
  }

  // For huge polygons that cross themselves any triangulation is as good.
  static std::vector<Triangle> strip(int size)
  {
    std::vector<Triangle> triangles;
    for(int low = 0, high = size - 1; low + 1 < high;)
    {
      triangles.push_back({low, low + 1, high});
      if(++low + 1 < high)
      {
        triangles.push_back({low, high - 1, high});
        --high;
      }
    }
    return triangles;
  }

  void add(int polygon, const std::vector<Triangle>& triangles)
  {
    const int first_corner = m_polygons.begin(polygon), first_halfedge = int(m_result.corners.size());
    const int size = m_polygons.size(polygon);
    for(const Triangle& t : triangles)
    {
      m_result.polygons.push_back(polygon);
      m_result.triangles.push_back({m_polygons.vertices[first_corner + t[0]], m_polygons.vertices[first_corner + t[1]],
                                    m_polygons.vertices[first_corner + t[2]]});
      for(int k = 0; k < 3; ++k)
      {
        const bool is_side = t[(k + 1) % 3] == (t[k] + 1) % size;
        m_result.corners.push_back(first_corner + t[k]);
        m_result.sides.push_back(is_side ? first_corner + t[k] : -1);
        m_result.opposites.push_back(-1);
        if(is_side)
          m_halfedges[first_corner + t[k]] = int(m_result.sides.size()) - 1;
      }
    }
    std::vector<std::pair<std::array<int, 2>, int> > diagonals;
    for_each_diagonal(triangles, size, [&](int i, int j, int h)
                      { diagonals.push_back({{{(std::min)(i, j), (std::max)(i, j)}}, first_halfedge + h}); });
    std::sort(diagonals.begin(), diagonals.end());
    for(std::size_t i = 0; i + 1 < diagonals.size(); i += 2)
    {
      m_result.opposites[diagonals[i].second] = diagonals[i + 1].second;
      m_result.opposites[diagonals[i + 1].second] = diagonals[i].second;
    }
  }

  const std::vector<Point>& m_points;
  const Polygons& m_polygons;
  const std::vector<int>& m_opposites;
  const Go_further& m_go_further;
  std::vector<int> m_halfedges;              // per side
  std::vector<char> m_is_simple;             // per polygon
  std::unordered_set<std::uint64_t> m_edges; // with two vertices, diagonals included
  Polygon_triangulation m_result;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_POLYGON_TRIANGULATOR_H
