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

#ifndef CGAL_SURFACE_MESH_CUTTING_CERTIFY_PACKING_H
#define CGAL_SURFACE_MESH_CUTTING_CERTIFY_PACKING_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/Result_status.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/read_packing_parameters.h>

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/certify_indexed_packing.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// proves that charts are packed: their UVs are finite and agree where no edge is cut; all triangles are
/// counterclockwise; each chart lies in the square of a page, at least the margin away from its border; no chart lies on
/// another one; and the distance between any two charts is at least the margin. With `do_bijective`, it also proves that no
/// chart overlaps itself.
///
/// All decisions are exact, for the coordinates converted to `double` and for the margin `margin / texture_size`, which
/// is not rounded.
///
/// The time is \f$ O(n + (b + k) \log b) \f$ for \f$ b \f$ edges on the borders of charts and \f$ k \f$ pairs of them
/// with boxes that are closer than the margin.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsCutMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
/// \tparam HalfedgeUVMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and `%Point_2` as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface
/// \param edge_is_cut_map marks the edges of the cut; marks on border edges are ignored
/// \param halfedge_uv_map holds at each halfedge `h` that is not on the border the UV of the corner
///        of `face(h, tmesh)` at `target(h, tmesh)`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{margin}
///     \cgalParamDescription{the least distance between charts and to the border of the square, in texels; at least 0 and
///                           less than half of `texture_size`}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`2`}
///   \cgalParamNEnd
///   \cgalParamNBegin{texture_size}
///     \cgalParamDescription{the number of texels along a side of the square; at least 1}
///     \cgalParamType{`int`}
///     \cgalParamDefault{`1024`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_pages}
///     \cgalParamDescription{the number of pages, which lie as `pack_charts()` places them; the first one is the unit square}
///     \cgalParamType{`int`}
///     \cgalParamDefault{`1`, and any number with `texels_per_unit`, so that the parameters of `pack_charts()` suit both}
///   \cgalParamNEnd
///   \cgalParamNBegin{do_bijective}
///     \cgalParamDescription{whether to prove that no chart overlaps itself}
///     \cgalParamType{Boolean}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
///                    `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return a status, one of
/// - `Status_code::OK`;
/// - `Status_code::NOT_CERTIFIED`, with a message that counts the defects, and the faces concerned;
/// - `Status_code::WRONG_PARAMETER`;
/// - `Status_code::EMPTY_MESH`, `Status_code::NOT_TRIANGULATED`, `Status_code::NON_MANIFOLD` or
///   `Status_code::INVALID_POINT` for an unsupported mesh.
///
/// \sa `pack_charts()`
/// \sa `certify_unwrap()`
template <typename TriangleMesh, typename EdgeIsCutMap, typename HalfedgeUVMap,
          typename NamedParameters = parameters::Default_named_parameters>
Result_status<TriangleMesh> certify_packing(const TriangleMesh& tmesh, EdgeIsCutMap edge_is_cut_map,
                                            HalfedgeUVMap halfedge_uv_map,
                                            const NamedParameters& np = parameters::default_values())
{
  const auto adapter = internal::make_mesh_adapter(tmesh, np);
  const internal::Packing_parameters parameters = internal::read_packing_parameters(np);
  internal::Indexed_status status = adapter.status();
  if(status)
    status.finding = internal::check_parameters(parameters).finding;
  if(status)
    status.finding = internal::certify_indexed_packing(
      internal::make_chart(adapter.mesh(), adapter.read_cut(edge_is_cut_map)), adapter.read_uvs(halfedge_uv_map),
      parameters).finding;
  return adapter.translate(status);
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_CERTIFY_PACKING_H
