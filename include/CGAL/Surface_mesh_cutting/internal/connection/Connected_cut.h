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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_CONNECTED_CUT_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_CONNECTED_CUT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A cut that leaves only disks: the mandatory edges and a tree in each part that those leave.
struct Connected_cut
{
  Indexed_status status;
  Cut cut;
  double weight = 0;      // of the edges that were added
  double lower_bound = 0; // proven, for the weight
  bool is_optimal = true;
  int number_of_auxiliary_points = 0;

  // A stopped search leaves a cut, too, unless it was stopped before its start.
  bool has_cut() const
  {
    return !cut.empty() && (status.has_result() || status.finding.code == Status_code::STOPPED);
  }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_CONNECTED_CUT_H
