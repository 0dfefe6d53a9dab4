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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACK_OUTLINES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACK_OUTLINES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/Chart_packer.h>

#include <complex>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Whether charts that are aligned with the axes at one scale cost at most 3 % of what they fill at another one.
inline bool is_nearly_as_large(double aligned_scale, double scale)
{
  constexpr double least_share = 0.97; // of the area
  return aligned_scale * aligned_scale >= least_share * scale * scale;
}

// Whether the layout is a single chart with straight sides at right angles, such as the net of a box.
inline bool is_rectilinear(const std::vector<Chart_outline>& outlines)
{
  constexpr double nearly = 0.95;
  return outlines.size() == 1 && std::abs(mean_direction(outlines.front())) > nearly;
}

// The charts aligned with the axes, unless turning them anyhow fills more by more than 3 %. Up to a hundred charts are
// packed both ways; more of them on grids only, since what follows takes most of the time.
inline std::optional<Packed_charts> pack_aligned_if_cheap(const std::vector<Chart_outline>& outlines, double margin,
                                                   Effort effort, Execution execution, Run_control& control)
{
  constexpr int few = 100;
  constexpr double aligned_share = 0.5; // of the time
  const bool are_few = int(outlines.size()) <= few;
  const auto part = [&control](double begin, double end)
  {
    return [&control, begin, end](Phase phase, double fraction)
    { control.report(phase, begin + fraction * (end - begin)); };
  };
  Run_control first([&control] { return control.go_further(); }, part(0, aligned_share));
  Run_control second([&control] { return control.go_further(); }, part(aligned_share, 1));
  Chart_packer aligned_packer(outlines, margin, effort, Chart_rotation::QUARTER, execution, first);
  Chart_packer packer(outlines, margin, effort, Chart_rotation::ANY, execution, second);

  const std::optional<Packed_charts> aligned = are_few ? aligned_packer.pack() : aligned_packer.pack_on_grids();
  const bool is_enough = is_rectilinear(outlines) || (aligned && is_nearly_as_large(aligned->scale, packer.largest_scale()));
  if(aligned && (is_enough || control.is_stopped()))
    return are_few ? aligned : aligned_packer.grow_off_grid();
  const std::optional<Packed_charts> turned = are_few ? packer.pack() : packer.pack_on_grids();
  if(aligned && (!turned || is_nearly_as_large(aligned->scale, turned->scale)))
    return are_few ? aligned : aligned_packer.grow_off_grid();
  return are_few ? turned : packer.grow_off_grid();
}

// Packs charts into the unit square; see `Chart_packer`.
inline std::optional<Packed_charts> pack_outlines(const std::vector<Chart_outline>& outlines, double margin, Effort effort,
                                           Chart_rotation rotation, Execution execution,
                                           Run_control& control)
{
  if(rotation == Chart_rotation::AUTOMATIC)
    return pack_aligned_if_cheap(outlines, margin, effort, execution, control);
  return Chart_packer(outlines, margin, effort, rotation, execution, control).pack();
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACK_OUTLINES_H
