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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_CUT_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_CUT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// One entry per edge of an indexed mesh: whether the surface is open there. Borders are open anyway and
// never marked.
using Cut = std::vector<char>;

inline double cut_length(const Indexed_mesh& mesh, const Cut& cut)
{
  double length = 0;
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    if(cut[e])
      length += mesh.length(e);
  return length;
}

// Of a path or any other set of edges.
inline double total_length(const Indexed_mesh& mesh, const std::vector<int>& edges)
{
  double length = 0;
  for(int e : edges)
    length += mesh.length(e);
  return length;
}

// The lower halfedge of each marked edge.
inline std::vector<int> cut_halfedges(const Indexed_mesh& mesh, const Cut& cut)
{
  std::vector<int> halfedges;
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    if(cut[e])
      halfedges.push_back(mesh.halfedge(e));
  return halfedges;
}

// Whether each vertex lies on the cut or on a border.
inline std::vector<char> open_vertices(const Indexed_mesh& mesh, const Cut& cut)
{
  std::vector<char> is_open(mesh.number_of_vertices(), 0);
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    if(cut[e] || mesh.is_border_edge(e))
      is_open[mesh.source(mesh.halfedge(e))] = is_open[mesh.target(mesh.halfedge(e))] = 1;
  return is_open;
}

// The number of cut edges at each vertex.
inline std::vector<int> cut_degrees(const Indexed_mesh& mesh, const Cut& cut)
{
  std::vector<int> degrees(mesh.number_of_vertices(), 0);
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    for(int v : {mesh.source(mesh.halfedge(e)), mesh.target(mesh.halfedge(e))})
      degrees[v] += cut[e];
  return degrees;
}

inline Cut make_cut(const Indexed_mesh& mesh, const std::vector<int>& edges)
{
  Cut cut(mesh.number_of_edges(), 0);
  for(int e : edges)
    cut[e] = 1;
  return cut;
}

// The surface opened along the cut; it may consist of several parts. O(n).
inline Corner_table make_chart(const Indexed_mesh& mesh, const Cut& cut)
{
  Corner_table chart(mesh.triangles(), mesh.opposites(), mesh.number_of_vertices());
  chart.open(cut_halfedges(mesh, cut));
  return chart;
}

inline std::vector<Point> chart_points(const Indexed_mesh& mesh, const Corner_table& chart)
{
  std::vector<Point> points;
  points.reserve(chart.number_of_vertices());
  for(int v : chart.origins())
    points.push_back(mesh.point(v));
  return points;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_CUT_H
