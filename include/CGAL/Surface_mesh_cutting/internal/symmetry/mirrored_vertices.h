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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_MIRRORED_VERTICES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_MIRRORED_VERTICES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Symmetry.h>
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/Indexed_symmetry.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

template <typename Adapter>
Cut diagonals_of(const Adapter& adapter)
{
  Cut diagonals;
  if(adapter.has_diagonals())
    for(int e = 0; e < adapter.mesh().number_of_edges(); ++e)
      diagonals.push_back(adapter.is_diagonal(e));
  return diagonals;
}

// For each vertex of a chart of the whole mesh, the one that is its mirror image; empty if the symmetry, which is exact, does not
// map the cut to itself. Nothing is cut along edges without an image.
inline std::vector<int> mirrored_vertices(const Indexed_mesh& mesh, const Corner_table& chart, const Indexed_symmetry& symmetry)
{
  std::vector<int> images(chart.number_of_vertices(), -1);
  for(int h = 0; h < mesh.number_of_halfedges(); ++h)
  {
    const int image = symmetry.edge_images[mesh.edge(h)];
    if(image < 0 && !chart.is_border(h))
      continue;
    int g = image < 0 ? -1 : mesh.halfedge(image); // backward
    if(g >= 0 && mesh.source(g) != symmetry.images[mesh.target(h)])
      g = mesh.opposite(g);
    if(g < 0 || chart.is_border(g) != chart.is_border(h))
      return {};
    images[chart.source(h)] = chart.target(g);
    images[chart.target(h)] = chart.source(g);
  }
  return images;
}

// The same for the first symmetry that does so; empty if there is none.
template <typename Adapter>
std::vector<int> mirrored_vertices(const Adapter& adapter, const Corner_table& chart, Symmetry choice, Execution execution)
{
  if(choice != Symmetry::NONE)
    for(const Indexed_symmetry& symmetry : find_indexed_symmetries(adapter.mesh(), diagonals_of(adapter), choice, execution))
      if(symmetry.is_exact)
        if(std::vector<int> images = mirrored_vertices(adapter.mesh(), chart, symmetry); !images.empty())
          return images;
  return {};
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_MIRRORED_VERTICES_H
