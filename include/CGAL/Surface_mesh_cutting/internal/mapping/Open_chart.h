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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_OPEN_CHART_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_OPEN_CHART_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>

#include <Eigen/Core>

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A surface opened along a cut that leaves one disk, and its isometric map.
struct Open_chart
{
  Cut cut;
  Corner_table chart;
  std::vector<Eigen::Vector2d> uv;
  // Of the surface's vertices: an order of elimination that suited an earlier chart suits this one, too; empty if
  // none is known.
  std::vector<int> ranks;
  double energy = std::numeric_limits<double>::infinity();    // area-averaged, converged
  double precision = std::numeric_limits<double>::infinity(); // the decrement that was reached, of the energy

  // The ranks of some vertices of the chart.
  std::vector<int> ranks_of(const std::vector<int>& vertices) const
  {
    std::vector<int> result;
    if(ranks.empty())
      return result;
    for(int v : vertices)
      result.push_back(ranks[chart.origins()[v]]);
    return result;
  }

  // Those of all vertices of the chart.
  std::vector<int> chart_ranks() const
  {
    std::vector<int> vertices(chart.number_of_vertices());
    std::iota(vertices.begin(), vertices.end(), 0);
    return ranks_of(vertices);
  }

  // Takes the ranks from the places of the chart's vertices in an order of elimination. Copies of a vertex are
  // eliminated together.
  void take_ranks(const std::vector<int>& positions, int number_of_surface_vertices)
  {
    ranks.assign(number_of_surface_vertices, -1);
    for(int v = 0; v < int(positions.size()); ++v)
    {
      int& rank = ranks[chart.origins()[v]];
      rank = (std::max)(rank, positions[v]);
    }
  }

  // How far each surface vertex's copies lie from the first of them in the plane; 0 inside.
  std::vector<double> seam_openings(int number_of_surface_vertices) const
  {
    std::vector<int> first(number_of_surface_vertices, -1);
    std::vector<double> openings(number_of_surface_vertices, 0);
    for(int c = 0; c < chart.number_of_vertices(); ++c)
    {
      const int v = chart.origins()[c];
      if(first[v] < 0)
        first[v] = c;
      else
        openings[v] = (std::max)(openings[v], (uv[c] - uv[first[v]]).norm());
    }
    return openings;
  }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_OPEN_CHART_H
