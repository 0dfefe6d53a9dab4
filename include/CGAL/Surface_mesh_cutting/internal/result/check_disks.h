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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_CHECK_DISKS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_CHECK_DISKS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Topology.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// OK if all parts of a chart are disks, otherwise the faces of the first part that is not. O(n).
inline Indexed_status check_disks(const Corner_table& chart)
{
  const Connected_parts parts(chart.opposites());
  const std::vector<Topology> topology = topologies(chart, parts);
  const auto is_bad = [](const Topology& t) { return !t.is_disk(); };
  const auto bad = std::find_if(topology.begin(), topology.end(), is_bad);
  if(bad == topology.end())
    return Indexed_status();
  std::vector<int> faces;
  for(int f = 0; f < chart.number_of_triangles(); ++f)
    if(parts.part[f] == bad - topology.begin())
      faces.push_back(f);
  const auto number = std::count_if(bad, topology.end(), is_bad);
  const std::string message = "parts that are not disks: " + std::to_string(number)
                            + "; the first has genus " + std::to_string(bad->genus())
                            + " and " + std::to_string(bad->border_loops) + " border(s)";
  return Indexed_status(Status_code::NOT_CUT_TO_DISKS, message, Element_kind::FACE, std::move(faces));
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_CHECK_DISKS_H
