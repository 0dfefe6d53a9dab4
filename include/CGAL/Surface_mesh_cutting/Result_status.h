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

#ifndef CGAL_SURFACE_MESH_CUTTING_RESULT_STATUS_H
#define CGAL_SURFACE_MESH_CUTTING_RESULT_STATUS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Status_code.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Descriptors.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// describes a finding about a mesh, and names the elements concerned.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
template <typename TriangleMesh>
struct Finding
{
  /// the types that stand for elements: those of `boost::graph_traits<TriangleMesh>`, or those of `Polygon_soup`.
  using Descriptors = internal::Descriptors<TriangleMesh>;

  /// the kind of the finding.
  Status_code code = Status_code::OK;
  /// one line for a human reader. It names the first elements: vertices and faces by their positions
  /// in `vertices(tmesh)` and `faces(tmesh)`, edges by their two vertices. Empty if there is nothing
  /// to report. The `code` of a warning is `Status_code::OK`.
  std::string message;
  /// the vertices concerned; at most one of the three lists is not empty.
  std::vector<typename Descriptors::vertex_descriptor> vertices;
  /// the edges concerned.
  std::vector<typename Descriptors::edge_descriptor> edges;
  /// the faces concerned.
  std::vector<typename Descriptors::face_descriptor> faces;
};

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// tells how a call ended. The object itself is the finding that ended the call; `warnings` holds
/// the other findings. User data never violates a precondition: a `Result_status` reports all defects of the
/// data.
///
/// \tparam TriangleMesh a model of `FaceListGraph`
template <typename TriangleMesh>
struct Result_status : public Finding<TriangleMesh>
{
  /// findings that did not end the call: isolated vertices, degenerate faces…
  std::vector<Finding<TriangleMesh> > warnings;

  /// `true` iff everything requested was computed.
  explicit operator bool() const { return this->code == Status_code::OK; }
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_RESULT_STATUS_H
