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

#ifndef CGAL_SURFACE_MESH_CUTTING_VISIBILITY_WEIGHTS_H
#define CGAL_SURFACE_MESH_CUTTING_VISIBILITY_WEIGHTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/input/put_weights.h>
#include <CGAL/Surface_mesh_cutting/internal/run/read_run_control.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Run_control.h>
#include <CGAL/Surface_mesh_cutting/Status.h>
#include <CGAL/Surface_mesh_cutting/Visitor.h>

#include <CGAL/tags.h>

#ifndef CGAL_SURFACE_MESH_CUTTING_USE_LIBRARY
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/visibilities.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// computes edge weights that favor hidden edges.
///
/// The weight of an edge is its length times a factor: `smallest_factor` where the surface fills the
/// whole view from the middle of the edge, 1 where it blocks none of it, and in between linear in the
/// free part of the view (ambient occlusion). Random rays sample the view, distributed by the cosine
/// of their angle with the normal, on the side of the surface that its normals point to.
///
/// With \f$ n \f$ edges and \f$ k \f$ rays, the time is \f$ O(k\,n \log n) \f$ on most surfaces.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithms: `Sequential_tag` (default),
///         `Parallel_tag`, or `Parallel_if_available_tag`. The result does not depend on it.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeWeightMap a model of `WritablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and a value type that
///         `double` converts to
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface
/// \param edge_weight_map receives the weights, for the named parameter `edge_weight_map` of
///        `greedy_cut()`, `unwrap()` and the functions for the steps of the method
/// \param number_of_rays the number of rays per edge, at least one
/// \param smallest_factor how little a hidden edge counts, between 0 and 1
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
///        listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
///                    `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{the seed for drawing the directions of the rays}
///     \cgalParamType{`unsigned int`}
///     \cgalParamDefault{`0`}
///   \cgalParamNEnd
///
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{can end the run: it is asked every few milliseconds, but not while the
///                           search structure is built}
///     \cgalParamType{a class model of `CuttingVisitor`, of which only `go_further()` is called}
///     \cgalParamDefault{`Surface_mesh_cutting::Default_visitor`}
///     \cgalParamExtra{pass it by `std::ref` if it is not to be copied}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `Status_code::OK`; `Status_code::WRONG_PARAMETER`; `Status_code::STOPPED`; or, for an unsupported mesh,
///         `Status_code::EMPTY_MESH`, `Status_code::NOT_TRIANGULATED`, `Status_code::NON_MANIFOLD`
///         or `Status_code::INVALID_POINT`. Writes the weights only with `Status_code::OK`.
///
/// \sa `crease_weights()`
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename EdgeWeightMap,
          typename NamedParameters = parameters::Default_named_parameters>
Status<TriangleMesh> visibility_weights(const TriangleMesh& tmesh, EdgeWeightMap edge_weight_map,
                                        int number_of_rays = 64, double smallest_factor = 0.2,
                                        const NamedParameters& np = parameters::default_values())
{
  if(number_of_rays < 1)
  {
    Status<TriangleMesh> status;
    status.code = Status_code::WRONG_PARAMETER;
    status.message = "number_of_rays must be at least 1";
    return status;
  }
  const unsigned int seed = parameters::choose_parameter(
    parameters::get_parameter(np, internal_np::random_seed), 0u);
  Default_visitor default_visitor;
  internal::Visitor_reference<NamedParameters>
    visitor = parameters::choose_parameter(parameters::get_parameter_reference(np, internal_np::visitor),
                                           default_visitor);
  internal::Run_control control([&visitor] { return bool(visitor.go_further()); }, {});
  return internal::put_weights(
    tmesh, edge_weight_map, smallest_factor, np,
    [&](const internal::Indexed_mesh& mesh)
    { return internal::visibilities<ConcurrencyTag>(mesh, number_of_rays, seed, control); });
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_VISIBILITY_WEIGHTS_H
