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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_CERTIFY_INDEXED_MAP_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_CERTIFY_INDEXED_MAP_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/result/check_disks.h>
#include <CGAL/Surface_mesh_cutting/internal/result/exact_certificate.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

CGAL_INLINE_UNLESS_SEPARATE
Indexed_status certify_indexed_map(const Corner_table& chart, const std::vector<Eigen::Vector2d>& corner_uv, bool do_bijective)
{
  const Indexed_status disks = check_disks(chart);
  return disks ? certify_corners(chart, corner_uv, do_bijective).status() : disks;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_CERTIFY_INDEXED_MAP_H
