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

#ifndef CGAL_SURFACE_MESH_CUTTING_CHART_ROTATION_H
#define CGAL_SURFACE_MESH_CUTTING_CHART_ROTATION_H

#include <CGAL/license/Surface_mesh_cutting.h>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// how `pack_charts()` may turn charts; the value of the named parameter `chart_rotation`.
///
/// A chart is aligned with the axes if its border runs along them as far as the border has such directions, and otherwise if
/// the smallest rectangle around the chart does. A chart with an axis of symmetry, or a pair of mirrored charts, is aligned
/// if the axis is vertical or horizontal.
enum class Chart_rotation
{
  AUTOMATIC, ///< tries `QUARTER` and `ANY`, and takes `QUARTER` if the charts then fill at least 97 % of the area that they
             ///< fill with `ANY`, or if the only chart has straight sides at right angles, like the net of a box. With more
             ///< than 100 charts, it compares packings on a grid; with `texels_per_unit`, takes `QUARTER` if it needs no more
             ///< pages than `ANY`
  ANY,       ///< turns charts by any angle
  QUARTER,   ///< aligns charts with the axes, and then turns them by quarter turns only
  NONE,      ///< keeps the directions of the input
  UPRIGHT    ///< with the named parameter `symmetry`, makes the axes of symmetric charts and of pairs of mirrored ones vertical;
             ///< without it, or such charts, this is `QUARTER`
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_CHART_ROTATION_H
