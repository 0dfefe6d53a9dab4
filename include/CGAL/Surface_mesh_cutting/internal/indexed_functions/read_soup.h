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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_READ_SOUP_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_READ_SOUP_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Soup_reader.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

CGAL_INLINE_UNLESS_SEPARATE
Soup_surface read_soup(const std::vector<Point>& points, const Polygons& soup, const Welding& welding, Execution execution,
                       const Go_further& go_further)
{
  return Soup_reader(points, soup, welding, execution, go_further).run();
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_READ_SOUP_H
