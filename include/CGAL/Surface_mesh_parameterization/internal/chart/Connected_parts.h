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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_CONNECTED_PARTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_CONNECTED_PARTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>

#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// What connects triangles across edges that are not open; `part[t]` is the number of the part
// that the triangle `t` belongs to. Parts are numbered in the order of their lowest triangles.
struct Connected_parts
{
  std::vector<int> part;
  int number = 0;

  // `opposites` as in `Corner_table`. Nearly linear time.
  explicit Connected_parts(const std::vector<int>& opposites)
    : Connected_parts(opposites, [](int) { return false; })
  {}

  // The same without some triangles, which belong to part -1.
  template <typename IsExcluded>
  Connected_parts(const std::vector<int>& opposites, IsExcluded is_excluded)
    : part(opposites.size() / 3, -1)
  {
    CGAL::internal::Graph_kernel::Disjoint_sets sets(int(part.size()));
    for(int h = 0; h < int(opposites.size()); ++h)
      if(const int o = opposites[h]; o >= 0 && o < h && !is_excluded(h / 3) && !is_excluded(o / 3))
        sets.unite(h / 3, o / 3);
    for(int t = 0; t < int(part.size()); ++t)
      if(!is_excluded(t))
      {
        const int lowest = sets.find(t);
        part[t] = lowest == t ? number++ : part[lowest];
      }
  }
};

// The part that each vertex belongs to; -1 for vertices of no triangle. No vertex is in two parts of a chart. O(n).
inline std::vector<int> parts_of_vertices(const Corner_table& chart, const Connected_parts& parts)
{
  std::vector<int> result(chart.number_of_vertices(), -1);
  for(int h = 0; h < int(chart.opposites().size()); ++h)
    result[chart.source(h)] = parts.part[h / 3];
  return result;
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_CONNECTED_PARTS_H
