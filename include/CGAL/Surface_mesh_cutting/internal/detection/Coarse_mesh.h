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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_COARSE_MESH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_COARSE_MESH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Chart_hierarchy.h>

#include <set>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A coarser version of a surface, of the same topology, whose vertices are some of its vertices.
struct Coarse_mesh
{
  Indexed_mesh mesh;
  std::vector<int> vertices; // of the fine mesh

  // Has about `number_of_vertices` vertices, or as many as are needed to keep the topology, and the kept ones.
  // O(n log n).
  Coarse_mesh(const Indexed_mesh& fine, int number_of_vertices, const std::vector<int>& kept,
              Surface_mesh_parameterization::internal::Execution execution)
  {
    using Surface_mesh_parameterization::internal::Chart_hierarchy;
    const Corner_table chart(fine.triangles(), fine.opposites(), fine.number_of_vertices());
    constexpr bool keeps_region = false;
    Chart_hierarchy hierarchy(chart, fine.points(), keeps_region, execution);
    std::vector<char> is_kept(fine.number_of_vertices(), 0);
    for(int v : kept)
      is_kept[v] = 1;
    constexpr int enough = 12; // times as many vertices as are wanted: errors decide which of them stay
    const int size = number_of_vertices + int(kept.size());
    hierarchy.coarsen(size, enough * size, is_kept);
    Chart_hierarchy::Stage stage = hierarchy.stage();
    mesh = Indexed_mesh(std::move(stage.points), stage.chart.triangles(), stage.chart.opposites());
    vertices = std::move(stage.vertices);
  }

  // Its triangles laid flat, none of them as thin as a line.
  std::vector<Surface_mesh_parameterization::internal::Rest_shape> shapes() const
  {
    using namespace Surface_mesh_parameterization::internal;
    return rest_shapes(mesh.triangles(), mesh.points(), Execution::SEQUENTIAL, minimal_coarse_height);
  }

  // The vertices that stand for these ones of the fine mesh, which were kept.
  std::vector<int> find(const std::vector<int>& fine_vertices) const
  {
    const std::set<int> wanted(fine_vertices.begin(), fine_vertices.end());
    std::vector<int> found;
    for(int v = 0; v < int(vertices.size()); ++v)
      if(wanted.count(vertices[v]) > 0)
        found.push_back(v);
    return found;
  }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_COARSE_MESH_H
