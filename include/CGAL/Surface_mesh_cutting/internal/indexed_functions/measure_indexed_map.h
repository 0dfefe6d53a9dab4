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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_MEASURE_INDEXED_MAP_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_MEASURE_INDEXED_MAP_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/result/distortion_measures.h>
#include <CGAL/Surface_mesh_cutting/internal/result/exact_certificate.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

CGAL_INLINE_UNLESS_SEPARATE
Indexed_status measure_indexed_map(const Indexed_mesh& mesh, const Cut& cut,
                                   const std::vector<Eigen::Vector2d>& corner_uv, Distortion_measures& measures)
{
  const Corner_table chart = make_chart(mesh, cut);
  const Certificate certificate = certify_corners(chart, corner_uv, true);
  if(certificate.non_finite > 0 || certificate.torn > 0)
    return certificate.status();
  const Distortion_sums sums(mesh, chart, vertex_uvs(chart, corner_uv));
  if(!(sums.image_area() > 0))
    return certificate.status();
  measures = sums.measures();
  measures.cut_length = cut_length(mesh, cut) / std::sqrt(sums.area());
  if(certificate.flips == 0)
    measures.overlaps = certificate.overlaps();
  return Indexed_status();
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_MEASURE_INDEXED_MAP_H
