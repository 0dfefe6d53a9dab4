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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_MESH_RESULT_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_MESH_RESULT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Trade_off.h>
#include <CGAL/Surface_mesh_cutting/internal/result/energy_statistics.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>
#include <CGAL/Surface_mesh_cutting/internal/symmetry/Indexed_symmetry.h>

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// What a run found, in terms of the whole indexed mesh.
struct Mesh_result
{
  Indexed_status status;
  bool has_result = false; // cut or map, as was asked for
  int components = 0, genus = 0, borders = 0;
  int number_of_candidates = 0, number_of_auxiliary_points = 0;
  std::vector<int> features;
  Cut cut;
  double length = 0, cost = 0, lower_bound = 0, diagonal = 0;
  bool is_optimal = true;
  Corner_table chart;
  std::vector<Eigen::Vector2d> uv;
  double average_energy = 0, maximum_energy = 0;
  std::vector<std::array<double, 2> > quantiles; // of the energies of faces
  std::vector<Chart_energy> charts;
  std::vector<int> chart_of_face;
  int flips = 0;
  std::optional<int> overlaps; // if the map has to be injective
  std::vector<Trade_off> trade_offs;
  std::optional<Indexed_symmetry> symmetry; // of the surface, if it was looked for
};

enum class Output_kind { FEATURES, CUT, MAP };

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_MESH_RESULT_H
