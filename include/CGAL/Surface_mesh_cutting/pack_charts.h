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

#ifndef CGAL_SURFACE_MESH_CUTTING_PACK_CHARTS_H
#define CGAL_SURFACE_MESH_CUTTING_PACK_CHARTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/Packing_result.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/read_packing_parameters.h>
#include <CGAL/Surface_mesh_cutting/internal/run/read_run_control.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/mirrored_vertices.h>

#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <Eigen/Core>

#include <type_traits>
#include <utility>

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/find_indexed_symmetries.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/pack_indexed_charts.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// moves charts into the unit square, ready for a texture: turns and translates each one and scales all by the same
/// factor, which it makes large. It considers outlines, not boxes: small charts find places in the bays and holes of large
/// ones.
///
/// Charts may fill several pages at one scale, or be given a scale, from which the number of pages follows. Pages are the
/// squares of a grid, as UDIM counts them: page `i` is the unit square moved by `i % 10` to the right and `i / 10` up.
///
/// A chart is a part of the surface that is connected through edges not cut; it need not be a disk.
///
/// The function proves the result as `certify_packing()` does, with the coordinates that `halfedge_uv_map` holds; they may
/// also be of type `float` or of an exact number type. Where `allow_flips` lets a triangle be clockwise, the proof is about outlines
/// alone.
///
/// Charts are drawn on grids of 512 to 4096 cells along a side, in up to 16 turns. The time on a grid is \f$ O(c r) \f$ for \f$ c \f$
/// charts and \f$ r \f$ rows that are full: seconds for thousands of charts. On one page and without `texels_per_unit`, up to 1000
/// charts then leave the grid and push each other apart: some seconds for a hundred charts. Up to 100 charts are packed twice with
/// `Chart_rotation::AUTOMATIC`.
///
/// \tparam ConcurrencyTag enables sequential versus parallel algorithms: `Sequential_tag` (default),
///         `Parallel_tag`, or `Parallel_if_available_tag`. The result does not depend on it.
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsCutMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value type
/// \tparam HalfedgeUVMap a model of `ReadWritePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%halfedge_descriptor` as key type and a value type that
///         can be constructed from two numbers and has members `x()` and `y()`, such as `%Point_2` of any kernel
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface
/// \param edge_is_cut_map marks the edges of the cut; marks on border edges are ignored
/// \param halfedge_uv_map holds at each halfedge `h` that is not on the border the UV of the corner
///        of `face(h, tmesh)` at `target(h, tmesh)`; all triangles are counterclockwise
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
///   \cgalParamNBegin{chart_rotation}
///     \cgalParamDescription{how charts may be turned}
///     \cgalParamType{`Surface_mesh_cutting::Chart_rotation`}
///     \cgalParamDefault{`Chart_rotation::AUTOMATIC`}
///   \cgalParamNEnd
///   \cgalParamNBegin{symmetry}
///     \cgalParamDescription{a reflection that maps the surface and its cut to themselves: charts that are mirror images of
///                           each other then lie side by side as such, see \ref smc_packing_symmetry}
///     \cgalParamType{`Surface_mesh_cutting::Symmetry`}
///     \cgalParamDefault{`Symmetry::NONE`}
///     \cgalParamExtra{Without such a reflection, charts are placed as usual.}
///   \cgalParamNEnd
///   \cgalParamNBegin{texels_per_unit}
///     \cgalParamDescription{the number of texels to which a unit of length in the given UVs is scaled, on as few pages as the
///                           function finds; 0 stands for as many texels as fit}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_pages}
///     \cgalParamDescription{the number of pages to fill or, with `texels_per_unit`, the largest one allowed; there, 0 stands
///                           for any number}
///     \cgalParamType{`int`}
///     \cgalParamDefault{`1`; with `texels_per_unit`, `0`}
///   \cgalParamNEnd
///   \cgalParamNBegin{allow_flips}
///     \cgalParamDescription{whether charts may be mirrored, as a whole or in parts, such as those of other programs; they stay
///                           so. A chart that is folded keeps its distances with its convex hull, which then also is what
///                           the filled area and the proof are about}
///     \cgalParamType{Boolean}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{do_bijective}
///     \cgalParamDescription{whether to refuse charts that overlap themselves}
///     \cgalParamType{Boolean}
///     \cgalParamDefault{`false`}
///     \cgalParamExtra{It has no effect where `allow_flips` lets a triangle be clockwise.}
///   \cgalParamNEnd
///   \cgalParamNBegin{effort}
///     \cgalParamDescription{how long to search for a larger scale}
///     \cgalParamType{`Surface_mesh_cutting::Effort`}
///     \cgalParamDefault{`Effort::DEFAULT`}
///     \cgalParamExtra{`Effort::FAST` makes a tenth of the tries off the grid, `Effort::BEST` four times as many.}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tmesh`}
///     \cgalParamType{a class model of `ReadablePropertyMap` with
///                    `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and
///                    `%Point_3` as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{follows the progress and can end the run once a first packing is found: it is called before
///                           each long step}
///     \cgalParamType{a class model of `CuttingVisitor`}
///     \cgalParamDefault{`Surface_mesh_cutting::Default_visitor`}
///     \cgalParamExtra{It is copied; pass it by `std::ref` to keep it.}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{the time in seconds after which the run ends as if the visitor ended it; 0 means no limit, and a
///                           negative value ends the run at once}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`0`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the scale, the filled area and the number of charts. Its `status` is one of
/// - `Status_code::OK`;
/// - `Status_code::NOT_CERTIFIED`, with the faces concerned, if UVs are not finite, differ where no edge is cut, or a
///   triangle is not counterclockwise (unless `allow_flips`), or, with `do_bijective`, if triangles overlap; or if rounding spoils
///   the result;
/// - `Status_code::INFEASIBLE_CONSTRAINTS` if there are so many charts that their margins leave no room; with
///   `texels_per_unit`, if a chart is larger than a page, or the charts find no room on `number_of_pages` pages;
/// - `Status_code::WRONG_PARAMETER`;
/// - `Status_code::STOPPED` if the visitor or the time limit ended the run; the charts are packed, but could be larger;
/// - `Status_code::EMPTY_MESH`, `Status_code::NOT_TRIANGULATED`, `Status_code::NON_MANIFOLD` or
///   `Status_code::INVALID_POINT` for an unsupported mesh.
///
/// The UVs stay unchanged unless `Packing_result::has_result`.
///
/// \sa `unwrap()`
/// \sa `certify_packing()`
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename EdgeIsCutMap,
          typename HalfedgeUVMap, typename NamedParameters = parameters::Default_named_parameters>
Packing_result<TriangleMesh> pack_charts(const TriangleMesh& tmesh, EdgeIsCutMap edge_is_cut_map,
                                         HalfedgeUVMap halfedge_uv_map,
                                         const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;
  using UV = typename boost::property_traits<HalfedgeUVMap>::value_type;
  using Number = std::decay_t<decltype(std::declval<const UV&>().x())>;

  Default_visitor default_visitor;
  internal::Visitor_reference<NamedParameters> visitor
    = choose_parameter(get_parameter_reference(np, internal_np::visitor), default_visitor);
  internal::Run_control control = internal::read_run_control(visitor, np);
  const auto adapter = internal::make_mesh_adapter(
    tmesh, np, Surface_mesh_parameterization::internal::execution_of<ConcurrencyTag>());
  const internal::Packing_parameters parameters = internal::read_packing_parameters(np);

  Packing_result<TriangleMesh> result;
  internal::Indexed_status status = adapter.status();
  if(status)
    status.finding = internal::check_parameters(parameters).finding;
  if(status)
  {
    const auto make_uv = [](const Eigen::Vector2d& uv)
    { return UV(static_cast<Number>(uv.x()), static_cast<Number>(uv.y())); };
    const auto round = [make_uv](const Eigen::Vector2d& uv)
    { return Surface_mesh_parameterization::internal::to_vector_2(make_uv(uv)); };
    const internal::Corner_table chart = internal::make_chart(adapter.mesh(), adapter.read_cut(edge_is_cut_map));
    constexpr internal::Execution execution = Surface_mesh_parameterization::internal::execution_of<ConcurrencyTag>();
    const Symmetry symmetry = choose_parameter(get_parameter(np, internal_np::symmetry), Symmetry::NONE);
    const internal::Indexed_packing packing = internal::pack_indexed_charts(
      chart, adapter.read_uvs(halfedge_uv_map), internal::mirrored_vertices(adapter, chart, symmetry, execution), parameters,
      round, execution, control);
    status.finding = packing.status.finding;
    result.has_result = packing.has_result;
    if(result.has_result)
      for(int h = 0; h < adapter.mesh().number_of_halfedges(); ++h)
        put(halfedge_uv_map, adapter.to_halfedge_at_source(h), make_uv(packing.uv[chart.source(h)]));
    result.scale = packing.scale;
    result.fill = packing.fill;
    result.page_fills = packing.page_fills;
    result.number_of_charts = packing.number_of_charts;
  }
  result.status = adapter.translate(status);
  return result;
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_PACK_CHARTS_H
