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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_ARE_POLYGONS_APART_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_ARE_POLYGONS_APART_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Whether indices of points say nothing about the surface: (nearly) each corner has a point of its own. `corners` are those
// of all polygons. Some programs write so, and let only the halves of what was a quadrilateral share points.
template <typename Corners>
bool are_polygons_apart(const Corners& corners, std::size_t number_of_points, int number_of_polygons)
{
  constexpr std::size_t corners_per_shared_point = 100;
  std::vector<char> is_used(number_of_points, 0);
  std::size_t number = 0, number_of_shared = 0;
  for(const auto v : corners)
    if(std::size_t(v) < number_of_points)
    {
      ++number;
      number_of_shared += is_used[std::size_t(v)];
      is_used[std::size_t(v)] = 1;
    }
  return number_of_polygons > 1 && corners_per_shared_point * number_of_shared <= number;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_ARE_POLYGONS_APART_H
