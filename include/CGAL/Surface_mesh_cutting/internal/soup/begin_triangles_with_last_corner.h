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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_BEGIN_TRIANGLES_WITH_LAST_CORNER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_BEGIN_TRIANGLES_WITH_LAST_CORNER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/soup/Soup_surface.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// As the triangles of a `CGAL::Surface_mesh` do that is filled with those of the soup: of equally good cuts, both have
// the same one then.
inline void begin_triangles_with_last_corner(Soup_surface& surface)
{
  const Polygons polygons = surface.polygons;
  std::vector<int> places(polygons.vertices.size());
  std::iota(places.begin(), places.end(), 0);
  for(int polygon = 0; polygon < polygons.number(); ++polygon)
    if(polygons.size(polygon) == 3)
      for(int c = polygons.begin(polygon); c < polygons.end(polygon); ++c)
        places[c] = polygons.next(polygon, c);
  const std::vector<int> opposites = surface.opposites;
  for(std::size_t c = 0; c < places.size(); ++c)
  {
    surface.polygons.vertices[places[c]] = polygons.vertices[c];
    surface.opposites[places[c]] = opposites[c] < 0 ? -1 : places[opposites[c]];
  }
  for(int& c : surface.corners)
    if(c >= 0)
      c = places[c];
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_BEGIN_TRIANGLES_WITH_LAST_CORNER_H
