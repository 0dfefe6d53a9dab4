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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_SOUP_SURFACE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_SOUP_SURFACE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Interpretation.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Polygons.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// What a polygon soup is read as: a consistently oriented manifold of polygons. Where the soup is one, nothing changes
// its number.
struct Soup_surface
{
  std::vector<Point> points;
  std::vector<int> origins; // per vertex, the vertex of the soup
  Polygons polygons; // these may touch themselves, but no side has the same vertex twice
  std::vector<int> opposites;       // per side, the one across, or -1
  std::vector<int> polygon_origins; // per polygon, the one of the soup that it is, or is a loop of

  // Per corner of the soup, the corner of the surface whose UV it has, -1 if it lies nowhere on the surface; whether it is
  // that corner; and whether it has to have that UV, as it is in a polygon with area.
  std::vector<int> corners;
  std::vector<char> is_on_surface, is_bound;

  bool is_welded = false; // whether vertices at the same point counted as one
  std::vector<Interpretation> findings;

  bool is_stopped = false; // then there is nothing else
};

inline Soup_surface stopped_surface()
{
  Soup_surface nothing;
  nothing.is_stopped = true;
  return nothing;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_SOUP_SURFACE_H
