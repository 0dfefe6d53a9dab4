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

#ifndef CGAL_SURFACE_MESH_CUTTING_CUT_LENGTH_H
#define CGAL_SURFACE_MESH_CUTTING_CUT_LENGTH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// computes the length of a cut: the sum of the lengths of the marked edges.
/// Border edges are already open and do not count.
///
/// The computation takes place in `double`, with rounding; no square of a length overflows. The time is
/// linear in the number of edges.
///
/// \tparam TriangleMesh a model of `EdgeListGraph` and `HalfedgeGraph`
/// \tparam EdgeIsCutMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value
///         type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tmesh the surface
/// \param edge_is_cut_map marks the edges of the cut
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
/// \cgalNamedParamsEnd
///
/// \return the length of the cut
///
/// \sa `greedy_cut()`
template <typename TriangleMesh, typename EdgeIsCutMap,
          typename NamedParameters = parameters::Default_named_parameters>
double cut_length(const TriangleMesh& tmesh, EdgeIsCutMap edge_is_cut_map,
                  const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type vpm
    = choose_parameter(get_parameter(np, internal_np::vertex_point),
                       get_const_property_map(CGAL::vertex_point, tmesh));

  double length = 0;
  for(typename boost::graph_traits<TriangleMesh>::edge_descriptor e : edges(tmesh))
  {
    if(!get(edge_is_cut_map, e) || is_border(e, tmesh))
      continue;
    const auto& p = get(vpm, source(e, tmesh));
    const auto& q = get(vpm, target(e, tmesh));
    length += std::hypot(CGAL::to_double(q.x() - p.x()), CGAL::to_double(q.y() - p.y()),
                         CGAL::to_double(q.z() - p.z()));
  }
  return length;
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_CUT_LENGTH_H
