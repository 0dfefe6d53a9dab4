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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_DISTORTION_BOUNDS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_DISTORTION_BOUNDS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Cutting_parameters.h>
#include <CGAL/Surface_mesh_cutting/internal/result/energy_statistics.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Upper bounds on the symmetric Dirichlet energy of faces, and on its mean over a chart.
struct Distortion_bounds
{
  double face = std::numeric_limits<double>::infinity();
  double quantile = 1; // the share of the area whose faces keep that bound
  double mean = std::numeric_limits<double>::infinity();

  explicit Distortion_bounds(const Cutting_parameters& parameters)
    : face(parameters.maximum_face_distortion), quantile(parameters.face_distortion_quantile),
      mean(parameters.maximum_chart_distortion)
  {}

  // The faces above the bound, in the order of their indices, without the most distorted ones that make up the share of the
  // area which need not keep it. O(n log n), n the number of faces above.
  std::vector<int> faces_above(const std::vector<double>& energies, const std::vector<double>& areas) const
  {
    double free_area = 0;
    for(const double area : areas)
      free_area += (1 - quantile) * area;
    std::vector<int> faces;
    for(std::size_t f = 0; f < energies.size(); ++f)
      if(areas[f] > 0 && !(energies[f] <= face))
        faces.push_back(int(f));
    std::stable_sort(faces.begin(), faces.end(), [&](int f, int g) { return energies[f] > energies[g]; });
    std::size_t number = 0;
    for(; number < faces.size() && areas[faces[number]] <= free_area; ++number)
      free_area -= areas[faces[number]];
    faces.erase(faces.begin(), faces.begin() + number);
    std::sort(faces.begin(), faces.end());
    return faces;
  }

  // Names the faces above their bound, or else those of the charts above theirs. `charts`: those of `chart_of_face`.
  Indexed_status status(const std::vector<double>& energies, const std::vector<double>& areas,
                        const std::vector<Chart_energy>& charts, const std::vector<int>& chart_of_face) const
  {
    std::vector<int> above = faces_above(energies, areas);
    if(!above.empty())
      return local_bound_missed("each face", "these faces", std::move(above), face);
    for(std::size_t f = 0; f < chart_of_face.size(); ++f)
      if(charts[chart_of_face[f]].average > mean)
        above.push_back(int(f));
    return above.empty() ? Indexed_status() : local_bound_missed("each chart", "the charts of these faces", std::move(above), mean);
  }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_DISTORTION_BOUNDS_H
