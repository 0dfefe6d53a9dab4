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

#include <string>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// the phases of a run, in order. Each component goes through them, and each of several starts.
enum class Phase
{
  CANDIDATES,  ///< handles, first cuts, conformal maps, candidates for feature points
  FILTER,      ///< the selection among the candidates
  CONNECT,     ///< the tree through the feature points
  REFINE,      ///< repair and shortening of the connected cut
  PARAMETERIZE, ///< the final UVs, and room for them where parts of a chart are in each other's way
  PACK          ///< the places of the charts in the unit square, for `pack_charts()`
};

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// returns the name of a phase in lower case, as `"candidates"`.
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
/// is the visitor that does nothing; derive your own from it.
/// \cgalModels{CuttingVisitor}
///
/// The named parameter `visitor` takes a visitor, by `std::ref` unless a copy will do.
/// Only one thread at a time calls its functions, even with `Parallel_tag`.
struct Default_visitor
{
  /// is called before each factorization and between the steps of every search: every few
  /// milliseconds on small meshes, every few seconds on meshes of a million triangles.
  /// \return `false` to end the run, which then returns `Status_code::STOPPED` and the best result so far
  bool go_further() const { return true; }

  /// is called with what the run does at present and how much of the whole run is done: `fraction` is an estimate between
  /// 0 and 1 that never decreases, and is 1 when the run has succeeded. Phases come again with each start.
  void progress(Phase, double /* fraction */) {}
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_VISITOR_H
