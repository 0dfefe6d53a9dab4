// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

// The method: cuts, feature points, and maps.

#ifndef SURFACE_MESH_CUTTING_PYTHON_CUT_SURFACE_H
#define SURFACE_MESH_CUTTING_PYTHON_CUT_SURFACE_H

#include "Named_surface.h"
#include "Run_monitor.h"

#include <CGAL/Surface_mesh_cutting/Chart_rotation.h>
#include <CGAL/Surface_mesh_cutting/Connection.h>
#include <CGAL/Surface_mesh_cutting/Effort.h>
#include <CGAL/Surface_mesh_cutting/Symmetry.h>
#include <CGAL/Surface_mesh_cutting/unwrap_polygon_soup.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace binding {

using SMC::internal::Output_kind;

// As the named parameters of the same names.
struct Cutting_options
{
  Output_kind output = Output_kind::MAP;
  SMC::Effort effort = SMC::Effort::DEFAULT;
  SMC::Connection connection = SMC::Connection::BEST;
  bool use_published_method = false;
  bool do_bijective = true;
  double maximum_average_distortion = std::numeric_limits<double>::infinity();
  double maximum_face_distortion = std::numeric_limits<double>::infinity();
  double face_distortion_quantile = 1;
  double maximum_chart_distortion = std::numeric_limits<double>::infinity();
  double minimum_distortion_decrease = 0.01;
  double minimum_length_decrease = 0.01;
  double minimum_area_ratio = 0.1;
  double influence_threshold = 20;
  double forbidden_radius = 10;
  std::size_t maximum_number_of_states = 20000000;
  unsigned int random_seed = 0;
  SMC::Symmetry symmetry = SMC::Symmetry::NONE;
  std::optional<double> seam_smoothness;
};

struct Packing_options
{
  double margin = 2;
  int texture_size = 1024;
  SMC::Effort effort = SMC::Effort::DEFAULT;
  SMC::Chart_rotation rotation = SMC::Chart_rotation::AUTOMATIC;
  SMC::Symmetry symmetry = SMC::Symmetry::NONE;
  double texels_per_unit = 0; // 0 for as many as fit
  int pages = 0;              // 0 for one, or as many as that number of texels needs
};

// A map: its points, and which of them each corner of the soup has.
struct Corner_map
{
  std::vector<double> uv;            // two per UV, in the order in which the corners meet them
  std::vector<std::int64_t> corners; // per corner of the soup, its UV
  std::vector<std::int64_t> points;  // per UV, the point of the soup that it belongs to
};

struct Cut_surface
{
  SMC::Unwrap_soup_result found;
  std::vector<Edge> cut_edges; // ordered
  Corner_map map;              // for `Output_kind::MAP`
  int number_of_charts = 0;
  double uv_scale = 1;         // length of an edge in the map over that on the surface
  std::optional<double> fill;  // area of the charts in the unit square, if they are packed there
  std::vector<double> page_fills;
  SMC::Run_profile profile;    // without packing
  double packing_seconds = 0, packing_cpu_seconds = 0;
};

// Charts are packed if there are `packing` options.
Cut_surface cut_surface(const Surface_arguments& arguments, const Cutting_options& options,
                        const std::optional<Packing_options>& packing, Run_monitor& monitor);

// The marked edges of the soup.
std::vector<Edge> named_cut(const Soup_adapter& adapter, const SMC::internal::Cut& cut);

} // namespace binding

#endif // SURFACE_MESH_CUTTING_PYTHON_CUT_SURFACE_H
