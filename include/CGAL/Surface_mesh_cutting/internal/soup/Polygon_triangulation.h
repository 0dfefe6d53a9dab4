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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_POLYGON_TRIANGULATION_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_POLYGON_TRIANGULATION_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/soup/Polygons.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A surface of polygons as triangles between the same vertices, and where they come from. A polygon that is a
// triangle stays as it is.
struct Polygon_triangulation
{
  std::vector<Triangle> triangles;
  std::vector<int> opposites; // per halfedge, as in `Indexed_mesh`
  std::vector<int> corners;   // per halfedge, the corner of a polygon that it starts from
  std::vector<int> sides;     // per halfedge, the side of a polygon that it is, -1 for a diagonal
  std::vector<int> polygons;  // per triangle

  // The polygons with a diagonal between vertices that have another edge, and those that touch themselves so that a triangle
  // is turned over. Where two edges enclose a part of the surface without a cut, no map is free of flips.
  std::vector<int> doubled;

  bool is_stopped = false; // then the rest is not complete
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_POLYGON_TRIANGULATION_H
