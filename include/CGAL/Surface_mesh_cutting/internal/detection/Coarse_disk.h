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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_COARSE_DISK_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_COARSE_DISK_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/coarse_constraints.h>

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A coarser version of a surface that a cut has opened to a disk; the cut is its border.
class Coarse_disk
{
public:
  // `chart` is the disk, `fine` its surface. O(n log n).
  Coarse_disk(const Problem& fine, Corner_table chart, int number_of_faces, const Context& context)
    : m_chart(std::move(chart)),
      m_disk(chart_points(fine.mesh, m_chart), m_chart.triangles(), m_chart.opposites()),
      m_coarse(m_disk, number_of_faces / 2, {}, context.parameters.linear_solvers->execution),
      m_problem{m_coarse.mesh, m_coarse.shapes(),
                coarse_constraints(m_disk, constraints_of_disk(fine), m_coarse, {}), {}, Initial_cut(), false}
  {}

  Coarse_disk(const Coarse_disk&) = delete; // the problem refers to the mesh
  Coarse_disk& operator=(const Coarse_disk&) = delete;

  // To cut the disk further.
  const Problem& problem() const { return m_problem; }

  // The vertices of the surface that these ones of the coarser version stand for.
  std::vector<int> lifted(const std::vector<int>& vertices) const
  {
    std::vector<int> result;
    for(int v : vertices)
      result.push_back(m_chart.origins()[m_coarse.vertices[v]]);
    return result;
  }

private:
  Edge_constraints constraints_of_disk(const Problem& fine) const
  {
    Edge_constraints constraints = unconstrained(m_disk);
    for(int e = 0; e < m_disk.number_of_edges(); ++e)
      constraints.weights[e] = fine.constraints.weights[fine.mesh.edge(m_disk.halfedge(e))];
    return constraints;
  }

  const Corner_table m_chart;
  const Indexed_mesh m_disk;
  const Coarse_mesh m_coarse;
  const Problem m_problem;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_DETECTION_COARSE_DISK_H
