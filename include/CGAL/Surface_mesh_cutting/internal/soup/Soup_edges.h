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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_SOUP_EDGES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_SOUP_EDGES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/soup/Polygons.h>
#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>

#include <algorithm>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using Surface_mesh_parameterization::internal::Execution;

// The sides of polygons, those between the same two vertices next to each other: each such group is an edge of the
// soup. Edges are in the order of their vertices.
class Soup_edges
{
public:
  struct Side
  {
    int low, high;    // its vertices
    int corner;       // where it starts
    bool is_upward;   // whether that is at `low`
  };

  // Of the polygons that are `is_used`. O(n) unless many edges share their lowest vertex.
  Soup_edges(const Polygons& polygons, const std::vector<char>& is_used, int number_of_vertices, Execution execution)
  {
    std::vector<int> places(number_of_vertices + 1, 0);
    for_each_side(polygons, is_used, [&](const Side& side) { ++places[side.low + 1]; });
    for(int v = 0; v < number_of_vertices; ++v)
      places[v + 1] += places[v];
    const std::vector<int> begins = places;
    m_sides.resize(places.back());
    for_each_side(polygons, is_used, [&](const Side& side) { m_sides[places[side.low]++] = side; });
    Surface_mesh_parameterization::internal::execute_blocks(execution, number_of_vertices, [&](int first, int last)
    {
      for(int v = first; v < last; ++v)
        std::sort(m_sides.begin() + begins[v], m_sides.begin() + begins[v + 1], [](const Side& a, const Side& b)
                  { return std::tie(a.high, a.corner) < std::tie(b.high, b.corner); });
    });
    m_begins.reserve(m_sides.size() / 2 + 1);
    for(int i = 0; i < int(m_sides.size()); ++i)
      if(i == 0 || m_sides[i].low != m_sides[i - 1].low || m_sides[i].high != m_sides[i - 1].high)
        m_begins.push_back(i);
    m_begins.push_back(int(m_sides.size()));
  }

  int number() const { return int(m_begins.size()) - 1; }
  int size(int edge) const { return m_begins[edge + 1] - m_begins[edge]; }
  const Side& side(int edge, int i) const { return m_sides[m_begins[edge] + i]; }
  int low(int edge) const { return side(edge, 0).low; }
  int high(int edge) const { return side(edge, 0).high; }

private:
  template <typename Visit>
  static void for_each_side(const Polygons& polygons, const std::vector<char>& is_used, Visit visit)
  {
    for(int p = 0; p < polygons.number(); ++p)
      if(is_used[p])
        for(int c = polygons.begin(p); c < polygons.end(p); ++c)
        {
          const int source = polygons.vertices[c], target = polygons.vertices[polygons.next(p, c)];
          visit(Side{(std::min)(source, target), (std::max)(source, target), c, source < target});
        }
  }

  std::vector<Side> m_sides;
  std::vector<int> m_begins; // per edge
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_SOUP_EDGES_H
