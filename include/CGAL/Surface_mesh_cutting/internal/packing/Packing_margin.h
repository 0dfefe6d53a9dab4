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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACKING_MARGIN_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACKING_MARGIN_H

#include <CGAL/license/Surface_mesh_cutting.h>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A distance between charts, and from the border of the unit square.
struct Packing_margin
{
  double texels;
  int texture_size; // texels along a side of the square

  double distance() const { return texels / texture_size; }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACKING_MARGIN_H
