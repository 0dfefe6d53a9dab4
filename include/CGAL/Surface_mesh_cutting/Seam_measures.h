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

#ifndef CGAL_SURFACE_MESH_CUTTING_SEAM_MEASURES_H
#define CGAL_SURFACE_MESH_CUTTING_SEAM_MEASURES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <optional>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// tells how natural the seams of a map look. The *seam* consists of the cut edges that are not on the border of the surface;
/// measures of it are empty if there is none. Section \ref smc_seams of the manual explains the definitions.
struct Seam_measures
{
  /// how much seams turn, in radians per average edge length, beyond what the smoothest way nearby does; 0 is ideal.
  std::optional<double> jaggedness;
  /// mean of \f$ 4 \pi a / p^2 \f$ for charts of area \f$ a \f$ and perimeter \f$ p \f$, weighted by area; a disk has 1.
  double compactness = 0;
  /// mean share that charts have of the area of their convex hulls, weighted by area; 1 is convex.
  double convexity = 0;
  std::optional<double> on_hard_edges; ///< share of the seam's length on edges with 30 degrees or more between the normals.
  std::optional<double> hidden; ///< share of the light around the seam that the surface blocks; 1 is hidden from everywhere.
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_SEAM_MEASURES_H
