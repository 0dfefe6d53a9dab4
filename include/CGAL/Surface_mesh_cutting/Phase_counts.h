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

#ifndef CGAL_SURFACE_MESH_CUTTING_PHASE_COUNTS_H
#define CGAL_SURFACE_MESH_CUTTING_PHASE_COUNTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// holds a count for each phase of a run, as `Phase_times` holds a time.
struct Phase_counts
{
  long long candidates = 0;   ///< handles, first cuts, conformal maps, candidates
  long long filter = 0;       ///< selection among the candidates
  long long connect = 0;      ///< the tree through the feature points
  long long refine = 0;       ///< improvement of the connected cut
  long long parameterize = 0; ///< the final UVs, and room for bijective maps
  long long total = 0;        ///< everything, including work outside of these phases
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_PHASE_COUNTS_H
