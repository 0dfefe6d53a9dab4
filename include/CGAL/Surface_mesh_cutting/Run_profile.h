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

#ifndef CGAL_SURFACE_MESH_CUTTING_RUN_PROFILE_H
#define CGAL_SURFACE_MESH_CUTTING_RUN_PROFILE_H

#include <CGAL/license/Surface_mesh_cutting.h>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// holds the seconds spent in each phase of a run. With `Parallel_tag`, the phases of different components and starts
/// overlap, and their times add up to more than the total.
struct Phase_times
{
  double candidates = 0;   ///< handles, first cuts, conformal maps, candidates
  double filter = 0;       ///< selection among the candidates
  double connect = 0;      ///< the tree through the feature points
  double refine = 0;       ///< improvement of the connected cut
  double parameterize = 0; ///< the final UVs, and room for bijective maps
  double total = 0;        ///< everything, including work outside of these phases
};

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

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// holds what a run took, which visitors are told.
struct Run_profile
{
  Phase_times seconds;     ///< wall time.
  Phase_times cpu_seconds; ///< processor time of all threads.
  /// number of unknowns, summed over all numeric factorizations of linear systems: a cost that does not depend on the
  /// machine. One factorization for a map of the whole surface counts about two per vertex. With `Parallel_tag`, the sum
  /// includes steps that were tried in advance and discarded, and the phases of different components and starts overlap.
  Phase_counts factorized_unknowns;
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_RUN_PROFILE_H
