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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_CORNERS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_CORNERS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <CGAL/number_utils.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>


namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The angle defects of vertices that are inside: the Gaussian curvature of the surface. 0 on borders.
inline std::vector<double> angle_defects(const Indexed_mesh& mesh)
{
  std::vector<double> defects(mesh.number_of_vertices(), 2 * CGAL_PI);
  for(const Triangle& t : mesh.triangles())
    for(int k = 0; k < 3; ++k)
    {
      const auto u = mesh.point(t[(k + 1) % 3]) - mesh.point(t[k]), v = mesh.point(t[(k + 2) % 3]) - mesh.point(t[k]);
      defects[t[k]] -= std::atan2(u.cross(v).norm(), u.dot(v));
    }
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    if(mesh.is_border_edge(e))
      defects[mesh.source(mesh.halfedge(e))] = defects[mesh.target(mesh.halfedge(e))] = 0;
  return defects;
}

// The vertices that carry nearly all curvature, sorted, with the terminals, if they are few: opened along a tree through
// them, the surface of a polyhedron is its net. Empty otherwise.
inline std::vector<int> corners(const Problem& problem)
{
  constexpr double share = 0.95; // of the sum of absolute curvature
  constexpr std::size_t enough = 64;
  const std::vector<double> defects = angle_defects(problem.mesh);
  std::vector<int> vertices;
  double sum = 0, found = 0;
  for(int v = 0; v < int(defects.size()); ++v)
  {
    vertices.push_back(v);
    sum += std::abs(defects[v]);
  }
  const std::size_t size = (std::min)(enough, vertices.size());
  std::partial_sort(vertices.begin(), vertices.begin() + size, vertices.end(), [&](int v, int w)
                    { return std::make_pair(-std::abs(defects[v]), v) < std::make_pair(-std::abs(defects[w]), w); });
  vertices.resize(size);
  for(std::size_t i = 0; i < size; ++i)
  {
    found += std::abs(defects[vertices[i]]);
    if(found < share * sum)
      continue;
    vertices.resize(i + 1);
    const std::vector<char> is_reachable = reachable_vertices(problem.mesh, problem.constraints);
    vertices.erase(std::remove_if(vertices.begin(), vertices.end(), [&](int v) { return !is_reachable[v]; }), vertices.end());
    CGAL::internal::Graph_kernel::add_unique(problem.terminals, vertices);
    return vertices;
  }
  return {};
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_CORNERS_H
