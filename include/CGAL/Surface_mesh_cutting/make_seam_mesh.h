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

#ifndef CGAL_SURFACE_MESH_CUTTING_MAKE_SEAM_MESH_H
#define CGAL_SURFACE_MESH_CUTTING_MAKE_SEAM_MESH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/boost/graph/Seam_mesh.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// opens a surface along a cut: makes the `CGAL::Seam_mesh` whose seams are the marked edges.
/// Border edges are already open and do not become seams.
///
/// The constructor of `Seam_mesh` takes the marks as they are and does not count the seam edges. This
/// function overwrites both maps for all edges and vertices and sets the number of seam edges. The
/// seam mesh holds copies of both maps and a reference to `tmesh`. The time is linear in the size of
/// the surface.
///
/// Include the header of the mesh type before this one, as for `Seam_mesh` itself.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsCutMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value
///         type
/// \tparam SeamEdgeMap a model of `ReadWritePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value
///         type
/// \tparam SeamVertexMap a model of `ReadWritePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `bool` as value
///         type
///
/// \param tmesh the surface
/// \param edge_is_cut_map marks the edges of the cut
/// \param seam_edge_map receives the seam edges; it may be the same map as `edge_is_cut_map`
/// \param seam_vertex_map receives the ends of the seam edges
///
/// \return the surface, open along the cut
///
/// \sa `CGAL::Surface_mesh_parameterization::parameterize()`
template <typename TriangleMesh, typename EdgeIsCutMap,
          typename SeamEdgeMap, typename SeamVertexMap>
Seam_mesh<TriangleMesh, SeamEdgeMap, SeamVertexMap>
make_seam_mesh(const TriangleMesh& tmesh, EdgeIsCutMap edge_is_cut_map,
               SeamEdgeMap seam_edge_map, SeamVertexMap seam_vertex_map)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;

  for(typename Graph_traits::vertex_descriptor v : vertices(tmesh))
    put(seam_vertex_map, v, false);
  typename Graph_traits::edges_size_type number_of_seams = 0;
  for(typename Graph_traits::edge_descriptor e : edges(tmesh))
  {
    const bool is_seam = get(edge_is_cut_map, e) && !is_border(e, tmesh);
    put(seam_edge_map, e, is_seam);
    if(!is_seam)
      continue;
    put(seam_vertex_map, source(e, tmesh), true);
    put(seam_vertex_map, target(e, tmesh), true);
    ++number_of_seams;
  }
  Seam_mesh<TriangleMesh, SeamEdgeMap, SeamVertexMap>
    seam_mesh(tmesh, seam_edge_map, seam_vertex_map);
  seam_mesh.set_seam_edges_number(number_of_seams);
  return seam_mesh;
}

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// opens a surface along a cut like the function above, with maps that live as long as the seam mesh.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam EdgeIsCutMap a model of `ReadablePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `bool` as value
///         type
///
/// \param tmesh the surface
/// \param edge_is_cut_map marks the edges of the cut
///
/// \return the surface, open along the cut
template <typename TriangleMesh, typename EdgeIsCutMap>
#ifdef DOXYGEN_RUNNING
Seam_mesh<TriangleMesh, unspecified_type, unspecified_type>
#else
Seam_mesh<TriangleMesh,
          typename boost::property_map<TriangleMesh, dynamic_edge_property_t<bool> >::const_type,
          typename boost::property_map<TriangleMesh, dynamic_vertex_property_t<bool> >::const_type>
#endif
make_seam_mesh(const TriangleMesh& tmesh, EdgeIsCutMap edge_is_cut_map)
{
  return make_seam_mesh(tmesh, edge_is_cut_map,
                        get(dynamic_edge_property_t<bool>(), tmesh),
                        get(dynamic_vertex_property_t<bool>(), tmesh));
}

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_MAKE_SEAM_MESH_H
