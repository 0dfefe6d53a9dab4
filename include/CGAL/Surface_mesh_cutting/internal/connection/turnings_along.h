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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_TURNINGS_ALONG_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_TURNINGS_ALONG_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/connection/Key_paths.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Turning.h>

#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The turnings of a way at its inner vertices.
inline std::vector<double> turnings_along(const Indexed_mesh& mesh, const Turning& turning, const Key_paths::Path& path)
{
  std::vector<double> result;
  int v = path.source, in = -1;
  for(int e : path.edges)
  {
    const int out = turning.halfedge_from(e, v);
    if(in >= 0)
      result.push_back(turning(in, out));
    in = out;
    v = mesh.target(out);
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONNECTION_TURNINGS_ALONG_H
