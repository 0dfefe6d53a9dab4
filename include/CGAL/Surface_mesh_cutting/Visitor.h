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
/// the phases of a run, in their order.
enum class Phase
{
  CANDIDATES,  ///< handles, first cuts, conformal maps, candidates for feature points
  FILTER,      ///< the choice among the candidates
  CONNECT,     ///< the tree through the feature points
  REFINE,      ///< repair and shortening of the connected cut
  PARAMETERIZE ///< the final UVs
};

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// is called back during a run and does nothing; a visitor of your own may derive from it.
/// \cgalModels{CuttingVisitor}
///
/// A visitor is passed by the named parameter `visitor`, by `std::ref` if it is not to be copied.
/// With `Parallel_tag` its functions are still called by one thread at a time.
struct Default_visitor
{
  /// is asked before each factorization and between steps of every search, every few
  /// milliseconds on small meshes, every few seconds on meshes of a million triangles.
  /// \return `false` to end the run; it then returns `Status_code::STOPPED`
  bool go_further() const { return true; }

  /// is told how far a phase has come, `fraction` being between 0 and 1.
  void progress(Phase, double /* fraction */) {}
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_VISITOR_H
