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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_COINCIDENT_VERTICES_WARNING_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_COINCIDENT_VERTICES_WARNING_H

#include <CGAL/license/Surface_mesh_cutting.h>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Of meshes. Those who make a mesh of a polygon soup, in which these may be one vertex, give a warning of their own.
constexpr const char* coincident_vertices_warning = "vertices at the same point: does the surface need to be stitched?";

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SURFACE_COINCIDENT_VERTICES_WARNING_H
