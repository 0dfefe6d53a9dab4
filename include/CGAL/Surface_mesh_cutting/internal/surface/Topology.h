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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_TOPOLOGY_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_TOPOLOGY_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using Surface_mesh_parameterization::internal::Connected_parts;

// The numbers that tell connected orientable surfaces apart.
struct Topology
{
  int euler_characteristic = 0;
  int border_loops = 0;

  int genus() const { return (2 - euler_characteristic - border_loops) / 2; }
  bool is_disk() const { return euler_characteristic == 1; } // of a connected surface
};

// The topology of each part of a chart, in which no two parts share a vertex. O(n).
inline std::vector<Topology> topologies(const Corner_table& chart, const Connected_parts& parts)
{
  std::vector<Topology> result(parts.number);
  std::vector<char> is_counted(chart.number_of_vertices(), 0);
  for(int h = 0; h < int(chart.opposites().size()); ++h)
  {
    Topology& topology = result[parts.part[h / 3]];
    if(!std::exchange(is_counted[chart.source(h)], char(1)))
      ++topology.euler_characteristic;
    if(chart.is_border(h) || h < chart.opposite(h))
      --topology.euler_characteristic;
    if(h % 3 == 0)
      ++topology.euler_characteristic;
  }
  for(const std::vector<int>& loop : chart.border_loops())
    ++result[parts.part[loop.front() / 3]].border_loops;
  return result;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_TOPOLOGY_H
