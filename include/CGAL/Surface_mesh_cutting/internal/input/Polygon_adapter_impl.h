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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_POLYGON_ADAPTER_IMPL_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_POLYGON_ADAPTER_IMPL_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Polygon_adapter.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <CGAL/boost/graph/internal/Graph_kernel/separate_implementation.h>
#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/check_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/mesh_warnings.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/triangulate_polygons.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// What `Polygon_adapter` does for all types of meshes alike: the compiled library holds it.

CGAL_INLINE_UNLESS_SEPARATE
void Polygon_adapter::normalize(std::vector<Point>& points, const Polygons& polygons)
{
  Surface_mesh_parameterization::internal::Bounding_box<3> box;
  for(int v : polygons.vertices)
    box.add(points[v]);
  m_exponent = Surface_mesh_parameterization::internal::scale_exponent(box);
  for(Point& p : points)
    p = Surface_mesh_parameterization::internal::scaled(p, -m_exponent);
}

CGAL_INLINE_UNLESS_SEPARATE
void Polygon_adapter::make_mesh(std::vector<Point> points, const Polygons& polygons, const std::vector<int>& opposites,
                                Execution execution, const Go_further& go_further)
{
  normalize(points, polygons);
  Polygon_triangulation triangulation = triangulate_polygons(points, polygons, opposites, go_further);
  if(triangulation.is_stopped)
  {
    m_status = stopped_status();
    return;
  }
  if(!triangulation.doubled.empty())
  {
    refuse_polygons(Status_code::NOT_TRIANGULATED,
                    "faces all of whose triangulations repeat an edge of the surface or overlap",
                    std::move(triangulation.doubled));
    return;
  }
  m_corners = std::move(triangulation.corners);
  m_sides = std::move(triangulation.sides);
  m_polygons = std::move(triangulation.polygons);
  m_mesh = Indexed_mesh(std::move(points), std::move(triangulation.triangles), std::move(triangulation.opposites),
                        execution);
  m_status = check_mesh(m_mesh, execution);
}

CGAL_INLINE_UNLESS_SEPARATE
std::vector<Finding> Polygon_adapter::warnings() const
{
  constexpr int extreme = 332; // 1e100
  std::vector<Finding> warnings = mesh_warnings(m_mesh);
  if(std::abs(m_exponent) > extreme)
    warnings.push_back(Finding{Status_code::OK, "extreme coordinates, which are rescaled internally",
                               Element_kind::NONE, {}});
  return warnings;
}

CGAL_INLINE_UNLESS_SEPARATE
void Polygon_adapter::refuse_polygons(Status_code code, const char* message, std::vector<int> polygons)
{
  CGAL::internal::Graph_kernel::sort_unique(polygons);
  m_polygons.resize(polygons.empty() ? 0 : std::size_t(polygons.back()) + 1);
  std::iota(m_polygons.begin(), m_polygons.end(), 0);
  m_status = Indexed_status(code, message, Element_kind::FACE, std::move(polygons));
}

CGAL_INLINE_UNLESS_SEPARATE
Finding Polygon_adapter::in_polygons(Finding finding) const
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

CGAL_INLINE_UNLESS_SEPARATE
std::string Polygon_adapter::enumeration(const Finding& finding, const std::function<int(int)>& name) const
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

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_INPUT_POLYGON_ADAPTER_IMPL_H
