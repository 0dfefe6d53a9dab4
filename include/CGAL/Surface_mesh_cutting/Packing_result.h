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

#ifndef CGAL_SURFACE_MESH_CUTTING_PACKING_RESULT_H
#define CGAL_SURFACE_MESH_CUTTING_PACKING_RESULT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Result_status.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// is the result of `pack_charts()`.
template <typename TriangleMesh>
struct Packing_result
{
  /// how the call ended.
  Result_status<TriangleMesh> status;
  /// whether the UVs are packed; with `Status_code::STOPPED`, the charts could be larger.
  bool has_result = false;
  /// length of an edge in the unit square over its former length in the plane, the same for all edges of all charts.
  double scale = 0;
  /// area of the charts in the unit square: between 0 and 1. The mean of several pages.
  double fill = 0;
  /// the same of each page. Their number is that of the pages with charts.
  std::vector<double> page_fills;
  /// number of parts of the surface that are connected through edges not cut.
  int number_of_charts = 0;

  /// `true` iff everything requested was computed.
  explicit operator bool() const { return bool(status); }
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_PACKING_RESULT_H
