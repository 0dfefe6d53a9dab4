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

#ifndef CGAL_SURFACE_MESH_CUTTING_STRAIGHTNESS_WEIGHTS_H
#define CGAL_SURFACE_MESH_CUTTING_STRAIGHTNESS_WEIGHTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/internal/input/put_weights.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/principal_alignment.h>
#include <CGAL/Surface_mesh_cutting/Result_status.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// computes edge weights that favor cuts along feature lines and principal directions.
///
/// The weight of an edge is its length times a factor: `smallest_factor` where it runs in one of the two
/// directions in which the surface bends most and least, along a pipe or straight around it; 1 if it runs
/// halfway between them, and where the surface bends equally in all directions or hardly at all. The curvature
/// tensor is that of Cohen-Steiner and Morvan: around the ends of the edge, each edge contributes its dihedral
/// angle times its length in its own direction. A surface that bends less than a sphere with its bounding box
/// diagonal as radius counts as flat. The weight of a border edge is its length. The time is linear in the
/// size of the surface.
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
///     \cgalParamDescription{the factor of an edge in a principal direction, between 0 and 1}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0.2`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \copydetails PkgSurfaceMeshCuttingWeightParameters
///
/// \return `Status_code::OK`; `Status_code::WRONG_PARAMETER`; or, for an unsupported mesh,
///         `Status_code::EMPTY_MESH`, `Status_code::NOT_TRIANGULATED`, `Status_code::NON_MANIFOLD`
///         or `Status_code::INVALID_POINT`. Writes the weights only with `Status_code::OK`.
///
/// \sa `crease_weights()`
/// \sa `visibility_weights()`
/// \sa `painted_weights()`
template <typename TriangleMesh, typename EdgeWeightMap,
          typename NamedParameters = parameters::Default_named_parameters>
Result_status<TriangleMesh> straightness_weights(const TriangleMesh& tmesh, EdgeWeightMap edge_weight_map,
                                                 const NamedParameters& np = parameters::default_values())
{
  const double smallest_factor = parameters::choose_parameter(
    parameters::get_parameter(np, internal_np::smallest_factor), 0.2);
  return internal::put_weights(tmesh, edge_weight_map, np, [&](const auto& adapter, std::vector<double>& factors)
  {
    for(const double alignment : internal::principal_alignment(adapter.mesh()))
      factors.push_back(internal::interpolated_factor(smallest_factor, 1 - alignment));
    return internal::check_factor("smallest_factor", smallest_factor);
  });
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_STRAIGHTNESS_WEIGHTS_H
