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

#include <algorithm>
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
// packed both ways; more of them on a coarse grid only, since what follows takes most of the time.
inline std::optional<Packed_charts> pack_aligned_if_cheap(const std::vector<Chart_outline>& outlines, double margin,
                                                   Effort effort, Execution execution, Run_control& control,
                                                   const Page_demand& demand)
{
  constexpr int few = 100;
  constexpr double aligned_share = 0.5; // of the time
  const bool are_few = int(outlines.size()) <= few;
  double furthest = 0; // reported
  const auto part = [&](double begin, double end)
  {
    return [&, begin, end](Phase phase, double fraction)
    {
      furthest = (std::max)(furthest, begin + fraction * (end - begin));
      control.report(phase, furthest);
    };
  };
  Run_control first([&control] { return control.go_further(); }, part(0, aligned_share));
  Run_control second([&control] { return control.go_further(); }, part(aligned_share, 1));
  Chart_packer aligned_packer(outlines, margin, effort, Chart_rotation::QUARTER, execution, first, demand);
  Chart_packer packer(outlines, margin, effort, Chart_rotation::ANY, execution, second, demand);

  const std::optional<Packed_charts> aligned = are_few ? aligned_packer.pack() : aligned_packer.pack_coarsely();
  const bool is_enough = is_rectilinear(outlines) || (aligned && is_nearly_as_large(aligned->scale, packer.largest_scale()));
  if(aligned && (is_enough || control.is_stopped()))
    return are_few ? aligned : aligned_packer.refine();
  packer.take_boxes_of(aligned_packer);
  const std::optional<Packed_charts> turned = are_few ? packer.pack() : packer.pack_coarsely();
  if(aligned && (!turned || is_nearly_as_large(aligned->scale, turned->scale)))
    return are_few ? aligned : aligned_packer.refine();
  return are_few ? turned : packer.refine();
}

// Packs charts at a given scale on as few pages as it finds, aligned with the axes if that takes no more of them.
inline std::optional<Packed_charts> pack_at_scale(const std::vector<Chart_outline>& outlines, double margin, Effort effort,
                                           Chart_rotation rotation, Execution execution, Run_control& control,
                                           const Page_demand& demand)
{
  const auto pack_with = [&](Chart_rotation decided)
  { return Chart_packer(outlines, margin, effort, decided, execution, control, demand).pack_at_most_scale(); };
  if(rotation != Chart_rotation::AUTOMATIC)
    return pack_with(rotation);
  const std::optional<Packed_charts> aligned = pack_with(Chart_rotation::QUARTER);
  if(aligned && aligned->number_of_pages() == 1)
    return aligned;
  const std::optional<Packed_charts> turned = pack_with(Chart_rotation::ANY);
  return aligned && (!turned || aligned->number_of_pages() <= turned->number_of_pages()) ? aligned : turned;
}

// Packs charts into the unit squares of pages, at the largest scale that it finds; see `Chart_packer`.
inline std::optional<Packed_charts> pack_outlines(const std::vector<Chart_outline>& outlines, double margin, Effort effort,
                                           Chart_rotation rotation, Execution execution, Run_control& control,
                                           const Page_demand& demand = {})
{
  if(rotation == Chart_rotation::AUTOMATIC)
    return pack_aligned_if_cheap(outlines, margin, effort, execution, control, demand);
  return Chart_packer(outlines, margin, effort, rotation, execution, control, demand).pack();
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACK_OUTLINES_H
