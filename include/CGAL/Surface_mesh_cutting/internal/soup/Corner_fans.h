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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_CORNER_FANS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_CORNER_FANS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/soup/Polygons.h>

#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The corners around vertices, in sets: neighbors are those across the sides that are united.
class Corner_fans
{
public:
  Corner_fans(const Polygons& polygons, const std::vector<int>& owners)
    : m_polygons(polygons), m_owners(owners), m_sets(polygons.number_of_corners())
  {}

  // Unites the corners of two sides at the same vertices.
  void unite(int a, int b)
  {
    const int a_end = m_polygons.next(m_owners[a], a), b_end = m_polygons.next(m_owners[b], b);
    const bool is_same_direction = m_polygons.vertices[a] == m_polygons.vertices[b];
    m_sets.unite(a, is_same_direction ? b : b_end);
    m_sets.unite(a_end, is_same_direction ? b_end : b);
  }

  // Per corner, one that stands for its fan.
  std::vector<int> representatives()
  {
    std::vector<int> result(m_polygons.vertices.size());
    for(int c = 0; c < m_polygons.number_of_corners(); ++c)
      result[c] = m_sets.find(c);
    return result;
  }

private:
  const Polygons& m_polygons;
  const std::vector<int>& m_owners;
  CGAL::internal::Graph_kernel::Disjoint_sets m_sets;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_CORNER_FANS_H
