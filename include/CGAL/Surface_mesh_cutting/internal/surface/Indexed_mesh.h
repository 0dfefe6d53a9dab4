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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_INDEXED_MESH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_INDEXED_MESH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>

#include <Eigen/Core>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using Surface_mesh_parameterization::internal::Corner_table;
using Surface_mesh_parameterization::internal::Execution;
using Surface_mesh_parameterization::internal::Triangle;
using Surface_mesh_parameterization::internal::next_halfedge;
using Surface_mesh_parameterization::internal::previous_halfedge;

using CGAL::internal::Graph_kernel::Csr_graph;

using Point = Eigen::Vector3d;

// A triangle mesh in index arrays. Halfedge 3f+k leads from corner k of face f to corner k+1.
// Its vertices and edges are a graph in compressed rows, weighted by length.
class Indexed_mesh
{
public:
  Indexed_mesh() = default;

  // `opposites` holds, for each halfedge, the one across the edge, or -1 on a border. O(n).
  Indexed_mesh(std::vector<Point> points, std::vector<Triangle> triangles, std::vector<int> opposites,
               Execution execution = Execution::SEQUENTIAL)
    : m_points(std::move(points)), m_triangles(std::move(triangles)),
      m_opposites(std::move(opposites))
  {
    number_edges();
    m_lengths.resize(number_of_edges());
    std::vector<CGAL::internal::Graph_kernel::Edge> edges(number_of_edges());
    Surface_mesh_parameterization::internal::execute_blocks(execution, number_of_edges(), [&](int begin, int end)
    {
      for(int e = begin; e < end; ++e)
      {
        const int v = source(halfedge(e)), w = target(halfedge(e));
        m_lengths[e] = (m_points[v] - m_points[w]).norm();
        edges[e] = {v, w, m_lengths[e]};
      }
    });
    m_graph = Csr_graph(number_of_vertices(), std::move(edges));
  }

  int number_of_vertices() const { return int(m_points.size()); }
  int number_of_faces() const { return int(m_triangles.size()); }
  int number_of_halfedges() const { return int(m_opposites.size()); }
  int number_of_edges() const { return int(m_edge_halfedges.size()); }

  const std::vector<Point>& points() const { return m_points; }
  const std::vector<Triangle>& triangles() const { return m_triangles; }
  const std::vector<int>& opposites() const { return m_opposites; }
  const Point& point(int v) const { return m_points[v]; }

  int source(int h) const { return m_triangles[h / 3][h % 3]; }
  int target(int h) const { return source(next_halfedge(h)); }
  int opposite(int h) const { return m_opposites[h]; }
  bool is_border(int h) const { return m_opposites[h] < 0; }

  int edge(int h) const { return m_edges[h]; }
  // One halfedge of the edge, the lower one.
  int halfedge(int e) const { return m_edge_halfedges[e]; }
  bool is_border_edge(int e) const { return m_opposites[m_edge_halfedges[e]] < 0; }
  double length(int e) const { return m_lengths[e]; }
  const std::vector<double>& lengths() const { return m_lengths; }

  const Csr_graph& graph() const { return m_graph; }
  bool is_isolated(int v) const { return m_graph.degree(v) == 0; }

  double face_area(int f) const
  {
    const Triangle& t = m_triangles[f];
    using Surface_mesh_parameterization::internal::cross_product;
    return 0.5 * cross_product(m_points[t[1]] - m_points[t[0]], m_points[t[2]] - m_points[t[0]]).norm();
  }

private:
  // Edges are numbered in the order of their lower halfedges.
  void number_edges()
  {
    m_edges.assign(m_opposites.size(), -1);
    m_edge_halfedges.reserve(m_opposites.size() / 2);
    for(int h = 0; h < number_of_halfedges(); ++h)
    {
      const int o = m_opposites[h];
      if(o >= 0 && o < h)
      {
        m_edges[h] = m_edges[o];
        continue;
      }
      m_edges[h] = int(m_edge_halfedges.size());
      m_edge_halfedges.push_back(h);
    }
  }

  std::vector<Point> m_points;
  std::vector<Triangle> m_triangles;
  std::vector<int> m_opposites;
  std::vector<int> m_edges;          // per halfedge
  std::vector<int> m_edge_halfedges; // per edge
  std::vector<double> m_lengths;     // per edge
  Csr_graph m_graph;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_INDEXED_MESH_H
