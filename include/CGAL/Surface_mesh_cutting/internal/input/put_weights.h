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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_PUT_WEIGHTS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_PUT_WEIGHTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/Status.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Gives each edge its length times a factor: the smallest one where `property(mesh)` has 0 for the
// edge, 1 where it has 1, and linear in between.
// `property(mesh)` is a number for each edge, or nothing if the run was ended.
template <typename TriangleMesh, typename EdgeWeightMap, typename NamedParameters,
          typename Property>
Status<TriangleMesh> put_weights(const TriangleMesh& tmesh, EdgeWeightMap edge_weight_map,
                                 double smallest_factor, const NamedParameters& np,
                                 Property property)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type Vertex_point_map;
  const Mesh_adapter<TriangleMesh, Vertex_point_map> adapter(
    tmesh, choose_parameter(get_parameter(np, internal_np::vertex_point),
                            get_const_property_map(CGAL::vertex_point, tmesh)));
  Indexed_status status = adapter.status();
  if(status && !(smallest_factor >= 0 && smallest_factor <= 1))
    status = Indexed_status(Status_code::WRONG_PARAMETER, "smallest_factor must be between 0 and 1");
  if(status)
  {
    const Indexed_mesh& mesh = adapter.mesh();
    const std::optional<std::vector<double> > values = property(mesh);
    if(!values)
      status.finding = stopped_status().finding;
    for(int e = 0; e < mesh.number_of_edges() && values; ++e)
    {
      const double factor
        = mesh.is_border_edge(e) ? 1 : smallest_factor + (1 - smallest_factor) * (*values)[e];
      put(edge_weight_map, adapter.to_edge(e), adapter.to_original_scale(mesh.length(e) * factor));
    }
  }
  return adapter.translate(status);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_PUT_WEIGHTS_H
