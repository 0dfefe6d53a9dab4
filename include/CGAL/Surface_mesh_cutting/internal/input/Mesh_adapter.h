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

#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_cutting/Status.h>
#include <CGAL/Surface_mesh_parameterization/internal/Bounding_box.h>
#include <CGAL/Surface_mesh_parameterization/internal/is_finite.h>
#include <CGAL/Surface_mesh_parameterization/internal/power_of_two_scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/to_vector.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#ifndef CGAL_SURFACE_MESH_CUTTING_USE_LIBRARY
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/check_mesh.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The boundary between the caller's mesh and the index arrays: checks the mesh, copies it, and
// carries cuts, UVs and findings to and fro. Vertices and faces are numbered by their positions in
// `vertices(tmesh)` and `faces(tmesh)`; corner 0 of a face is the source of its `halfedge(f,
// tmesh)`.
//
// The indexed mesh is scaled by a power of two, which loses no bit, to an extent of about one:
// products of lengths then neither overflow nor underflow.
template <typename TriangleMesh, typename VertexPointMap>
class Mesh_adapter
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;

public:
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using edge_descriptor = typename Graph_traits::edge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

  // O(n). The indexed mesh exists only where `status()` is OK.
  Mesh_adapter(const TriangleMesh& tmesh, VertexPointMap vpm)
    : m_tmesh(tmesh)
  {
    std::vector<Point> points;
    std::vector<Triangle> triangles;
    m_status = read_points(vpm, points);
    if(m_status)
      m_status = read_faces(triangles);
    if(!m_status)
      return;
    std::vector<int> opposites;
    m_status = read_opposites(triangles, opposites);
    if(!m_status)
      return;
    normalize(points, triangles);
    m_mesh = Indexed_mesh(std::move(points), std::move(triangles), std::move(opposites));
    m_status = check_mesh(m_mesh);
    constexpr int extreme = 332; // 1e100
    if(m_status && std::abs(m_exponent) > extreme)
      m_status.warnings.push_back(Finding{Status_code::OK, "extreme coordinates, which are rescaled internally",
                                          Element_kind::NONE, {}});
  }

  // Why the mesh is refused, or the warnings about it.
  const Indexed_status& status() const { return m_status; }
  const Indexed_mesh& mesh() const { return m_mesh; }

  // The caller's mesh is larger by 2 to this power.
  int exponent() const { return m_exponent; }

  // A length of the indexed mesh at the scale of the caller's mesh.
  double to_original_scale(double length) const { return std::ldexp(length, m_exponent); }

  vertex_descriptor to_vertex(int v) const { return m_vertices[v]; }
  face_descriptor to_face(int f) const { return m_faces[f]; }
  halfedge_descriptor to_halfedge(int h) const { return m_halfedges[h]; }
  edge_descriptor to_edge(int e) const { return edge(m_halfedges[m_mesh.halfedge(e)], m_tmesh); }

  // Marks on border edges are ignored.
  template <typename EdgeIsCutMap>
  Cut read_cut(EdgeIsCutMap edge_is_cut_map) const
  {
    Cut cut(m_mesh.number_of_edges(), 0);
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
      cut[e] = !m_mesh.is_border_edge(e) && get(edge_is_cut_map, to_edge(e));
    return cut;
  }

  // Writes `true` or `false` for each edge.
  template <typename EdgeIsCutMap>
  void write_cut(const Cut& cut, EdgeIsCutMap edge_is_cut_map) const
  {
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
      put(edge_is_cut_map, to_edge(e), bool(cut[e]));
  }

  // The UV of each corner, in the order of the indexed halfedges that start there. The map holds the
  // UV of a corner at the halfedge of its face that leads to it.
  template <typename HalfedgeUVMap>
  std::vector<Eigen::Vector2d> read_uvs(HalfedgeUVMap halfedge_uv_map) const
  {
    std::vector<Eigen::Vector2d> uvs(m_mesh.number_of_halfedges());
    for(int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      uvs[next_halfedge(h)]
        = Surface_mesh_parameterization::internal::to_vector_2(get(halfedge_uv_map, m_halfedges[h]));
    return uvs;
  }

  // What a map with this value type makes of a UV at the scale of the indexed mesh: it may hold fewer digits, and
  // what overflows or underflows at the scale of the caller's mesh does so here.
  template <typename Point_2>
  Eigen::Vector2d rounded_uv(const Eigen::Vector2d& uv) const
  {
    using namespace Surface_mesh_parameterization::internal;
    return scaled(to_vector_2(make_uv<Point_2>(uv)), -m_exponent);
  }

  // The inverse of `read_uvs()`, for UVs of the vertices of `chart` at the scale of the indexed mesh.
  template <typename HalfedgeUVMap>
  void write_uvs(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv,
                 HalfedgeUVMap halfedge_uv_map) const
  {
    using Point_2 = typename boost::property_traits<HalfedgeUVMap>::value_type;
    for(int h = 0; h < m_mesh.number_of_halfedges(); ++h)
      put(halfedge_uv_map, m_halfedges[h], make_uv<Point_2>(uv[chart.target(h)]));
  }

  // Replaces indices by descriptors and appends the first of them to the messages.
  Status<TriangleMesh> translate(const Indexed_status& flat) const
  {
    Status<TriangleMesh> status;
    static_cast<Surface_mesh_cutting::Finding<TriangleMesh>&>(status) = translate(flat.finding);
    for(const Finding& warning : flat.warnings)
      status.warnings.push_back(translate(warning));
    return status;
  }

private:
  template <typename Point_2>
  Point_2 make_uv(const Eigen::Vector2d& uv) const
  {
    using Number = std::decay_t<decltype(std::declval<const Point_2&>().x())>;
    const Eigen::Vector2d p = Surface_mesh_parameterization::internal::scaled(uv, m_exponent);
    return Point_2(static_cast<Number>(p.x()), static_cast<Number>(p.y()));
  }

  Surface_mesh_cutting::Finding<TriangleMesh> translate(const Finding& flat) const
  {
    Surface_mesh_cutting::Finding<TriangleMesh> finding;
    finding.code = flat.code;
    finding.message = flat.message + enumeration(flat);
    for(int i : flat.indices)
      switch(flat.kind)
      {
      case Element_kind::VERTEX: finding.vertices.push_back(to_vertex(i)); break;
      case Element_kind::EDGE:   finding.edges.push_back(to_edge(i)); break;
      case Element_kind::FACE:   finding.faces.push_back(to_face(i)); break;
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

  Indexed_status read_faces(std::vector<Triangle>& triangles)
  {
    auto index = get(CGAL::dynamic_vertex_property_t<int>(), m_tmesh);
    for(std::size_t v = 0; v < m_vertices.size(); ++v)
      put(index, m_vertices[v], int(v));

    triangles.reserve(num_faces(m_tmesh));
    m_faces.reserve(num_faces(m_tmesh));
    m_halfedges.reserve(3 * num_faces(m_tmesh));
    std::vector<int> other;
    for(face_descriptor f : faces(m_tmesh))
    {
      halfedge_descriptor h = halfedge(f, m_tmesh);
      Triangle t;
      bool is_triangle = true;
      for(int k = 0; k < 3; ++k, h = next(h, m_tmesh))
      {
        is_triangle = is_triangle && face(h, m_tmesh) == f;
        t[k] = get(index, source(h, m_tmesh));
        m_halfedges.push_back(h);
      }
      is_triangle = is_triangle && h == halfedge(f, m_tmesh) &&
                    t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
      if(!is_triangle)
        other.push_back(int(m_faces.size()));
      m_faces.push_back(f);
      triangles.push_back(t);
    }
    if(!other.empty())
      return Indexed_status(Status_code::NOT_TRIANGULATED,
                            "faces that do not have three different vertices",
                            Element_kind::FACE, std::move(other));
    if(m_faces.empty())
      return Indexed_status(Status_code::EMPTY_MESH, "the mesh has no face");
    return Indexed_status();
  }

  Indexed_status read_opposites(const std::vector<Triangle>& triangles,
                                std::vector<int>& opposites) const
  {
    auto index = get(CGAL::dynamic_halfedge_property_t<int>(), m_tmesh);
    for(std::size_t h = 0; h < m_halfedges.size(); ++h)
      put(index, m_halfedges[h], int(h));

    const auto corner = [&triangles](int h) { return triangles[h / 3][h % 3]; };
    opposites.reserve(m_halfedges.size());
    std::vector<int> misfits;
    for(int h = 0; h < int(m_halfedges.size()); ++h)
    {
      const halfedge_descriptor o = opposite(m_halfedges[h], m_tmesh);
      opposites.push_back(is_border(o, m_tmesh) ? -1 : get(index, o));
      if(opposites.back() >= 0 && (m_halfedges[opposites.back()] != o ||
                                   corner(opposites.back()) != corner(next_halfedge(h))))
        misfits.push_back(h / 3);
    }
    if(!misfits.empty())
      return Indexed_status(Status_code::NON_MANIFOLD,
                            "faces whose neighbors do not refer back to them",
                            Element_kind::FACE, std::move(misfits));
    return Indexed_status();
  }

  void normalize(std::vector<Point>& points, const std::vector<Triangle>& triangles)
  {
    Surface_mesh_parameterization::internal::Bounding_box<3> box;
    for(const Triangle& t : triangles)
      for(int v : t)
        box.add(points[v]);
    m_exponent = Surface_mesh_parameterization::internal::scale_exponent(box);
    for(Point& p : points)
      p = Surface_mesh_parameterization::internal::scaled(p, -m_exponent);
  }

  // ": faces 3, 5 and 1 more"; edges are named by their two vertices.
  std::string enumeration(const Finding& finding) const
  {
    if(finding.indices.empty() || finding.kind == Element_kind::NONE)
      return std::string();
    constexpr std::size_t maximum = 5;
    const bool is_plural = finding.indices.size() > 1;
    std::string text = ": ";
    text += finding.kind == Element_kind::VERTEX ? (is_plural ? "vertices" : "vertex")
          : finding.kind == Element_kind::EDGE   ? (is_plural ? "edges" : "edge")
                                                 : (is_plural ? "faces" : "face");
    for(std::size_t i = 0; i < (std::min)(maximum, finding.indices.size()); ++i)
    {
      const int index = finding.indices[i];
      text += i == 0 ? " " : ", ";
      if(finding.kind == Element_kind::EDGE)
        text += std::to_string(m_mesh.source(m_mesh.halfedge(index))) + "-"
              + std::to_string(m_mesh.target(m_mesh.halfedge(index)));
      else
        text += std::to_string(index);
    }
    if(finding.indices.size() > maximum)
      text += " and " + std::to_string(finding.indices.size() - maximum) + " more";
    return text;
  }

  const TriangleMesh& m_tmesh;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<halfedge_descriptor> m_halfedges;
  std::vector<face_descriptor> m_faces;
  int m_exponent = 0;
  Indexed_mesh m_mesh;
  Indexed_status m_status;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_MESH_ADAPTER_H
