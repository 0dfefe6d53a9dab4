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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_MESH_CHART_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_MESH_CHART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/Kernel_traits.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A connected component of a mesh with border as index arrays: its chart, and for each chart vertex
// the vertex of the mesh and its position, scaled to an extent of about one.
template <typename TriangleMesh>
class Mesh_chart
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

public:
  const Corner_table& chart() const { return m_chart; }
  const std::vector<Eigen::Vector3d>& points() const { return m_points; }

  // Reads the component of the border halfedge `bhd`; says what keeps it from being mapped without flips. O(n).
  Error_code read(const TriangleMesh& mesh, halfedge_descriptor bhd)
  {
    if(bhd == Graph_traits::null_halfedge() || is_border(opposite(bhd, mesh), mesh))
      return ERROR_EMPTY_MESH;
    if(!is_border(bhd, mesh))
      return ERROR_NO_TOPOLOGICAL_DISC;
    if(!read_triangles(mesh, opposite(bhd, mesh)))
      return ERROR_NON_TRIANGULAR_MESH;
    const Error_code error = check_topology();
    return error != OK ? error : read_points(mesh);
  }

  // Writes the map `uv` of the chart at the scale of the mesh. `is_valid(chart, uv)` has to hold for
  // the coordinates as written, in the number type of the UVs.
  template <typename VertexUVMap, typename VertexParameterizedMap, typename IsValid>
  Error_code write(std::vector<Eigen::Vector2d> uv, VertexUVMap uvmap,
                   VertexParameterizedMap vpmap, const IsValid& is_valid) const
  {
    using Point_2 = typename boost::property_traits<VertexUVMap>::value_type;
    using FT = typename CGAL::Kernel_traits<Point_2>::Kernel::FT;

    for(std::size_t v = 0; v < uv.size(); ++v)
    {
      uv[v] = scaled(uv[v], m_exponent);
      const Point_2 p(static_cast<FT>(uv[v].x()), static_cast<FT>(uv[v].y()));
      put(uvmap, m_vertices[v], p);
      put(vpmap, m_vertices[v], true);
      uv[v] = to_vector_2(p);
    }
    return is_valid(m_chart, uv) ? OK : ERROR_NO_1_TO_1_MAPPING;
  }

private:
  // False if a face is not a triangle.
  bool read_triangles(const TriangleMesh& mesh, halfedge_descriptor seed)
  {
    std::vector<halfedge_descriptor> halfedges;
    std::unordered_map<halfedge_descriptor, int> numbers;
    const auto add_face = [&](halfedge_descriptor h)
    {
      if(next(next(next(h, mesh), mesh), mesh) != h)
        return false;
      for(int k = 0; k < 3; ++k, h = next(h, mesh))
      {
        numbers.emplace(h, int(halfedges.size()));
        halfedges.push_back(h);
      }
      return true;
    };
    if(!add_face(seed))
      return false;
    std::vector<int> opposites;
    for(std::size_t i = 0; i < halfedges.size(); ++i)
    {
      const halfedge_descriptor o = opposite(halfedges[i], mesh);
      if(is_border(o, mesh))
      {
        opposites.push_back(-1);
        continue;
      }
      if(numbers.find(o) == numbers.end() && !add_face(o))
        return false;
      opposites.push_back(numbers.at(o));
    }
    number_vertices(mesh, halfedges, opposites);
    return true;
  }

  // Every fan of corners is a chart vertex.
  void number_vertices(const TriangleMesh& mesh, const std::vector<halfedge_descriptor>& halfedges,
                       const std::vector<int>& opposites)
  {
    std::vector<Triangle> triangles(halfedges.size() / 3, Triangle{-1, -1, -1});
    m_vertices.clear();
    for(int h = 0; h < int(halfedges.size()); ++h)
    {
      if(triangles[h / 3][h % 3] >= 0)
        continue;
      int first = h; // the last halfedge in clockwise order, if the fan is open
      while(opposites[first] >= 0 && next_halfedge(opposites[first]) != h)
        first = next_halfedge(opposites[first]);
      int c = first;
      do
      {
        triangles[c / 3][c % 3] = int(m_vertices.size());
        c = opposites[previous_halfedge(c)];
      }
      while(c >= 0 && c != first);
      m_vertices.push_back(target(halfedges[previous_halfedge(h)], mesh));
    }
    m_chart = Corner_table(std::move(triangles), opposites, int(m_vertices.size()));
  }

  Error_code check_topology() const
  {
    // No handles, and no vertex of the mesh where fans meet: it has one place in the plane only.
    const std::vector<std::vector<int> > loops = m_chart.border_loops();
    const std::unordered_set<vertex_descriptor> vertices(m_vertices.begin(), m_vertices.end());
    if(m_chart.euler_characteristic() != 2 - int(loops.size()) ||
       vertices.size() != m_vertices.size())
      return ERROR_NO_TOPOLOGICAL_DISC;
    const bool has_border = std::any_of(loops.begin(), loops.end(), [](const std::vector<int>& loop)
                                        { return loop.size() >= 3; });
    return has_border ? OK : ERROR_BORDER_TOO_SHORT;
  }

  Error_code read_points(const TriangleMesh& mesh)
  {
    const auto vpm = get(CGAL::vertex_point, mesh);
    Bounding_box<3> box;
    m_points.clear();
    for(vertex_descriptor v : m_vertices)
    {
      m_points.push_back(to_vector_3(get(vpm, v)));
      if(!is_finite(m_points.back()))
        return ERROR_WRONG_PARAMETER;
      box.add(m_points.back());
    }
    if(box.low == box.high)
      return ERROR_NO_1_TO_1_MAPPING;
    m_exponent = scale_exponent(box);
    for(Eigen::Vector3d& p : m_points)
      p = scaled(p, -m_exponent);
    return OK;
  }

  Corner_table m_chart;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<Eigen::Vector3d> m_points;
  int m_exponent = 0; // of two
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_MESH_CHART_H
