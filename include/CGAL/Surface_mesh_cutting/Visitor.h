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

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// the phases of a run, in order. Each component goes through them, with several starts more than once.
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
/// is the visitor that does nothing; derive your own from it.
/// \cgalModels{CuttingVisitor}
///
/// The named parameter `visitor` takes a visitor, by `std::ref` unless a copy will do.
/// Only one thread at a time calls its functions, even with `Parallel_tag`.
struct Default_visitor
{
  /// is called before each factorization and between the steps of every search: every few
  /// milliseconds on small meshes, every few seconds on meshes of a million triangles.
  /// \return `false` to end the run, which then returns `Status_code::STOPPED`
  bool go_further() const { return true; }

  /// is called with the progress of a phase; `fraction` is between 0 and 1.
  void progress(Phase, double /* fraction */) {}
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_VISITOR_H
