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

#ifndef CGAL_SURFACE_MESH_CUTTING_TRADE_OFF_H
#define CGAL_SURFACE_MESH_CUTTING_TRADE_OFF_H

#include <CGAL/license/Surface_mesh_cutting.h>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// holds the cost of a cut that a run considered, and the distortion of the surface opened along it.
struct Trade_off
{
  double cut_length = 0;         ///< total length of the cut edges.
  double cut_cost = 0;           ///< total weight of the cut edges; their length unless `edge_weight_map` is given.
  double average_distortion = 0; ///< area-averaged symmetric Dirichlet energy; 4 is ideal.
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_TRADE_OFF_H
