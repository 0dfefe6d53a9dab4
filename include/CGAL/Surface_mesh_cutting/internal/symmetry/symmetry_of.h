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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_SYMMETRY_OF_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_SYMMETRY_OF_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Symmetry.h>

#include <string>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// As command lines and other languages call it; the default if they call nothing.
inline Symmetry symmetry_of(const std::string& name)
{
  return name == "auto" ? Symmetry::AUTOMATIC : name == "x" ? Symmetry::X : name == "y" ? Symmetry::Y
       : name == "z" ? Symmetry::Z : Symmetry::NONE;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SYMMETRY_SYMMETRY_OF_H
