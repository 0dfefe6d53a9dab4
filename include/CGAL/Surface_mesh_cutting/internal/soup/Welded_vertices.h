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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_WELDED_VERTICES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_WELDED_VERTICES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/soup/Polygons.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>

#include <boost/functional/hash.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Per vertex of a soup, the first one that it counts as: vertices at exactly the same point, and those near each other, be it by
// way of others between them. Vertices that no polygon uses stay for themselves.
class Welded_vertices
{
  using Disjoint_sets = CGAL::internal::Graph_kernel::Disjoint_sets;
  using Cell = std::array<double, 4>; // of a grid, given by integers, and the part
  template <typename Value>
  using Map = std::unordered_map<Cell, Value, boost::hash<Cell> >;

public:
  // Tolerance and parts are those of `Welding`. O(n) unless points are dense, but not within the tolerance.
  Welded_vertices(const std::vector<Point>& points, const Polygons& polygons, double tolerance,
                  const std::vector<int>& parts)
    : m_points(points), m_parts(parts), m_sets(int(points.size())), m_is_used(points.size(), 0)
  {
    constexpr double rounding = 1e-15; // below, only equal points are near
    for(int v : polygons.vertices)
      m_is_used[v] = 1;
    unite_equal();
    if(tolerance > rounding)
      unite_near(tolerance);
  }

  std::vector<int> representatives()
  {
    std::vector<int> result(m_points.size());
    for(int v = 0; v < int(m_points.size()); ++v)
      result[v] = m_sets.find(v);
    return result;
  }

private:
  // The vertices in a cell, which is so small that all of them are near each other.
  struct Group
  {
    Cell cell;
    std::vector<int> vertices;
  };

  static constexpr double cells_per_block = 8;

  double part(int v) const { return m_parts.empty() ? 0 : m_parts[v]; }

  void unite_equal()
  {
    Map<int> first;
    for(int v = 0; v < int(m_points.size()); ++v)
      if(m_is_used[v])
      {
        const Point p = m_points[v] + Point::Zero(); // -0 becomes 0
        m_sets.unite(v, first.emplace(Cell{{p.x(), p.y(), p.z(), part(v)}}, v).first->second);
      }
  }

  void unite_near(double tolerance)
  {
    Surface_mesh_parameterization::internal::Bounding_box<3> box;
    for(std::size_t v = 0; v < m_points.size(); ++v)
      if(m_is_used[v])
        box.add(m_points[v]);
    m_distance = tolerance * box.size().stableNorm();
    if(!(m_distance > 0))
      return;
    collect_groups(box.low);
    Map<std::vector<int> > blocks;
    for(int g = 0; g < int(m_groups.size()); ++g)
    {
      for_each_block_near(m_groups[g].cell, [&](const Cell& block)
      {
        if(const auto others = blocks.find(block); others != blocks.end())
          for(int other : others->second)
            unite_if_near(m_groups[g].vertices, m_groups[other].vertices);
      });
      blocks[block_of(m_groups[g].cell, 0)].push_back(g);
    }
  }

  // Cells are half as wide as the distance.
  void collect_groups(const Point& origin)
  {
    Map<int> numbers;
    for(int v = 0; v < int(m_points.size()); ++v)
    {
      if(!m_is_used[v] || m_sets.find(v) != v) // one of several at the same point is enough
        continue;
      Cell cell;
      for(int k = 0; k < 3; ++k)
        cell[k] = std::floor((m_points[v][k] - origin[k]) / (m_distance / 2));
      cell[3] = part(v);
      const auto [found, is_new] = numbers.emplace(cell, int(m_groups.size()));
      if(is_new)
        m_groups.push_back({cell, {}});
      m_groups[found->second].vertices.push_back(v);
    }
    for(const Group& group : m_groups)
      for(int v : group.vertices)
        m_sets.unite(v, group.vertices.front());
  }

  static Cell block_of(const Cell& cell, double shift)
  {
    Cell block = cell;
    for(int k = 0; k < 3; ++k)
      block[k] = std::floor((cell[k] + shift) / cells_per_block);
    return block;
  }

  // Calls `visit` for the blocks of cells that reach near a cell.
  template <typename Visit>
  static void for_each_block_near(const Cell& cell, const Visit& visit)
  {
    constexpr double reach = 2; // in cells
    const Cell low = block_of(cell, -reach), high = block_of(cell, reach);
    for(double x = low[0]; x <= high[0]; ++x)
      for(double y = low[1]; y <= high[1]; ++y)
        for(double z = low[2]; z <= high[2]; ++z)
          visit(Cell{{x, y, z, cell[3]}});
  }

  void unite_if_near(const std::vector<int>& vertices, const std::vector<int>& others)
  {
    if(m_sets.find(vertices.front()) == m_sets.find(others.front()))
      return;
    for(int v : vertices)
      for(int w : others)
        if((m_points[v] - m_points[w]).stableNorm() <= m_distance)
        {
          m_sets.unite(v, w);
          return;
        }
  }

  const std::vector<Point>& m_points;
  const std::vector<int>& m_parts;
  Disjoint_sets m_sets;
  std::vector<char> m_is_used;
  double m_distance = 0;
  std::vector<Group> m_groups;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_WELDED_VERTICES_H
