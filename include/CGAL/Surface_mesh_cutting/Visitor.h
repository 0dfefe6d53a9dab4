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

#ifndef CGAL_SURFACE_MESH_CUTTING_VISITOR_H
#define CGAL_SURFACE_MESH_CUTTING_VISITOR_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Run_profile.h>

#include <string>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// the phases of a run, in order. Each component and each start goes through them.
enum class Phase
{
  CANDIDATES,  ///< handles, first cuts, conformal maps, candidates for feature points
  FILTER,      ///< the selection among the candidates
  CONNECT,     ///< the tree through the feature points
  REFINE,      ///< improvement of the connected cut
  PARAMETERIZE, ///< the final UVs, and room for bijective maps
  PACK          ///< places for the charts in the unit square, in `pack_charts()`
};

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// returns the name of a phase in lower case, such as `"candidates"`.
inline std::string to_string(Phase phase)
{
  switch(phase)
  {
  case Phase::CANDIDATES:   return "candidates";
  case Phase::FILTER:       return "filter";
  case Phase::CONNECT:      return "connect";
  case Phase::REFINE:       return "refine";
  case Phase::PARAMETERIZE: return "parameterize";
  case Phase::PACK:         return "pack";
  }
  return "";
}

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// is a visitor that does nothing; a base class for other visitors.
/// \cgalModels{CuttingVisitor}
///
/// The named parameter `visitor` copies the visitor; pass it by `std::ref` to keep it.
/// Only one thread at a time calls its functions, even with `Parallel_tag`.
struct Default_visitor
{
  /// is called before each factorization and between the steps of every search: every few
  /// milliseconds on small meshes, every few seconds on meshes of a million triangles.
  /// \return `false` to end the run, which then returns `Status_code::STOPPED` and the best result so far
  bool go_further() const { return true; }

  /// is called with the current phase and the fraction of the whole run that is done: `fraction` is an estimate between
  /// 0 and 1 that never decreases, and is 1 when the run has succeeded. Phases recur with each start.
  void progress(Phase, double /* fraction */) {}

  /// is called once, at the end of a run, with what it took.
  void ended(const Run_profile&) {}
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_VISITOR_H
