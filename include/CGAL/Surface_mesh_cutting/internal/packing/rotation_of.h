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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_ROTATION_OF_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_ROTATION_OF_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Chart_rotation.h>

#include <string>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// As command lines and other languages call it; the default if they call nothing.
inline Chart_rotation rotation_of(const std::string& name)
{
  return name == "any" ? Chart_rotation::ANY : name == "quarter" ? Chart_rotation::QUARTER
       : name == "none" ? Chart_rotation::NONE : name == "upright" ? Chart_rotation::UPRIGHT : Chart_rotation::AUTOMATIC;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_ROTATION_OF_H
