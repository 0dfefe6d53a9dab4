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

#ifndef CGAL_SURFACE_MESH_CUTTING_PAINTED_WEIGHTS_H
#define CGAL_SURFACE_MESH_CUTTING_PAINTED_WEIGHTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/internal/input/put_weights.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>
#include <CGAL/Surface_mesh_cutting/Result_status.h>
#include <CGAL/Surface_mesh_cutting/Status_code.h>

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {

namespace internal {

template <typename Adapter, typename VertexPaintMap>
Indexed_status find_painted_factors(const Adapter& adapter, VertexPaintMap vertex_paint_map, std::vector<double>& factors)
{
  const Indexed_mesh& mesh = adapter.mesh();
  std::vector<double> paint;
  std::vector<int> invalid;
  for(int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    paint.push_back(CGAL::to_double(get(vertex_paint_map, adapter.to_vertex(v))));
    if(!(paint.back() >= 0) || std::isinf(paint.back()))
      invalid.push_back(v);
  }
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    factors.push_back(0.5 * paint[mesh.source(mesh.halfedge(e))] + 0.5 * paint[mesh.target(mesh.halfedge(e))]);
  return invalid.empty() ? Indexed_status()
                         : Indexed_status(Status_code::WRONG_PARAMETER,
                                          "vertex_paint_map: values that are negative or not finite",
                                          Element_kind::VERTEX, std::move(invalid));
}

} // namespace internal

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// computes edge weights from values at the vertices, such as those that a user paints on the surface.
///
/// The weight of an edge is its length times the mean of the values at its two ends. The weight of a border
/// edge is its length. The time is linear in the size of the surface.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeWeightMap a model of `WritablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and a value type that
///         `double` converts to
/// \tparam VertexPaintMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a number type as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface
/// \param edge_weight_map receives the weights, for the named parameter `edge_weight_map` of
///        `greedy_cut()`, `unwrap()` and the functions for the steps of the method
/// \param vertex_paint_map the cost of a unit of length at each vertex: finite and not negative, 1 where cuts are as
///        expensive as without weights
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
///        listed below
///
/// \copydetails PkgSurfaceMeshCuttingWeightParameters
///
/// \return `Status_code::OK`; `Status_code::WRONG_PARAMETER`, with the vertices whose paint is negative or not finite; or, for an
///         unsupported mesh, `Status_code::EMPTY_MESH`, `Status_code::NOT_TRIANGULATED`, `Status_code::NON_MANIFOLD`
///         or `Status_code::INVALID_POINT`. Writes the weights only with `Status_code::OK`.
///
/// \sa `crease_weights()`
/// \sa `straightness_weights()`
/// \sa `visibility_weights()`
template <typename TriangleMesh, typename EdgeWeightMap, typename VertexPaintMap,
          typename NamedParameters = parameters::Default_named_parameters>
Result_status<TriangleMesh> painted_weights(const TriangleMesh& tmesh, EdgeWeightMap edge_weight_map,
                                            VertexPaintMap vertex_paint_map,
                                            const NamedParameters& np = parameters::default_values())
{
  return internal::put_weights(tmesh, edge_weight_map, np, [&](const auto& adapter, std::vector<double>& factors)
  { return internal::find_painted_factors(adapter, vertex_paint_map, factors); });
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_PAINTED_WEIGHTS_H
