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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_BORDER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_BORDER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The border of a disk in the plane, counterclockwise.
struct Chart_border
{
  std::vector<int> halfedges, numbers; // along the border, and of each halfedge of the mesh its place there; -1: elsewhere
  std::vector<Eigen::Vector2d> points; // their sources
  std::vector<int> mates;              // of each, the number of that at the other side of the cut; -1: border of the mesh
  std::vector<double> lengths, costs;  // of their edges; at the border of the mesh, both are lengths

  // `uv`: of the chart, a disk.
  Chart_border(const Problem& problem, const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv)
    : halfedges(chart.border_loops().front()), numbers(problem.mesh.number_of_halfedges(), -1)
  {
    const Indexed_mesh& mesh = problem.mesh;
    for(int i = 0; i < size(); ++i)
      numbers[halfedges[i]] = i;
    for(int h : halfedges)
    {
      const int e = mesh.edge(h);
      points.push_back(uv[chart.source(h)]);
      mates.push_back(mesh.is_border(h) ? -1 : numbers[mesh.opposite(h)]);
      lengths.push_back(mesh.length(e));
      costs.push_back(mesh.is_border(h) ? mesh.length(e) : problem.constraints.weights[e]);
    }
  }

  int size() const { return int(halfedges.size()); }
  int next(int i) const { return i + 1 < size() ? i + 1 : 0; }
  int previous(int i) const { return i > 0 ? i - 1 : size() - 1; }
  // The number of halfedges from the source of one to that of another.
  int distance(int from, int to) const { return to >= from ? to - from : to - from + size(); }

  double cost() const
  {
    double sum = 0;
    for(double c : costs)
      sum += c;
    return sum;
  }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_BORDER_H
