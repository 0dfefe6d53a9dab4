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

#ifndef CGAL_SURFACE_MESH_CUTTING_CUT_RESULT_H
#define CGAL_SURFACE_MESH_CUTTING_CUT_RESULT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Reflection_plane.h>
#include <CGAL/Surface_mesh_cutting/Result_status.h>
#include <CGAL/Surface_mesh_cutting/Trade_off.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// is the result of `greedy_cut()`, besides the cut. Lengths are in units of the mesh.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
template <typename TriangleMesh>
struct Cut_result
{
  /// how the run ended.
  Result_status<TriangleMesh> status;
  /// whether the output maps hold a valid result: always with `Status_code::OK` and `Status_code::BOUND_NOT_REACHED`, and
  /// with `Status_code::STOPPED` if a result existed by then.
  bool has_result = false;

  int components = 0; ///< number of connected components of the surface.
  int genus = 0;      ///< sum of the genera of the components.
  int borders = 0;    ///< number of border loops of the surface.

  int number_of_candidates = 0;       ///< number of candidates for feature points.
  int number_of_auxiliary_points = 0; ///< number of branch points that the connection added.
  /// the feature points.
  std::vector<typename Finding<TriangleMesh>::Descriptors::vertex_descriptor> feature_points;

  double bounding_box_diagonal = 0; ///< length of the diagonal of the bounding box.
  double cut_length = 0;            ///< total length of the cut edges.
  /// total weight of the cut edges, which the method minimizes; their length unless `edge_weight_map` is given.
  double cut_cost = 0;
  /// a lower bound on the length of any cut through the same feature points, along the constrained edges and the
  /// loops that cut the handles; empty if none is known, as with weights other than lengths, or after ends moved.
  std::optional<double> lower_bound;
  /// whether the cut is proven to be a shortest cut of this kind; empty if no bound is known.
  std::optional<bool> is_optimal;

  /// cuts that the run considered, from cheap to expensive, except cuts that another one beats in cost and distortion. If
  /// feature points were detected on a coarser version, some cuts are measured there. With `do_bijective`, the distortion of
  /// all but the result is that of maps that may overlap. Empty for several components, and if constrained edges separate
  /// the surface.
  std::vector<Trade_off> trade_offs;

  /// the symmetry of the surface, if the named parameter `symmetry` asks for one and there is one. Unless a warning says otherwise,
  /// it maps the cut to itself.
  std::optional<Reflection_plane> symmetry;

  /// `true` iff everything requested was computed.
  explicit operator bool() const { return bool(status); }
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_CUT_RESULT_H
