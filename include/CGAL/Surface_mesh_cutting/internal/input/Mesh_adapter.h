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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_MESH_ADAPTER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_MESH_ADAPTER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/input/Polygon_adapter.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/Result_status.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The boundary between the caller's mesh and the index arrays: checks the mesh, copies it, triangulating its
// polygons, and carries cuts, UVs and findings to and fro. Vertices and faces are numbered by their positions in
// `vertices(tmesh)` and `faces(tmesh)`; corner 0 of a face is the source of its `halfedge(f,
// tmesh)`.
template <typename TriangleMesh, typename VertexPointMap>
class Mesh_adapter : public Polygon_adapter
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;

public:
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using edge_descriptor = typename Graph_traits::edge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

  // O(n). The indexed mesh exists only where `status()` is OK.
  Mesh_adapter(const TriangleMesh& tmesh, VertexPointMap vpm, Execution execution = Execution::SEQUENTIAL,
               const Go_further& go_further = always_go_further)
    : m_tmesh(tmesh)
  {
    std::vector<Point> points;
    std::vector<int> opposites;
    m_status = read_points(vpm, points);
    if(m_status)
      read_faces();
    if(m_status)
      read_opposites(opposites);
    if(m_status)
      make_mesh(std::move(points), m_outlines, opposites, execution, go_further);
  }

  vertex_descriptor to_vertex(int v) const { return m_vertices[v]; }
  face_descriptor to_face(int f) const { return m_faces[to_polygon(f)]; }
  // Of a side of a polygon, as all that may be cut is one.
  halfedge_descriptor to_halfedge(int h) const { return m_halfedges[to_side(h)]; }
  edge_descriptor to_edge(int e) const { return edge(to_halfedge(mesh().halfedge(e)), m_tmesh); }

  // The halfedge of the caller's mesh that leads to the corner from which a halfedge of the indexed mesh starts.
  halfedge_descriptor to_halfedge_at_source(int h) const
  {
    return m_halfedges[m_outlines.previous(to_polygon(h / 3), to_corner(h))];
  }

  // Marks on border edges are ignored.
  template <typename EdgeIsCutMap>
  Cut read_cut(EdgeIsCutMap edge_is_cut_map) const
  {
    Cut cut(mesh().number_of_edges(), 0);
    for(int e = 0; e < mesh().number_of_edges(); ++e)
      cut[e] = !mesh().is_border_edge(e) && !is_diagonal(e) && get(edge_is_cut_map, to_edge(e));
    return cut;
  }

  // Writes `true` or `false` for each edge.
  template <typename EdgeIsCutMap>
  void write_cut(const Cut& cut, EdgeIsCutMap edge_is_cut_map) const
  {
    for(int e = 0; e < mesh().number_of_edges(); ++e)
      if(!is_diagonal(e))
        put(edge_is_cut_map, to_edge(e), bool(cut[e]));
  }

  // The UV of each corner, in the order of the indexed halfedges that start there. The map holds the
  // UV of a corner at the halfedge of its face that leads to it.
  template <typename HalfedgeUVMap>
  std::vector<Eigen::Vector2d> read_uvs(HalfedgeUVMap halfedge_uv_map) const
  {
    std::vector<Eigen::Vector2d> uvs(mesh().number_of_halfedges());
    for(int h = 0; h < mesh().number_of_halfedges(); ++h)
      uvs[h] = Surface_mesh_parameterization::internal::to_vector_2(get(halfedge_uv_map, to_halfedge_at_source(h)));
    return uvs;
  }

  // The inverse of `read_uvs()`, for UVs of the vertices of `chart` at the scale of the indexed mesh.
  template <typename HalfedgeUVMap>
  void write_uvs(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv,
                 HalfedgeUVMap halfedge_uv_map) const
  {
    using Point_2 = typename boost::property_traits<HalfedgeUVMap>::value_type;
    for(int h = 0; h < mesh().number_of_halfedges(); ++h)
      put(halfedge_uv_map, to_halfedge_at_source(h), make_uv<Point_2>(uv[chart.source(h)]));
  }

  // Replaces indices by descriptors and appends the first of them to the messages.
  Result_status<TriangleMesh> translate(const Indexed_status& flat) const
  {
    return translated<TriangleMesh>(flat, [this](const Finding& finding) { return translate(finding); });
  }

private:
  Surface_mesh_cutting::Finding<TriangleMesh> translate(const Finding& of_triangles) const
  {
    const Finding flat = in_polygons(of_triangles);
    Surface_mesh_cutting::Finding<TriangleMesh> finding;
    finding.code = flat.code;
    finding.message = flat.message + enumeration(flat, [](int i) { return i; });
    for(int i : flat.indices)
      switch(flat.kind)
      {
      case Element_kind::VERTEX: finding.vertices.push_back(to_vertex(i)); break;
      case Element_kind::EDGE:   finding.edges.push_back(to_edge(i)); break;
      case Element_kind::FACE:   finding.faces.push_back(m_faces[i]); break;
      case Element_kind::NONE:   break;
      }
    return finding;
  }

  Indexed_status read_points(VertexPointMap vpm, std::vector<Point>& points)
  {
    points.reserve(num_vertices(m_tmesh));
    m_vertices.reserve(num_vertices(m_tmesh));
    std::vector<int> invalid;
    for(vertex_descriptor v : vertices(m_tmesh))
    {
      points.push_back(Surface_mesh_parameterization::internal::to_vector_3(get(vpm, v)));
      if(!Surface_mesh_parameterization::internal::is_finite(points.back()))
        invalid.push_back(int(m_vertices.size()));
      m_vertices.push_back(v);
    }
    if(!invalid.empty())
      return Indexed_status(Status_code::INVALID_POINT,
                            "vertices with a coordinate that is infinite or not a number",
                            Element_kind::VERTEX, std::move(invalid));
    return Indexed_status();
  }

  void read_faces()
  {
    auto index = get(CGAL::dynamic_vertex_property_t<int>(), m_tmesh);
    for(std::size_t v = 0; v < m_vertices.size(); ++v)
      put(index, m_vertices[v], int(v));

    m_outlines.ends.reserve(num_faces(m_tmesh));
    m_outlines.vertices.reserve(num_halfedges(m_tmesh));
    m_faces.reserve(num_faces(m_tmesh));
    m_halfedges.reserve(num_halfedges(m_tmesh));
    const std::size_t number_of_halfedges = num_halfedges(m_tmesh);
    std::vector<int> other;
    for(face_descriptor f : faces(m_tmesh))
    {
      halfedge_descriptor h = halfedge(f, m_tmesh);
      do
      {
        if(face(h, m_tmesh) != f || m_halfedges.size() == number_of_halfedges)
        {
          other.push_back(int(m_faces.size()));
          break;
        }
        m_outlines.vertices.push_back(get(index, source(h, m_tmesh)));
        m_halfedges.push_back(h);
        h = next(h, m_tmesh);
      }
      while(h != halfedge(f, m_tmesh));
      m_faces.push_back(f);
      m_outlines.close();
    }
    for(int f = 0; f < m_outlines.number(); ++f)
      if(!m_outlines.has_sides(f))
        other.push_back(f);
    if(!other.empty())
      refuse_polygons(Status_code::NOT_TRIANGULATED, "faces that do not have three different vertices or more",
                      std::move(other));
    else if(m_faces.empty())
      m_status = Indexed_status(Status_code::EMPTY_MESH, "the mesh has no face");
  }

  void read_opposites(std::vector<int>& opposites)
  {
    auto index = get(CGAL::dynamic_halfedge_property_t<int>(), m_tmesh);
    for(std::size_t h = 0; h < m_halfedges.size(); ++h)
      put(index, m_halfedges[h], int(h));

    opposites.reserve(m_halfedges.size());
    std::vector<int> misfits;
    for(int polygon = 0; polygon < m_outlines.number(); ++polygon)
      for(int h = m_outlines.begin(polygon); h < m_outlines.end(polygon); ++h)
      {
        const halfedge_descriptor o = opposite(m_halfedges[h], m_tmesh);
        const int i = get(index, o); // anything where `o` is not a side
        const bool is_side = i >= 0 && i < int(m_halfedges.size()) && m_halfedges[i] == o;
        opposites.push_back(is_side ? i : -1);
        const bool fits = is_side ? m_outlines.vertices[i] == m_outlines.vertices[m_outlines.next(polygon, h)]
                                  : is_border(o, m_tmesh);
        if(!fits && (misfits.empty() || misfits.back() != polygon))
          misfits.push_back(polygon);
      }
    if(!misfits.empty())
      refuse_polygons(Status_code::NON_MANIFOLD, "faces whose neighbors do not refer back to them",
                      std::move(misfits));
  }

  const TriangleMesh& m_tmesh;
  std::vector<vertex_descriptor> m_vertices;
  Polygons m_outlines;                          // of the faces
  std::vector<halfedge_descriptor> m_halfedges; // of their sides
  std::vector<face_descriptor> m_faces;
};

// With the points that the named parameters give.
template <typename TriangleMesh, typename NamedParameters>
auto make_mesh_adapter(const TriangleMesh& tmesh, const NamedParameters& np, Execution execution = Execution::SEQUENTIAL,
                       const Go_further& go_further = always_go_further)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type Vertex_point_map;
  return Mesh_adapter<TriangleMesh, Vertex_point_map>(
    tmesh, choose_parameter(get_parameter(np, internal_np::vertex_point),
                            get_const_property_map(CGAL::vertex_point, tmesh)),
    execution, go_further);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_MESH_ADAPTER_H
