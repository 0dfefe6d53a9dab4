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

#ifndef CGAL_SURFACE_MESH_CUTTING_CREASE_WEIGHTS_H
#define CGAL_SURFACE_MESH_CUTTING_CREASE_WEIGHTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/dihedral_angles.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/flatness.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>
#include <CGAL/Surface_mesh_cutting/internal/input/put_weights.h>
#include <CGAL/Surface_mesh_cutting/Result_status.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {

namespace internal {

inline std::vector<double> crease_factors(const Indexed_mesh& mesh, double smallest_factor,
                                          double smallest_convex_factor)
{
  std::vector<double> factors = flatness(mesh);
  const std::vector<double> angles = dihedral_angles(mesh);
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    factors[e] = interpolated_factor(angles[e] > 0 ? smallest_convex_factor : smallest_factor, factors[e]);
  return factors;
}

} // namespace internal

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// computes edge weights that favor sharp edges.
///
/// The weight of an edge is its length times a factor: 1 where the two faces lie in a plane,
/// `smallest_factor` where they meet at a right angle or less, and in between linear in
/// the cosine of the angle between their normals. The weight of a border edge is its length. The
/// time is linear in the size of the surface.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeWeightMap a model of `WritablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and a value type that
///         `double` converts to
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface
/// \param edge_weight_map receives the weights, for the named parameter `edge_weight_map` of
///        `greedy_cut()`, `unwrap()` and the functions for the steps of the method
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
///        listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{smallest_factor}
///     \cgalParamDescription{the factor of a sharp edge, between 0 and 1}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0.2`}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{smallest_convex_factor}
///     \cgalParamDescription{the same as `smallest_factor` for edges at which the surface is convex. If it is
///                           greater, cuts prefer concave creases, where a seam is less exposed.}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`smallest_factor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \copydetails PkgSurfaceMeshCuttingWeightParameters
///
/// \return `Status_code::OK`; `Status_code::WRONG_PARAMETER`; or, for an unsupported mesh,
///         `Status_code::EMPTY_MESH`, `Status_code::NOT_TRIANGULATED`, `Status_code::NON_MANIFOLD`
///         or `Status_code::INVALID_POINT`. Writes the weights only with `Status_code::OK`.
///
/// \sa `straightness_weights()`
/// \sa `visibility_weights()`
/// \sa `painted_weights()`
template <typename TriangleMesh, typename EdgeWeightMap,
          typename NamedParameters = parameters::Default_named_parameters>
Result_status<TriangleMesh> crease_weights(const TriangleMesh& tmesh, EdgeWeightMap edge_weight_map,
                                           const NamedParameters& np = parameters::default_values())
{
  const double smallest_factor = parameters::choose_parameter(
    parameters::get_parameter(np, internal_np::smallest_factor), 0.2);
  const double smallest_convex_factor = parameters::choose_parameter(
    parameters::get_parameter(np, internal_np::smallest_convex_factor), smallest_factor);
  return internal::put_weights(tmesh, edge_weight_map, np, [&](const auto& adapter, std::vector<double>& factors)
  {
    internal::Indexed_status status = internal::check_factor("smallest_factor", smallest_factor);
    if(status)
      status = internal::check_factor("smallest_convex_factor", smallest_convex_factor);
    if(status)
      factors = internal::crease_factors(adapter.mesh(), smallest_factor, smallest_convex_factor);
    return status;
  });
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_CREASE_WEIGHTS_H
