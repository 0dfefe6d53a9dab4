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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_INJECTIVE_CUT_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_INJECTIVE_CUT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/mapping/Open_chart.h>

#include <CGAL/Surface_mesh_parameterization/internal/bijective/bijective_map.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A map without overlaps.
struct Injective_map
{
  std::vector<Eigen::Vector2d> uv;
  double energy = 0; // area-averaged
};

// A cut surface and its map.
struct Injective_cut
{
  Cut cut;
  Corner_table chart;
  Injective_map map;
  std::vector<int> ends; // of the paths of the cut

  // Cuts paths, whose ends the caller adds; the map stays without overlaps.
  void open(const Indexed_mesh& mesh, const std::vector<int>& edges)
  {
    std::vector<int> halfedges;
    for(int e : edges)
    {
      cut[e] = 1;
      halfedges.push_back(mesh.halfedge(e));
    }
    Surface_mesh_parameterization::internal::open_injectively(halfedges, chart, map.uv);
  }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_INJECTIVE_CUT_H
