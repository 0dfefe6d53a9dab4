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

#ifndef CGAL_SURFACE_MESH_CUTTING_REFLECTION_SYMMETRY_H
#define CGAL_SURFACE_MESH_CUTTING_REFLECTION_SYMMETRY_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/Reflection_plane.h>
#include <CGAL/Surface_mesh_cutting/Result_status.h>
#include <CGAL/Surface_mesh_cutting/Symmetry.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/mirrored_vertices.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/to_plane.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <vector>

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/find_indexed_symmetries.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// is the result of `reflection_symmetry()`.
template <typename TriangleMesh>
struct Reflection_symmetry
{
  Result_status<TriangleMesh> status; ///< how the call ended.
  /// the planes at which the surface is symmetric, that is, at least 98 % of the vertices are matched; exact ones first, then
  /// those that match more, and among equals those to which the surface is closer. There may be none.
  std::vector<Reflection_plane> planes;
  /// the largest share of the vertices that any plane matches.
  double largest_match = 0;
  /// for each of `vertices(tmesh)`, the vertex to which the first plane mirrors it, or
  /// `boost::graph_traits<TriangleMesh>::%null_vertex()` if there is none. If the plane is exact, each vertex with a
  /// face has one; the image of the image is the vertex itself.
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> images;

  /// `true` iff there is a plane.
  explicit operator bool() const { return !planes.empty(); }
};

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// finds planes at which a surface is symmetric, whatever its position, scale and numbering.
///
/// The search is geometric and does not need a symmetric triangulation: planes in all directions move to where the
/// reflected vertices come closest to the surface. Where a plane maps the mesh to itself, which is found by following its
/// edges, the symmetry is exact, and the plane is the one that maps vertices to their images best. Among several planes
/// within ten degrees, one is found; surfaces of revolution have a few of their infinitely many planes.
///
/// The time is \f$ O(n \log n) \f$ on most surfaces.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithms: `Sequential_tag` (default),
///         `Parallel_tag`, or `Parallel_if_available_tag`. The result does not depend on it.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
///                    `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{symmetry}
///     \cgalParamDescription{which planes are considered; with `Symmetry::NONE`, none}
///     \cgalParamType{`Symmetry`}
///     \cgalParamDefault{`Symmetry::AUTOMATIC`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the planes and a status: `Status_code::OK`, also if there is no plane; or, for an unsupported mesh,
///         `Status_code::EMPTY_MESH`, `Status_code::NOT_TRIANGULATED`, `Status_code::NON_MANIFOLD` or
///         `Status_code::INVALID_POINT`.
///
/// \sa `unwrap()`
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh,
          typename NamedParameters = parameters::Default_named_parameters>
Reflection_symmetry<TriangleMesh> reflection_symmetry(const TriangleMesh& tmesh,
                                                      const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  Reflection_symmetry<TriangleMesh> result;
  const Symmetry choice = choose_parameter(get_parameter(np, internal_np::symmetry), Symmetry::AUTOMATIC);
  const auto adapter = internal::make_mesh_adapter(tmesh, np);
  result.status = adapter.translate(adapter.status());
  if(!result.status || choice == Symmetry::NONE)
    return result;
  const std::vector<internal::Indexed_symmetry> found
    = internal::find_indexed_symmetries(adapter.mesh(), internal::diagonals_of(adapter), choice,
                                        Surface_mesh_parameterization::internal::execution_of<ConcurrencyTag>());
  for(const internal::Indexed_symmetry& symmetry : found)
  {
    result.largest_match = (std::max)(result.largest_match, symmetry.matched);
    if(symmetry.is_symmetry())
      result.planes.push_back(internal::to_plane(symmetry, adapter));
  }
  if(!result.planes.empty())
    for(const int v : found.front().images)
      result.images.push_back(v < 0 ? boost::graph_traits<TriangleMesh>::null_vertex() : adapter.to_vertex(v));
  return result;
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_REFLECTION_SYMMETRY_H
