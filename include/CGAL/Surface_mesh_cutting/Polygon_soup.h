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

#ifndef CGAL_SURFACE_MESH_CUTTING_POLYGON_SOUP_H
#define CGAL_SURFACE_MESH_CUTTING_POLYGON_SOUP_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/input/Descriptors.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// stands for a polygon soup in result types: vertices and faces are indices of points and polygons, and edges are pairs of
/// indices of points, the lower one first.
struct Polygon_soup {};

namespace internal {

template <>
struct Descriptors<Polygon_soup>
{
  using vertex_descriptor = std::size_t;
  using edge_descriptor = std::pair<std::size_t, std::size_t>;
  using face_descriptor = std::size_t;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_POLYGON_SOUP_H
