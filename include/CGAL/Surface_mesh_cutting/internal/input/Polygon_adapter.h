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

#include <CGAL/Surface_mesh_cutting/Status.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Polygons.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>
#include <CGAL/Surface_mesh_parameterization/internal/Bounding_box.h>
#include <CGAL/Surface_mesh_parameterization/internal/power_of_two_scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/to_vector.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#ifndef CGAL_SURFACE_MESH_CUTTING_USE_LIBRARY
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/check_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/triangulate_polygons.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// What the adapters of meshes and of polygon soups have in common: the triangles of the caller's polygons as an
// indexed mesh, and where they come from.
//
// The indexed mesh is scaled by a power of two, which loses no bit, to an extent of about one:
// products of lengths then neither overflow nor underflow.
class Polygon_adapter
{
public:
  // Why the surface is refused, or the warnings about it. The indexed mesh exists only where this is OK.
  const Indexed_status& status() const { return m_status; }
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

  // `opposites` holds the side across each side, or -1 on a border; no polygon has a vertex twice. O(n).
  void make_mesh(std::vector<Point> points, const Polygons& polygons, const std::vector<int>& opposites)
  {
    normalize(points, polygons);
    Polygon_triangulation triangulation = triangulate_polygons(points, polygons, opposites);
    if(!triangulation.doubled.empty())
    {
      refuse_polygons(Status_code::NOT_TRIANGULATED,
                      "faces all of whose triangulations repeat an edge of the surface",
                      std::move(triangulation.doubled));
      return;
    }
    m_corners = std::move(triangulation.corners);
    m_sides = std::move(triangulation.sides);
    m_polygons = std::move(triangulation.polygons);
    m_mesh = Indexed_mesh(std::move(points), std::move(triangulation.triangles), std::move(triangulation.opposites));
    m_status = check_mesh(m_mesh);
    constexpr int extreme = 332; // 1e100
    if(m_status && std::abs(m_exponent) > extreme)
      m_status.warnings.push_back(Finding{Status_code::OK, "extreme coordinates, which are rescaled internally",
                                          Element_kind::NONE, {}});
  }

  // Before there are triangles; `polygons` are indices of polygons.
  void refuse_polygons(Status_code code, const char* message, std::vector<int> polygons)
  {
    m_polygons.resize(polygons.empty() ? 0 : std::size_t(*std::max_element(polygons.begin(), polygons.end())) + 1);
    std::iota(m_polygons.begin(), m_polygons.end(), 0);
    m_status = Indexed_status(code, message, Element_kind::FACE, std::move(polygons));
  }

  // The status with its finding and warnings as `translate` gives them.
  template <typename Surface, typename Translate>
  static Status<Surface> translated(const Indexed_status& flat, const Translate& translate)
  {
    Status<Surface> status;
    static_cast<Surface_mesh_cutting::Finding<Surface>&>(status) = translate(flat.finding);
    for(const Finding& warning : flat.warnings)
      status.warnings.push_back(translate(warning));
    return status;
  }

  // Turns triangles into polygons, each once, and leaves out diagonals.
  Finding in_polygons(Finding finding) const
  {
    std::vector<int>& indices = finding.indices;
    if(finding.kind == Element_kind::FACE)
    {
      for(int& f : indices)
        f = m_polygons[f];
      indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    }
    else if(finding.kind == Element_kind::EDGE)
      indices.erase(std::remove_if(indices.begin(), indices.end(), [this](int e) { return is_diagonal(e); }),
                    indices.end());
    return finding;
  }

  // ": faces 3, 5 and 1 more"; edges are named by their two vertices. `name` gives the number to show for the index of
  // a vertex or polygon.
  template <typename Name>
  std::string enumeration(const Finding& finding, Name name) const
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
        text += std::to_string(name(m_mesh.source(m_mesh.halfedge(index)))) + "-"
              + std::to_string(name(m_mesh.target(m_mesh.halfedge(index))));
      else
        text += std::to_string(name(index));
    }
    if(finding.indices.size() > maximum)
      text += " and " + std::to_string(finding.indices.size() - maximum) + " more";
    return text;
  }

  Indexed_status m_status;

private:
  void normalize(std::vector<Point>& points, const Polygons& polygons)
  {
    Surface_mesh_parameterization::internal::Bounding_box<3> box;
    for(int v : polygons.vertices)
      box.add(points[v]);
    m_exponent = Surface_mesh_parameterization::internal::scale_exponent(box);
    for(Point& p : points)
      p = Surface_mesh_parameterization::internal::scaled(p, -m_exponent);
  }

  int m_exponent = 0;
  Indexed_mesh m_mesh;
  // Per halfedge of the indexed mesh: the corner of a polygon from which it starts, and the side that it is, if any.
  std::vector<int> m_corners, m_sides;
  std::vector<int> m_polygons; // per face of the indexed mesh
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_POLYGON_ADAPTER_H
