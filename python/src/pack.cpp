// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#include "pack.h"

#include "chart_vertices.h"

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/read_packing_parameters.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/mirrored_vertices.h>

#include <boost/range/adaptor/transformed.hpp>
#include <boost/range/irange.hpp>

namespace binding {

namespace {

using SMC::internal::Indexed_status;

// The UVs of the corners, polygon by polygon.
auto uv_ranges(const Polygon_soup_view& soup, const Numbers& corner_uv)
{
  const auto uv = [corner_uv](std::int64_t c) { return Eigen::Vector2d(corner_uv.begin() + 2 * c); };
  return boost::irange(std::ptrdiff_t(0), std::ptrdiff_t(soup.number_of_polygons())) | boost::adaptors::transformed(
           [&soup, uv](std::ptrdiff_t p)
           { return boost::irange(soup.offsets[p], soup.offsets[p + 1]) | boost::adaptors::transformed(uv); });
}

// The surface and the UVs at the sources of its halfedges, unless the status says why there is none.
struct Mapped_surface
{
  Soup_adapter adapter;
  Indexed_status status;
  std::vector<Eigen::Vector2d> uv;

  Mapped_surface(Named_surface& surface, const Numbers& corner_uv)
    : adapter(surface.read()), status(adapter.status())
  {
    const Polygon_soup_view& soup = surface.arguments().soup;
    if(status)
      status.finding = adapter.read_uvs(soup.polygons(), uv_ranges(soup, corner_uv), uv).finding;
  }

  SMC::internal::Corner_table chart() const { return make_chart(adapter.mesh(), adapter.cut_between(uv)); }
};

// The UV of each corner of the soup.
std::vector<double> uvs_of_corners(const Soup_adapter& adapter, const SMC::internal::Corner_table& chart,
                                   const std::vector<Eigen::Vector2d>& uv)
{
  std::vector<double> result;
  result.reserve(2 * adapter.surface().corners.size());
  for(const int v : chart_vertices_of_corners(adapter, chart))
    result.insert(result.end(), {uv[v].x(), uv[v].y()});
  return result;
}

} // namespace

SMC::internal::Indexed_packing pack(const Soup_adapter& adapter, const SMC::internal::Corner_table& chart,
                                    const std::vector<Eigen::Vector2d>& corner_uv, const Packing_options& options,
                                    bool do_bijective, Run_monitor& monitor)
{
  const SMC::internal::Packing_parameters parameters{{options.margin, options.texture_size}, do_bijective, options.effort,
                                                   options.rotation,
                                                   options.pages > 0 || options.texels_per_unit > 0 ? options.pages : 1,
                                                   options.texels_per_unit, false};
  SMC::internal::Indexed_packing result;
  result.status = check_parameters(parameters);
  if(result.status)
  {
    SMC::internal::Run_control control([&] { return monitor.go_further(); },
                                       [&](SMC::Phase phase, double fraction) { monitor.progress(phase, fraction); });
    constexpr SMC::internal::Execution execution = CGAL::internal::Graph_kernel::execution_of<Concurrency_tag>();
    result = SMC::internal::pack_indexed_charts(
      chart, corner_uv, SMC::internal::mirrored_vertices(adapter, chart, options.symmetry, execution), parameters,
      [](const Eigen::Vector2d& uv) { return uv; }, execution, control);
  }
  return result;
}

Packed_surface pack_surface(const Surface_arguments& arguments, const Numbers& corner_uv, const Packing_options& options,
                            bool do_bijective, Run_monitor& monitor)
{
  Packed_surface result;
  try
  {
    Named_surface surface(arguments);
    Mapped_surface mapped(surface, corner_uv);
    if(mapped.status)
    {
      const SMC::internal::Corner_table chart = mapped.chart();
      const SMC::internal::Indexed_packing packing = pack(mapped.adapter, chart, mapped.uv, options, do_bijective, monitor);
      mapped.status.finding = packing.status.finding;
      result.has_result = packing.has_result;
      result.scale = packing.scale;
      result.fill = packing.fill;
      result.page_fills = packing.page_fills;
      result.number_of_charts = packing.number_of_charts;
      if(packing.has_result)
        result.corner_uv = uvs_of_corners(mapped.adapter, chart, packing.uv);
    }
    result.status = mapped.adapter.translate(mapped.status);
  }
  catch(const Refusal& refusal)
  {
    static_cast<Finding&>(result.status) = refusal.finding;
  }
  return result;
}

Result_status certify_surface(const Surface_arguments& arguments, const Numbers& corner_uv, bool do_bijective)
{
  Result_status result;
  try
  {
    Named_surface surface(arguments);
    Mapped_surface mapped(surface, corner_uv);
    if(mapped.status)
      mapped.status.finding = SMC::internal::certify_indexed_map(mapped.chart(), mapped.uv, do_bijective).finding;
    result = mapped.adapter.translate(mapped.status);
  }
  catch(const Refusal& refusal)
  {
    static_cast<Finding&>(result) = refusal.finding;
  }
  return result;
}

} // namespace binding
