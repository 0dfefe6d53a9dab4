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

#ifndef CGAL_SURFACE_MESH_CUTTING_CERTIFY_UNWRAPPED_POLYGON_SOUP_H
#define CGAL_SURFACE_MESH_CUTTING_CERTIFY_UNWRAPPED_POLYGON_SOUP_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/Polygon_soup.h>
#include <CGAL/Surface_mesh_cutting/Result_status.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Soup_adapter.h>

#include <Eigen/Core>

#include <vector>

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/certify_indexed_map.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// proves that a polygon soup is unwrapped. The surface as `unwrap_polygon_soup()` reads it, opened where the UVs of two
/// neighbors differ, satisfies `certify_unwrap()`, and repeated polygons and corners have the UVs of the ones that they
/// repeat. All decisions are exact.
///
/// \tparam PointRange a range of `%Point_3` of any kernel
/// \tparam PolygonRange a range of ranges of indices of points
/// \tparam CornerUVs a range of ranges of `%Point_2`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param points the points
/// \param polygons the polygons
/// \param corner_uvs the UVs of the corners, in the order of `polygons`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `do_weld_points` and `weld_tolerance` as
///        for `unwrap_polygon_soup()`, and `do_bijective` as for `certify_unwrap()`
///
/// \return a status, one of those of `certify_unwrap()`, or `Status_code::WRONG_PARAMETER` with the polygons that refer to points
///         which do not exist, or if there is not one UV for each corner.
///
/// \sa `unwrap_polygon_soup()`
template <typename PointRange, typename PolygonRange, typename CornerUVs,
          typename NamedParameters = parameters::Default_named_parameters>
Result_status<Polygon_soup> certify_unwrapped_polygon_soup(const PointRange& points, const PolygonRange& polygons,
                                                           const CornerUVs& corner_uvs,
                                                           const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  const internal::Welding welding = {choose_parameter(get_parameter(np, internal_np::do_weld_points), false) ? internal::Welding::ON
                                                                                                             : internal::Welding::OFF,
                                     choose_parameter(get_parameter(np, internal_np::weld_tolerance), 0.), {}};
  const bool do_bijective = choose_parameter(get_parameter(np, internal_np::do_bijective), false);
  const internal::Soup_adapter adapter(points, polygons, welding);
  internal::Indexed_status status = adapter.status();
  std::vector<Eigen::Vector2d> uvs;
  if(status)
    status.finding = adapter.read_uvs(polygons, corner_uvs, uvs).finding;
  if(status)
    status.finding = internal::certify_indexed_map(internal::make_chart(adapter.mesh(), adapter.cut_between(uvs)), uvs,
                                                   do_bijective).finding;
  return adapter.translate(status);
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_CERTIFY_UNWRAPPED_POLYGON_SOUP_H
