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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_LOCAL_WINDOW_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_LOCAL_WINDOW_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/mapping/Open_chart.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>
#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using CGAL::internal::Graph_kernel::Index_set;
using CGAL::internal::Graph_kernel::Shortest_paths;

// The surroundings of a slit in a chart: the vertices within a radius are free, those around them fixed.
class Local_window
{
public:
  // The triangles of the window over vertices of its own.
  struct System
  {
    std::vector<Triangle> triangles;
    std::vector<Surface_mesh_parameterization::internal::Rest_shape> shapes;
    std::vector<double> weights;
    std::vector<int> vertices; // of the chart
    std::vector<char> is_fixed;
    std::vector<Eigen::Vector2d> uv;
  };

  explicit Local_window(const Indexed_mesh& mesh)
    : m_mesh(mesh), m_reach(mesh.graph()), m_faces(mesh.number_of_faces()), m_local_vertex(mesh.number_of_vertices(), -1)
  {}

  // Finds the triangles that touch the vertices within `radius` of the slit. False if the window is no longer
  // small against the chart.
  bool collect(const std::vector<int>& slit, double radius)
  {
    constexpr double largest_share = 0.25; // of the faces: a larger window costs about as much as the whole
    const std::size_t largest = std::size_t(largest_share * m_mesh.number_of_faces());
    m_reach.clear();
    for(int e : slit)
    {
      m_reach.add_source(m_mesh.source(m_mesh.halfedge(e)));
      m_reach.add_source(m_mesh.target(m_mesh.halfedge(e)));
    }
    m_faces.clear();
    m_reach.run([&](int v)
                {
                  if(m_reach.distance(v) > radius || m_faces.indices().size() > largest)
                    return false;
                  for(int a = m_mesh.graph().offsets[v]; a < m_mesh.graph().offsets[v + 1]; ++a)
                  {
                    const int h = m_mesh.halfedge(m_mesh.graph().arcs[a].edge);
                    m_faces.insert(h / 3);
                    if(m_mesh.opposite(h) >= 0)
                      m_faces.insert(m_mesh.opposite(h) / 3);
                  }
                  return true;
                });
    m_faces.sort();
    m_radius = radius;
    return m_faces.indices().size() <= largest;
  }

  // `shapes` and `weights` of the whole chart.
  System system(const Open_chart& open, const std::vector<Surface_mesh_parameterization::internal::Rest_shape>& shapes,
                const std::vector<double>& weights)
  {
    System system;
    m_local_vertex.resize(open.chart.number_of_vertices(), -1);
    for(int f : m_faces.indices())
    {
      Triangle local;
      for(int k = 0; k < 3; ++k)
      {
        const int v = open.chart.triangles()[f][k];
        if(m_local_vertex[v] < 0)
        {
          m_local_vertex[v] = int(system.vertices.size());
          system.vertices.push_back(v);
          system.is_fixed.push_back(!(m_reach.distance(open.chart.origins()[v]) <= m_radius));
        }
        local[k] = m_local_vertex[v];
      }
      system.triangles.push_back(local);
      system.shapes.push_back(shapes[f]);
      system.weights.push_back(weights[f]);
    }
    for(int v : system.vertices)
    {
      system.uv.push_back(open.uv[v]);
      m_local_vertex[v] = -1;
    }
    return system;
  }

private:
  const Indexed_mesh& m_mesh;
  Shortest_paths m_reach;
  Index_set m_faces;
  double m_radius = 0;
  std::vector<int> m_local_vertex; // of each chart vertex, -1 outside of the window
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_LOCAL_WINDOW_H
