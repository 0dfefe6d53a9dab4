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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PAGE_TILE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PAGE_TILE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <Eigen/Core>

#include <cmath>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The pages of an atlas side by side in the plane, as UDIM counts them: ten in a row, from the unit square on.
constexpr int pages_in_row = 10;

inline Eigen::Vector2d corner_of_page(int page)
{
  return Eigen::Vector2d(page % pages_in_row, page / pages_in_row);
}

// The number that UDIM gives a page.
inline int tile_of_page(int page) { return 1001 + page; }

// The page at a point inside of it, or -1 where no page is.
inline int page_at(const Eigen::Vector2d& uv)
{
  constexpr double most_rows = 1e6; // what is farther away is on no page
  const double column = std::floor(uv.x()), row = std::floor(uv.y());
  return column >= 0 && column < pages_in_row && row >= 0 && row < most_rows ? int(column) + pages_in_row * int(row) : -1;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PAGE_TILE_H
