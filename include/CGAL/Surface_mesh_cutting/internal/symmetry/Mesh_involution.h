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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_MESH_INVOLUTION_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_MESH_INVOLUTION_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/Reflection.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The map of a mesh to itself that a reflection suggests: from one side of a polygon and its image, all others follow. Diagonals of
// polygons have no images.
class Mesh_involution
{
public:
  // The references are kept; `diagonals` is empty if there are none. `nearest`: per vertex, the one closest to where it is
  // reflected, -1 without one.
  Mesh_involution(const Indexed_mesh& mesh, const Cut& diagonals, const std::vector<int>& nearest, const Reflection& reflection,
                  double tolerance)
    : m_mesh(mesh), m_diagonals(diagonals), m_nearest(nearest), m_reflection(reflection), m_tolerance(tolerance),
      m_vertex_images(mesh.number_of_vertices(), -1), m_images(mesh.number_of_halfedges(), -1)
  {
    int failures_left = 32; // vertices near to each other are mistaken somewhere; others lead to the same images
    for(int h = 0; h < mesh.number_of_halfedges() && failures_left > 0; ++h)
      if(m_images[h] < 0 && !is_diagonal(h))
      {
        const int image = near_image(h);
        failures_left -= !(image >= 0 && map_from(h, image));
      }
    m_is_complete = true;
    for(int h = 0; h < mesh.number_of_halfedges(); ++h)
      m_is_complete = m_is_complete && (m_images[h] >= 0 || is_diagonal(h));
    for(int v = 0; v < mesh.number_of_vertices(); ++v)
      m_is_complete = m_is_complete && (m_vertex_images[v] >= 0 || mesh.is_isolated(v));
  }

  // Whether all sides of polygons have an image.
  bool is_complete() const { return m_is_complete; }
  const std::vector<int>& vertex_images() const { return m_vertex_images; }
  // The image of an edge that is no diagonal.
  int edge_image(int e) const { return m_mesh.edge(m_images[m_mesh.halfedge(e)]); }

  // The plane that maps vertices to their images best, with the least sum of squares.
  Reflection best_reflection() const
  {
    Point middle = Point::Zero();
    int number = 0;
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(m_vertex_images[v] >= 0)
      {
        middle += m_mesh.point(v);
        ++number;
      }
    middle /= number;
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for(int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if(m_vertex_images[v] >= 0)
      {
        const Point p = m_mesh.point(v) - middle, q = m_mesh.point(m_vertex_images[v]) - middle;
        sum += p * q.transpose() + q * p.transpose();
      }
    const Eigen::Vector3d normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors().col(0);
    return Reflection{normal, normal.dot(middle)}.oriented();
  }

private:
  bool is_diagonal(int h) const { return !m_diagonals.empty() && m_diagonals[m_mesh.edge(h)] != 0; }

  int next_side(int h) const
  {
    for(h = next_halfedge(h); is_diagonal(h);)
      h = next_halfedge(m_mesh.opposite(h));
    return h;
  }

  int previous_side(int h) const
  {
    for(h = previous_halfedge(h); is_diagonal(h);)
      h = previous_halfedge(m_mesh.opposite(h));
    return h;
  }

  // The side between the vertices that are closest to the reflected ones, backward; -1 if there is none.
  int near_image(int h) const
  {
    const int source = m_nearest[m_mesh.target(h)], target = m_nearest[m_mesh.source(h)];
    if(source < 0 || target < 0)
      return -1;
    const auto& graph = m_mesh.graph();
    for(int a = graph.offsets[source]; a < graph.offsets[source + 1]; ++a)
      if(graph.arcs[a].target == target)
      {
        const int g = m_mesh.halfedge(graph.arcs[a].edge);
        for(const int side : {g, m_mesh.opposite(g)})
          if(side >= 0 && m_mesh.source(side) == source && !is_diagonal(side))
            return side;
      }
    return -1;
  }

  // Follows from `image` as that of `h`; what was mapped is taken back where that is not consistent.
  bool map_from(int h, int image)
  {
    std::vector<int> mapped, vertices;
    std::vector<std::pair<int, int> > open(1, {h, image});
    bool fits = true;
    while(fits && !open.empty())
    {
      const auto [a, b] = open.back();
      open.pop_back();
      if(m_images[a] < 0 && m_images[b] < 0)
      {
        m_images[a] = b;
        m_images[b] = a;
        mapped.push_back(a);
        const int c = m_mesh.opposite(a), d = m_mesh.opposite(b);
        fits = map_vertex(m_mesh.source(a), m_mesh.target(b), vertices) && (c < 0) == (d < 0);
        open.emplace_back(next_side(a), previous_side(b));
        open.emplace_back(previous_side(a), next_side(b));
        if(c >= 0 && d >= 0)
          open.emplace_back(c, d);
      }
      fits = fits && m_images[a] == b;
    }
    if(fits)
      return true;
    for(const int a : mapped)
      m_images[m_images[a]] = -1;
    for(const int a : mapped)
      m_images[a] = -1;
    for(const int v : vertices)
      m_vertex_images[v] = -1;
    return false;
  }

  // Each other's images, unless they are farther apart than that, or have other images.
  bool map_vertex(int v, int w, std::vector<int>& mapped)
  {
    if(m_vertex_images[v] == w && m_vertex_images[w] == v)
      return true;
    if(m_vertex_images[v] >= 0 || m_vertex_images[w] >= 0 ||
       (m_reflection(m_mesh.point(v)) - m_mesh.point(w)).norm() > m_tolerance)
      return false;
    m_vertex_images[v] = w;
    m_vertex_images[w] = v;
    mapped.push_back(v);
    mapped.push_back(w);
    return true;
  }

  const Indexed_mesh& m_mesh;
  const Cut& m_diagonals;
  const std::vector<int>& m_nearest;
  const Reflection m_reflection;
  const double m_tolerance;
  std::vector<int> m_vertex_images, m_images; // per halfedge that is a side
  bool m_is_complete;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_MESH_INVOLUTION_H
