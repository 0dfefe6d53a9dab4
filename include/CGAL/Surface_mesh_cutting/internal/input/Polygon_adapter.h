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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_POLYGON_ADAPTER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_POLYGON_ADAPTER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Result_status.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Polygons.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Execution.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using CGAL::internal::Graph_kernel::Go_further;
using CGAL::internal::Graph_kernel::always_go_further;

// What the adapters of meshes and of polygon soups have in common: the triangles of the caller's polygons as an
// indexed mesh, and where they come from.
//
// The indexed mesh is scaled by a power of two, which loses no bit, to an extent of about one:
// products of lengths then neither overflow nor underflow.
class Polygon_adapter
{
public:
  // Why the surface is refused. The indexed mesh exists only where this is OK.
  const Indexed_status& status() const { return m_status; }
  // What is unusual about it, though handled. O(n log n).
  std::vector<Finding> warnings() const;
  const Indexed_mesh& mesh() const { return m_mesh; }

  // The caller's surface is larger by 2 to this power.
  int exponent() const { return m_exponent; }

  // A length of the indexed mesh at the scale of the caller's surface.
  double to_original_scale(double length) const { return std::ldexp(length, m_exponent); }

  // The corner of a polygon from which a halfedge starts.
  int to_corner(int h) const { return m_corners[h]; }
  // The side of a polygon that a halfedge is, -1 for a diagonal.
  int to_side(int h) const { return m_sides[h]; }
  int to_polygon(int f) const { return m_polygons[f]; }
  // Whether an edge lies inside a polygon: the caller's surface does not have it.
  bool is_diagonal(int e) const { return m_sides[m_mesh.halfedge(e)] < 0; }
  bool has_diagonals() const { return std::find(m_sides.begin(), m_sides.end(), -1) != m_sides.end(); }

  // What a map with this value type makes of a UV at the scale of the indexed mesh: it may hold fewer digits, and
  // what overflows or underflows at the scale of the caller's surface does so here.
  template <typename Point_2>
  Eigen::Vector2d rounded_uv(const Eigen::Vector2d& uv) const
  {
    using namespace Surface_mesh_parameterization::internal;
    return scaled(to_vector_2(make_uv<Point_2>(uv)), -m_exponent);
  }

protected:
  template <typename Point_2>
  Point_2 make_uv(const Eigen::Vector2d& uv) const
  {
    using Number = std::decay_t<decltype(std::declval<const Point_2&>().x())>;
    const Eigen::Vector2d p = Surface_mesh_parameterization::internal::scaled(uv, m_exponent);
    return Point_2(static_cast<Number>(p.x()), static_cast<Number>(p.y()));
  }

  // `opposites` holds the side across each side, or -1 on a border; no side has the same vertex twice. O(n) on usual
  // polygons; `go_further` can end it.
  void make_mesh(std::vector<Point> points, const Polygons& polygons, const std::vector<int>& opposites,
                 Execution execution, const Go_further& go_further);

  // Before there are triangles; `polygons` are indices of polygons, in any order.
  void refuse_polygons(Status_code code, const char* message, std::vector<int> polygons);

  // The status with its finding and warnings as `translate` gives them.
  template <typename Surface, typename Translate>
  static Result_status<Surface> translated(const Indexed_status& flat, const Translate& translate)
  {
    Result_status<Surface> status;
    static_cast<Surface_mesh_cutting::Finding<Surface>&>(status) = translate(flat.finding);
    for(const Finding& warning : flat.warnings)
      status.warnings.push_back(translate(warning));
    return status;
  }

  // Turns triangles into polygons, each once, and leaves out diagonals.
  Finding in_polygons(Finding finding) const;

  // ": faces 3, 5 and 1 more"; edges are named by their two vertices. `name` gives the number to show for the index of
  // a vertex or polygon.
  std::string enumeration(const Finding& finding, const std::function<int(int)>& name) const;

  Indexed_status m_status;

private:
  void normalize(std::vector<Point>& points, const Polygons& polygons);

  int m_exponent = 0;
  Indexed_mesh m_mesh;
  // Per halfedge of the indexed mesh: the corner of a polygon from which it starts, and the side that it is, if any.
  std::vector<int> m_corners, m_sides;
  std::vector<int> m_polygons; // per face of the indexed mesh
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_cutting/internal/input/Polygon_adapter_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_POLYGON_ADAPTER_H
