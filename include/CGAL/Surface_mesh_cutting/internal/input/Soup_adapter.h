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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_SOUP_ADAPTER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_SOUP_ADAPTER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Polygon_soup.h>
#include <CGAL/Surface_mesh_cutting/Result_status.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Polygon_adapter.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Soup_surface.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Welding_advice.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/begin_triangles_with_last_corner.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/coincident_vertices_warning.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/read_soup.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The boundary between the caller's polygon soup and the index arrays, as `Mesh_adapter` is for meshes.
class Soup_adapter : public Polygon_adapter
{
public:
  using vertex_descriptor = Descriptors<Polygon_soup>::vertex_descriptor;
  using edge_descriptor = Descriptors<Polygon_soup>::edge_descriptor;

  // O(n). The indexed mesh exists only where `status()` is OK.
  template <typename PointRange, typename PolygonRange>
  // `words`: how the caller asks for welding, which warnings say where it would help.
  Soup_adapter(const PointRange& points, const PolygonRange& polygons, const Welding& welding,
               Execution execution = Execution::SEQUENTIAL, const Welding_words* words = nullptr,
               const Go_further& go_further = always_go_further)
  {
    if(!Welding::is_tolerance(welding.tolerance))
      m_status = Indexed_status(Status_code::WRONG_PARAMETER, "weld_tolerance is not in the range from 0 to 0.01");
    std::vector<Point> coordinates = to_vectors(points);
    const Polygons soup = read_polygons(polygons, int(coordinates.size()));
    if(m_status)
      check_points(soup, coordinates);
    if(!m_status)
      return;
    m_surface = read_soup(coordinates, soup, welding, execution, go_further);
    if(m_surface.is_stopped)
      m_status = stopped_status();
    if(!m_status)
      return;
    if(words != nullptr)
      m_warnings = soup_warnings(
        m_surface, Welding_adviser(coordinates, soup, m_surface, welding, execution, go_further)(), *words);
    begin_triangles_with_last_corner(m_surface);
    if(m_surface.polygons.number() == 0)
      m_status = Indexed_status(Status_code::EMPTY_MESH, "no polygon is part of a surface");
    else
      make_mesh(m_surface.points, m_surface.polygons, m_surface.opposites, execution, go_further);
  }

  const Soup_surface& surface() const { return m_surface; }

  // Vertices at the same point may be one in the soup.
  std::vector<Finding> warnings() const
  {
    std::vector<Finding> result = Polygon_adapter::warnings();
    result.erase(std::remove_if(result.begin(), result.end(),
                                [](const Finding& finding) { return finding.message == coincident_vertices_warning; }),
                 result.end());
    for(const std::string& warning : m_warnings)
      result.push_back(Finding{Status_code::OK, warning, Element_kind::NONE, {}});
    return result;
  }

  vertex_descriptor to_vertex(int v) const { return vertex_descriptor(m_surface.origins[v]); }
  edge_descriptor to_edge(int e) const
  {
    const int h = mesh().halfedge(e);
    return std::minmax({to_vertex(mesh().source(h)), to_vertex(mesh().target(h))});
  }

  template <typename EdgeIsCutMap>
  Cut read_cut(EdgeIsCutMap edge_is_cut_map) const
  {
    Cut cut(mesh().number_of_edges(), 0);
    for(int e = 0; e < mesh().number_of_edges(); ++e)
      cut[e] = !mesh().is_border_edge(e) && !is_diagonal(e) && get(edge_is_cut_map, to_edge(e));
    return cut;
  }

  // The UV of each corner, in the order of the indexed halfedges that start there. Corners that are not on the surface have to
  // have the UVs of those that they repeat.
  template <typename PolygonRange, typename CornerUVs>
  Indexed_status read_uvs(const PolygonRange& polygons, const CornerUVs& corner_uvs,
                          std::vector<Eigen::Vector2d>& result) const
  {
    std::vector<Eigen::Vector2d> of_surface(m_surface.polygons.vertices.size()), of_soup;
    auto polygon = polygons.begin();
    for(const auto& uvs : corner_uvs)
    {
      if(polygon == polygons.end() || uvs.size() != polygon->size())
        break;
      for(const auto& uv : uvs)
      {
        of_soup.push_back(Surface_mesh_parameterization::internal::to_vector_2(uv));
        if(m_surface.is_on_surface[of_soup.size() - 1])
          of_surface[m_surface.corners[of_soup.size() - 1]] = of_soup.back();
      }
      ++polygon;
    }
    if(polygon != polygons.end() || corner_uvs.size() != polygons.size())
      return Indexed_status(Status_code::WRONG_PARAMETER, "there is not one UV for each corner of each polygon");
    for(std::size_t c = 0; c < of_soup.size(); ++c)
      if(m_surface.is_bound[c] && of_soup[c] != of_surface[m_surface.corners[c]])
        return Indexed_status(Status_code::NOT_CERTIFIED, "the UVs of corner " + std::to_string(c) + " of all polygons are not "
                                                          "those of the corner that it repeats");
    result.clear();
    for(int h = 0; h < mesh().number_of_halfedges(); ++h)
      result.push_back(of_surface[to_corner(h)]);
    return Indexed_status();
  }

  // The edges at which the UVs of the two sides differ.
  Cut cut_between(const std::vector<Eigen::Vector2d>& uvs) const
  {
    Cut cut(mesh().number_of_edges(), 0);
    for(int e = 0; e < mesh().number_of_edges(); ++e)
      if(!mesh().is_border_edge(e))
      {
        const int h = mesh().halfedge(e), o = mesh().opposite(h);
        cut[e] = uvs[h] != uvs[next_halfedge(o)] || uvs[next_halfedge(h)] != uvs[o];
      }
    return cut;
  }

  // The inverse of `read_uvs()`, for the corners of the soup, one polygon after the other.
  template <typename Point_2>
  std::vector<Point_2> make_uvs(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv) const
  {
    std::vector<int> chart_vertices(m_surface.polygons.vertices.size());
    for(int h = 0; h < mesh().number_of_halfedges(); ++h)
      chart_vertices[to_corner(h)] = chart.source(h);
    std::vector<Point_2> result;
    result.reserve(m_surface.corners.size());
    for(int c : m_surface.corners)
      result.push_back(make_uv<Point_2>(uv[chart_vertices[(std::max)(c, 0)]]));
    return result;
  }

  // Replaces indices by those of the soup and appends the first of them to the messages.
  Result_status<Polygon_soup> translate(const Indexed_status& flat) const
  {
    return translated<Polygon_soup>(flat, [this](const Finding& finding) { return translate(finding); });
  }

private:
  template <typename PointRange>
  static std::vector<Point> to_vectors(const PointRange& points)
  {
    std::vector<Point> result;
    for(const auto& p : points)
      result.push_back(Surface_mesh_parameterization::internal::to_vector_3(p));
    return result;
  }

  // Those that no polygon uses matter to nobody.
  void check_points(const Polygons& soup, std::vector<Point>& points)
  {
    std::vector<char> is_used(points.size(), 0);
    for(int v : soup.vertices)
      is_used[v] = 1;
    std::vector<int> invalid;
    for(int v = 0; v < int(points.size()); ++v)
      if(!Surface_mesh_parameterization::internal::is_finite(points[v]))
      {
        if(is_used[v])
          invalid.push_back(v);
        points[v] = Point::Zero();
      }
    if(!invalid.empty())
      refuse(Status_code::INVALID_POINT, "vertices with a coordinate that is infinite or not a number",
             Element_kind::VERTEX, std::move(invalid));
  }

  template <typename PolygonRange>
  Polygons read_polygons(const PolygonRange& polygons, int number_of_points)
  {
    Polygons soup;
    std::vector<int> invalid;
    for(const auto& polygon : polygons)
    {
      bool is_valid = true;
      for(const auto& v : polygon)
      {
        is_valid = is_valid && std::size_t(v) < std::size_t(number_of_points);
        soup.vertices.push_back(int(v));
      }
      if(!is_valid)
        invalid.push_back(soup.number());
      soup.close();
    }
    if(!invalid.empty())
      refuse(Status_code::WRONG_PARAMETER, "polygons that refer to points which do not exist", Element_kind::FACE,
             std::move(invalid));
    return soup;
  }

  void refuse(Status_code code, const char* message, Element_kind kind, std::vector<int> indices)
  {
    if(m_status)
      m_status = Indexed_status(code, message, kind, std::move(indices));
  }

  Surface_mesh_cutting::Finding<Polygon_soup> translate(const Finding& of_triangles) const
  {
    const bool has_mesh = mesh().number_of_faces() > 0; // or else indices are those of the soup
    const Finding flat = has_mesh ? in_polygons(of_triangles) : of_triangles;
    const std::vector<int>& origins = flat.kind == Element_kind::FACE ? m_surface.polygon_origins : m_surface.origins;
    const auto name = [&](int i) { return has_mesh ? origins[i] : i; };
    Surface_mesh_cutting::Finding<Polygon_soup> finding;
    finding.code = flat.code;
    finding.message = flat.message + enumeration(flat, name);
    for(int i : flat.indices)
      switch(flat.kind)
      {
      case Element_kind::VERTEX: finding.vertices.push_back(std::size_t(name(i))); break;
      case Element_kind::EDGE:   finding.edges.push_back(to_edge(i)); break;
      case Element_kind::FACE:   finding.faces.push_back(std::size_t(name(i))); break;
      case Element_kind::NONE:   break;
      }
    return finding;
  }

  Soup_surface m_surface;
  std::vector<std::string> m_warnings;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_SOUP_ADAPTER_H
