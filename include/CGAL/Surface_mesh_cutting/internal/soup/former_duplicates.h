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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_FORMER_DUPLICATES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_FORMER_DUPLICATES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/soup/Polygons.h>
#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using CGAL::internal::Graph_kernel::Buckets;
using Surface_mesh_parameterization::internal::Execution;

// Negative, zero or positive, as the vertices of p from the corner c on come before, with or after those of q from d on.
inline int comparison_from(const Polygons& polygons, int p, int c, int q, int d)
{
  if(polygons.size(p) != polygons.size(q))
    return polygons.size(p) - polygons.size(q);
  for(int i = 0; i < polygons.size(p); ++i, c = polygons.next(p, c), d = polygons.next(q, d))
    if(polygons.vertices[c] != polygons.vertices[d])
      return polygons.vertices[c] - polygons.vertices[d];
  return 0;
}

// Whether two polygons have the same vertices in opposite orders, those of p from the corner c on, of q from d on backward.
inline bool are_reverse(const Polygons& polygons, int p, int c, int q, int d)
{
  if(p == q || polygons.size(p) != polygons.size(q))
    return false;
  for(int i = 0; i < polygons.size(p); ++i, c = polygons.next(p, c), d = polygons.previous(q, d))
    if(polygons.vertices[c] != polygons.vertices[d])
      return false;
  return true;
}

// The corner from which on the vertices come first, in the order of sequences.
inline int first_corner(const Polygons& polygons, int p)
{
  int result = polygons.begin(p);
  for(int c = result + 1; c < polygons.end(p); ++c)
    if(polygons.vertices[c] < polygons.vertices[result] ||
       (polygons.vertices[c] == polygons.vertices[result] && comparison_from(polygons, p, c, p, result) < 0))
      result = c;
  return result;
}

// For each polygon that has the vertices of a former one in the same cyclic order, the first such; -1 for the others. O(n)
// unless many polygons share their lowest vertex, or one visits it often.
inline std::vector<int> former_duplicates(const Polygons& polygons, int number_of_vertices, Execution execution)
{
  std::vector<int> starts(polygons.ends.size());
  for(int p = 0; p < polygons.number(); ++p)
    starts[p] = first_corner(polygons, p);
  Buckets<int> at_lowest_vertex(number_of_vertices, [&](const auto& visit)
  {
    for(int p = 0; p < polygons.number(); ++p)
      visit(polygons.vertices[starts[p]], p);
  });
  const auto comparison = [&](int p, int q) { return comparison_from(polygons, p, starts[p], q, starts[q]); };
  std::vector<int> result(polygons.ends.size(), -1);
  Surface_mesh_parameterization::internal::execute_blocks(execution, number_of_vertices, [&](int first, int last)
  {
    for(int v = first; v < last; ++v)
    {
      const auto order = at_lowest_vertex[v];
      std::sort(order.begin(), order.end(), [&](int p, int q)
                { const int c = comparison(p, q); return c != 0 ? c < 0 : p < q; });
      for(int i = 1; i < at_lowest_vertex.size(v); ++i)
      {
        const int p = order.begin()[i - 1], q = order.begin()[i];
        if(comparison(p, q) == 0)
          result[q] = result[p] >= 0 ? result[p] : p;
      }
    }
  });
  return result;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_FORMER_DUPLICATES_H
