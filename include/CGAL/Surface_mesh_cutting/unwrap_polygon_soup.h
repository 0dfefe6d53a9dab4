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

#ifndef CGAL_SURFACE_MESH_CUTTING_UNWRAP_POLYGON_SOUP_H
#define CGAL_SURFACE_MESH_CUTTING_UNWRAP_POLYGON_SOUP_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/Interpretation.h>
#include <CGAL/Surface_mesh_cutting/Polygon_soup.h>
#include <CGAL/Surface_mesh_cutting/Unwrap_result.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Soup_adapter.h>
#include <CGAL/Surface_mesh_cutting/internal/run/run_pipeline.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// is the result of `unwrap_polygon_soup()`, besides the UVs.
struct Unwrap_soup_result : public Unwrap_result<Polygon_soup>
{
  /// the defects of the soup, and how they were read.
  std::vector<Interpretation> interpreted;
};

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// unwraps the surface that a polygon soup describes, as `unwrap()` does for meshes. The soup is never modified: points,
/// polygons and their order stay, and the surface is a reading of them.
/// - Polygons may have any number of corners, and need neither be convex nor quite flat. They are never cut.
/// - An edge with two polygons connects them; an edge with one is border. At an edge with more polygons, pairs stay
///   connected, chosen so that borders get short and sheets continue; the other polygons get a border there. A polygon is
///   never connected with its own reverse.
/// - A vertex whose polygons form several fans is as many vertices of the surface.
/// - If neighbors disagree about which side is up, as few polygons as possible are read backward. Their UVs are clockwise.
///   Surfaces with only one side are opened.
/// - Neighboring corners at the same vertex are one corner. A polygon may have a hole that is connected by a bridge, an edge
///   that it uses twice. Other polygons that visit a vertex more than once are divided into the loops between the visits.
/// - Polygons without area, or with the vertices of an earlier polygon in the same cyclic order, are not part of the
///   surface. They get UVs of the place where they lie.
/// - Points that no polygon uses may have any coordinates.
///
/// The cost of the reading is nearly linear in the size of the soup.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithms: `Sequential_tag` (default),
///         `Parallel_tag`, or `Parallel_if_available_tag`. The result does not depend on it.
/// \tparam PointRange a range of `%Point_3` of any kernel
/// \tparam PolygonRange a range of ranges of indices of points
/// \tparam CornerUVs a model of `BackInsertionSequence` whose value type can be constructed from two iterators over points,
///         such as `std::vector<std::vector<Point_2> >`; points can be constructed from two numbers and have members `x()`
///         and `y()`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param points the points
/// \param polygons the polygons
/// \param corner_uvs receives the UVs: `corner_uvs[p][k]` is that of corner `k` of polygon `p`, at the scale of the
///        surface. It stays unchanged unless `Cut_result::has_result`. Corners of degenerate polygons away from the surface
///        get any UV of it.
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of `unwrap()` but `vertex_point_map`,
///        and the two listed below. Vertices are indices of points, and edges are pairs (`std::pair<std::size_t, std::size_t>`) of them,
///        the lower one first. Such a pair may stand for several edges of the surface.
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{do_weld_points}
///     \cgalParamDescription{whether vertices at exactly the same point count as one}
///     \cgalParamType{Boolean}
///     \cgalParamDefault{`false`}
///     \cgalParamExtra{Soups from formats without indices, such as STL, need it.}
///   \cgalParamNEnd
///   \cgalParamNBegin{weld_tolerance}
///     \cgalParamDescription{with `do_weld_points`, vertices within this share of the bounding box diagonal also count as
///                           one, as do chains of such vertices}
///     \cgalParamType{`double` from 0 to 0.01}
///     \cgalParamDefault{`0`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the result of `unwrap()` for the surface, and the defects of the soup. Its `status` is one of those of
///         `unwrap()`; it is `Status_code::WRONG_PARAMETER` also for polygons that refer to points which do not exist, and
///         `Status_code::EMPTY_MESH` if no polygon is part of a surface.
///
/// \sa `unwrap()`
/// \sa `certify_unwrapped_polygon_soup()`
template <typename ConcurrencyTag = Sequential_tag, typename PointRange, typename PolygonRange, typename CornerUVs,
          typename NamedParameters = parameters::Default_named_parameters>
Unwrap_soup_result unwrap_polygon_soup(const PointRange& points, const PolygonRange& polygons, CornerUVs& corner_uvs,
                                       const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using UV = typename CornerUVs::value_type::value_type;

  std::vector<Interpretation> interpreted;
  const internal::Welding welding = {choose_parameter(get_parameter(np, internal_np::do_weld_points), false) ? internal::Welding::ON
                                                                                                             : internal::Welding::OFF,
                                     choose_parameter(get_parameter(np, internal_np::weld_tolerance), 0.), {}};
  Unwrap_soup_result result = internal::run_on_adapter<ConcurrencyTag, Unwrap_soup_result, UV>(
    [&](const internal::Go_further& go_further)
    {
      const internal::Welding_words words = {"do_weld_points(true)", "do_weld_points(true).weld_tolerance(", ")"};
      internal::Soup_adapter adapter(points, polygons, welding,
                                     Surface_mesh_parameterization::internal::execution_of<ConcurrencyTag>(), &words, go_further);
      interpreted = adapter.surface().findings;
      return adapter;
    },
    internal::Output_kind::MAP,
    [&](const auto& adapter, const internal::Mesh_result& found)
    {
      const std::vector<UV> uvs = adapter.template make_uvs<UV>(found.chart, found.uv);
      auto uv = uvs.begin();
      corner_uvs.clear();
      for(const auto& polygon : polygons)
      {
        const auto end = uv + std::ptrdiff_t(polygon.size());
        corner_uvs.emplace_back(uv, end);
        uv = end;
      }
    },
    np);
  result.interpreted = std::move(interpreted);
  return result;
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_UNWRAP_POLYGON_SOUP_H
