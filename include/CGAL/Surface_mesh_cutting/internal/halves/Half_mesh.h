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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_HALVES_HALF_MESH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_HALVES_HALF_MESH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_component.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/Indexed_symmetry.h>

#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// One half of a mesh that a reflection maps to itself, where its plane runs along edges.
class Half_mesh
{
public:
  // The references are kept; the symmetry is exact.
  Half_mesh(const Indexed_mesh& mesh, const Indexed_symmetry& symmetry)
    : m_mesh(mesh), m_symmetry(symmetry), m_plane(mesh.number_of_edges(), 0)
  {
    find_sides();
    m_is_divided = find_plane();
    if(m_is_divided)
      make_half();
  }

  // False if the plane crosses faces, or parts of the surface reach through it: then there is no half.
  bool is_divided() const { return m_is_divided; }
  const Indexed_component& half() const { return m_half; }
  // Whether each edge lies in the plane, between both halves.
  const Cut& plane() const { return m_plane; }

  int image(int e) const { return m_symmetry.edge_images[e]; } // -1 of a diagonal
  int vertex_image(int v) const { return m_symmetry.images[v]; }

  // The marked edges of the half, and their mirror images.
  Cut unfolded(const Cut& cut) const
  {
    Cut whole(m_mesh.number_of_edges(), 0);
    for(std::size_t e = 0; e < m_half.edges.size(); ++e)
      if(cut[e])
        whole[m_half.edges[e]] = whole[image(m_half.edges[e])] = 1;
    return whole;
  }

  // The vertices and their images, of which some may be the same.
  std::vector<int> unfolded(const std::vector<int>& vertices) const
  {
    std::vector<int> whole;
    for(const int v : vertices)
      for(const int w : {m_half.vertices[v], m_symmetry.images[m_half.vertices[v]]})
        if(whole.empty() || whole.back() != w)
          whole.push_back(w);
    return whole;
  }

private:
  bool is_diagonal(int e) const { return image(e) < 0; }

  // A polygon is where its middle is.
  void find_sides()
  {
    const int size = m_mesh.number_of_faces();
    CGAL::internal::Graph_kernel::Disjoint_sets polygons(size);
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
      if(is_diagonal(e))
        polygons.unite(m_mesh.halfedge(e) / 3, m_mesh.opposite(m_mesh.halfedge(e)) / 3);
    std::vector<double> heights(size, 0);
    for(int f = 0; f < size; ++f)
      for(const int v : m_mesh.triangles()[f])
        heights[polygons.find(f)] += m_symmetry.reflection.signed_distance(m_mesh.point(v));
    for(int f = 0; f < size; ++f)
      m_is_in_half.push_back(heights[polygons.find(f)] > 0);
  }

  // False unless all faces have their images on the other side, and edges between both sides stay in place.
  bool find_plane()
  {
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
    {
      if(is_diagonal(e))
        continue;
      const int h = m_mesh.halfedge(e), g = m_mesh.halfedge(image(e));
      if(m_mesh.is_border(h))
      {
        if(!m_mesh.is_border(g) || m_is_in_half[h / 3] == m_is_in_half[g / 3])
          return false;
        continue;
      }
      const bool first = m_is_in_half[h / 3], second = m_is_in_half[m_mesh.opposite(h) / 3];
      m_plane[e] = first != second;
      if(m_plane[e] ? g != h || moves(m_mesh.source(h)) || moves(m_mesh.target(h))
                    : m_is_in_half[g / 3] == char(first) || m_is_in_half[m_mesh.opposite(g) / 3] == char(first))
        return false;
    }
    return true;
  }

  bool moves(int v) const { return m_symmetry.images[v] != v; }

  // Vertices of the plane at which the half touches itself are copied, as where a mesh is opened.
  void make_half()
  {
    const Corner_table chart = make_chart(m_mesh, m_plane);
    const Indexed_mesh opened(chart_points(m_mesh, chart), chart.triangles(), chart.opposites());
    std::vector<int> faces;
    for(int f = 0; f < m_mesh.number_of_faces(); ++f)
      if(m_is_in_half[f])
        faces.push_back(f);
    std::vector<int> new_vertex(opened.number_of_vertices(), -1), new_halfedge(opened.number_of_halfedges());
    m_half = make_component(opened, std::move(faces), new_vertex, new_halfedge);
    for(int& v : m_half.vertices)
      v = chart.origins()[v];
    m_half.edges = edges_in_whole(m_half.mesh, m_half.faces, m_mesh);
  }

  const Indexed_mesh& m_mesh;
  const Indexed_symmetry& m_symmetry;
  std::vector<char> m_is_in_half; // per face
  Cut m_plane;
  bool m_is_divided = false;
  Indexed_component m_half;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_HALVES_HALF_MESH_H
