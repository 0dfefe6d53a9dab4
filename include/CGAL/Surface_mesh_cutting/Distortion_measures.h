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

#ifndef CGAL_SURFACE_MESH_CUTTING_DISTORTION_MEASURES_H
#define CGAL_SURFACE_MESH_CUTTING_DISTORTION_MEASURES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <optional>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// holds the distortion of a map from a surface to the plane, by the measures of the parameterization benchmark of Shay,
/// Solomon and Stein \cgalCite{cgal:sss-dbmp-22}, and the number of overlaps.
///
/// Unless said otherwise, the surface and its image are first scaled to an area of 1 each. \f$ \sigma_1 \ge \sigma_2 \f$
/// are then the singular values of the Jacobian of a face, \f$ a \f$ and \f$ a' \f$ its area on the surface and in the
/// plane. Faces without area on the surface do not count.
struct Distortion_measures
{
  double largest_area_distortion = 0;   ///< largest \f$ a'/a + a/a' - 2 \f$ of a face; 0 is ideal.
  double average_area_discrepancy = 0;  ///< sum of \f$ |a' - a| \f$; 0 is ideal.
  double smallest_singular_value = 0;   ///< least \f$ \sigma_2 \f$ of a face; 1 is ideal.
  double largest_singular_value = 0;    ///< largest \f$ \sigma_1 \f$ of a face; 1 is ideal.
  /// share \f$ p \f$ of the faces that are clockwise in the plane, or \f$ 1 - p \f$ if that is less: a reflected map is as
  /// good as the map itself.
  double proportion_of_flipped_faces = 0;
  double largest_angle_distortion = 0;  ///< largest \f$ \sigma_1/\sigma_2 + \sigma_2/\sigma_1 - 2 \f$ of a face; 0 is ideal.
  /// sum over the faces of \f$ a \f$ times the absolute changes of the three angles, in radians; 0 is ideal. An angle
  /// that is not defined in the plane counts \f$ 2\pi \f$.
  double average_angle_discrepancy = 0;
  /// largest \f$ 1/\sigma_2 \f$ of a face for the unscaled surface and an image that just fits into the unit square: the
  /// number of texels along a side of that square for one texel per unit of length everywhere.
  double resolution = 0;
  /// sum of \f$ a\,(\sigma_1^2 + \sigma_2^2 + \sigma_1^{-2} + \sigma_2^{-2}) \f$; 4 is ideal. This is
  /// `Unwrap_result::average_distortion`, at a scale that is nearly the same, and twice what the benchmark has.
  double symmetric_Dirichlet_energy = 0;
  /// length of the edges of the cut that are not on the border, over the square root of the area of the surface, unlike
  /// `Cut_result::cut_length`.
  double cut_length = 0;
  /// number of overlaps, decided exactly, as `certify_unwrap()` does; empty if a face is not counterclockwise.
  std::optional<int> overlaps;
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_DISTORTION_MEASURES_H
