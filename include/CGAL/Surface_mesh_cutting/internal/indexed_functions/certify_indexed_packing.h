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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_CERTIFY_INDEXED_PACKING_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_CERTIFY_INDEXED_PACKING_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/Packing_certificate.h>
#include <CGAL/Surface_mesh_cutting/internal/result/exact_certificate.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>

#include <limits>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

CGAL_INLINE_UNLESS_SEPARATE
Indexed_status certify_indexed_packing(const Corner_table& chart, const std::vector<Eigen::Vector2d>& corner_uv,
                                       const Packing_parameters& parameters)
{
  const Indexed_status status = certify_corners(chart, corner_uv, parameters.do_bijective).status();
  if(!status)
    return status;
  const int number_of_pages = parameters.most_pages > 0 ? parameters.most_pages : (std::numeric_limits<int>::max)();
  return Packing_certificate(chart, vertex_uvs(chart, corner_uv), parameters.margin, number_of_pages).status();
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_CERTIFY_INDEXED_PACKING_H
