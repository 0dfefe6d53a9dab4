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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_INDEXED_COMPONENT_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_INDEXED_COMPONENT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Topology.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A connected component of a mesh as a mesh of its own, without isolated vertices, and the indices
// that its elements have in the whole. The order of the elements is kept unless the component is large.
struct Indexed_component
{
  Indexed_mesh mesh;
  std::vector<int> vertices, edges, faces;
  Topology topology;

  // Marks the edges of the whole that `cut` marks in the component.
  void add_to(const Cut& cut, Cut& whole) const
  {
    for(std::size_t e = 0; e < edges.size(); ++e)
      if(cut[e])
        whole[edges[e]] = 1;
  }

  // The part of the marks of the whole that lies in the component.
  Cut restriction(const Cut& whole) const
  {
    Cut cut(edges.size());
    for(std::size_t e = 0; e < edges.size(); ++e)
      cut[e] = whole[edges[e]];
    return cut;
  }

  // Hands UVs over, from a chart of the component to one of the whole.
  void add_map(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv, const Corner_table& whole,
               std::vector<Eigen::Vector2d>& whole_uv) const
  {
    for(std::size_t f = 0; f < faces.size(); ++f)
      for(int k = 0; k < 3; ++k)
        whole_uv[whole.triangles()[faces[f]][k]] = uv[chart.triangles()[f][k]];
  }

  // Turns indices of the component into indices of the whole.
  Indexed_status in_whole(Indexed_status status) const
  {
    translate(status.finding);
    for(Finding& warning : status.warnings)
      translate(warning);
    return status;
  }

private:
  void translate(Finding& finding) const
  {
    for(int& i : finding.indices)
      i = finding.kind == Element_kind::VERTEX ? vertices[i]
        : finding.kind == Element_kind::EDGE   ? edges[i] : faces[i];
  }
};

// Meshes of so many faces outgrow the caches. Then neighbors should be close in memory: searches and solves take a
// third to a half of the time that they need for elements in a random order.
constexpr int number_of_faces_beyond_caches = 1 << 16;

// The faces that can be reached from a face across edges, in the order of a breadth-first search.
inline std::vector<int> faces_around(const Indexed_mesh& mesh, int face, std::vector<char>& is_seen)
{
  std::vector<int> faces(1, face);
  is_seen[face] = 1;
  for(std::size_t next = 0; next < faces.size(); ++next)
    for(int h = 3 * faces[next]; h < 3 * faces[next] + 3; ++h)
      if(!mesh.is_border(h) && !std::exchange(is_seen[mesh.opposite(h) / 3], char(1)))
        faces.push_back(mesh.opposite(h) / 3);
  return faces;
}

// For each edge of a mesh that consists of `faces` of the whole, in this order, its index there.
inline std::vector<int> edges_in_whole(const Indexed_mesh& mesh, const std::vector<int>& faces, const Indexed_mesh& whole)
{
  std::vector<int> edges;
  edges.reserve(std::size_t(mesh.number_of_edges()));
  for(int e = 0; e < mesh.number_of_edges(); ++e)
  {
    const int h = mesh.halfedge(e);
    edges.push_back(whole.edge(3 * faces[h / 3] + h % 3));
  }
  return edges;
}

// The component that consists of `faces`, in this order. `new_vertex` and `new_halfedge` are work space with an entry
// for each vertex and halfedge of the whole; those of the vertices are -1, before and after.
inline Indexed_component make_component(const Indexed_mesh& whole, std::vector<int> faces,
                                        std::vector<int>& new_vertex, std::vector<int>& new_halfedge)
{
  Indexed_component component;
  for(int f : faces)
    for(int v : whole.triangles()[f])
      if(std::exchange(new_vertex[v], 0) < 0)
        component.vertices.push_back(v);
  if(int(faces.size()) <= number_of_faces_beyond_caches)
    std::sort(component.vertices.begin(), component.vertices.end());
  std::vector<Point> points;
  points.reserve(component.vertices.size());
  for(int v : component.vertices)
  {
    new_vertex[v] = int(points.size());
    points.push_back(whole.point(v));
  }
  for(std::size_t i = 0; i < faces.size(); ++i)
    for(int k = 0; k < 3; ++k)
      new_halfedge[3 * faces[i] + k] = 3 * int(i) + k;
  std::vector<Triangle> triangles;
  std::vector<int> opposites;
  triangles.reserve(faces.size());
  opposites.reserve(3 * faces.size());
  for(int f : faces)
  {
    const Triangle& t = whole.triangles()[f];
    triangles.push_back({new_vertex[t[0]], new_vertex[t[1]], new_vertex[t[2]]});
    for(int h = 3 * f; h < 3 * f + 3; ++h)
      opposites.push_back(whole.is_border(h) ? -1 : new_halfedge[whole.opposite(h)]);
  }
  component.mesh = Indexed_mesh(std::move(points), std::move(triangles), std::move(opposites));
  component.edges = edges_in_whole(component.mesh, faces, whole);
  for(int v : component.vertices)
    new_vertex[v] = -1;
  component.faces = std::move(faces);
  return component;
}

// The components in the order of their lowest faces. A small connected mesh without isolated vertices is
// copied. O(n log n).
inline std::vector<Indexed_component> split_into_components(const Indexed_mesh& whole)
{
  const Connected_parts parts(whole.opposites());
  const std::vector<Topology> topology
    = topologies(make_chart(whole, Cut(whole.number_of_edges(), 0)), parts);
  const auto identity = [](int size)
  {
    std::vector<int> indices(size);
    std::iota(indices.begin(), indices.end(), 0);
    return indices;
  };
  bool has_isolated_vertex = false;
  for(int v = 0; v < whole.number_of_vertices(); ++v)
    has_isolated_vertex = has_isolated_vertex || whole.is_isolated(v);

  std::vector<Indexed_component> components;
  if(parts.number == 1 && !has_isolated_vertex && whole.number_of_faces() <= number_of_faces_beyond_caches)
  {
    components.resize(1);
    Indexed_component& c = components.front();
    c.vertices = identity(whole.number_of_vertices());
    c.edges = identity(whole.number_of_edges());
    c.faces = identity(whole.number_of_faces());
    c.topology = topology.front();
    c.mesh = whole;
    return components;
  }

  std::vector<std::vector<int> > faces(parts.number);
  for(int f = 0; f < whole.number_of_faces(); ++f)
    faces[parts.part[f]].push_back(f);
  std::vector<int> new_vertex(whole.number_of_vertices(), -1);
  std::vector<int> new_halfedge(whole.number_of_halfedges());
  std::vector<char> is_seen(whole.number_of_faces(), 0);
  for(int i = 0; i < parts.number; ++i)
  {
    if(int(faces[i].size()) > number_of_faces_beyond_caches)
      faces[i] = faces_around(whole, faces[i].front(), is_seen);
    components.push_back(make_component(whole, std::move(faces[i]), new_vertex, new_halfedge));
    components.back().topology = topology[i];
  }
  return components;
}

// Splits along the cut; indices refer to the uncut mesh, so that copies of an element share theirs.
// O(n log n).
inline std::vector<Indexed_component> split_along(const Indexed_mesh& mesh, const Cut& cut)
{
  if(std::find(cut.begin(), cut.end(), char(1)) == cut.end())
    return split_into_components(mesh);
  const Corner_table chart = make_chart(mesh, cut);
  std::vector<Point> points;
  for(int v : chart.origins())
    points.push_back(mesh.point(v));
  std::vector<Indexed_component> components
    = split_into_components(Indexed_mesh(std::move(points), chart.triangles(), chart.opposites()));
  for(Indexed_component& c : components)
  {
    for(int& v : c.vertices)
      v = chart.origins()[v];
    c.edges = edges_in_whole(c.mesh, c.faces, mesh);
  }
  return components;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_INDEXED_COMPONENT_H
