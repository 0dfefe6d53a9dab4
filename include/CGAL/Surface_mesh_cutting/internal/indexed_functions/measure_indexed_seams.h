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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_MEASURE_INDEXED_SEAMS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_MEASURE_INDEXED_SEAMS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/result/exact_certificate.h>
#include <CGAL/Surface_mesh_cutting/internal/result/seam_measures.h>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

CGAL_INLINE_UNLESS_SEPARATE
Indexed_status measure_indexed_seams(const Indexed_mesh& mesh, const Cut& cut, const std::vector<Eigen::Vector2d>& corner_uv,
                                     Execution execution, Seam_measures& measures)
{
  const Corner_table chart = make_chart(mesh, cut);
  const Certificate certificate = certify_corners(chart, corner_uv, false, execution);
  if(certificate.non_finite > 0 || certificate.torn > 0)
    return certificate.status();
  measures = seam_measures(mesh, cut, chart, vertex_uvs(chart, corner_uv), execution);
  return Indexed_status();
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INDEXED_FUNCTIONS_MEASURE_INDEXED_SEAMS_H
