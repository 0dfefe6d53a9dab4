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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_NAME_OF_INTERPRETATION_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_NAME_OF_INTERPRETATION_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Interpretation.h>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// As reports and other languages call it.
inline const char* name_of(Interpretation_kind kind)
{
  switch(kind)
  {
    case Interpretation_kind::NON_MANIFOLD_EDGES: return "non_manifold_edges";
    case Interpretation_kind::NON_MANIFOLD_VERTICES: return "non_manifold_vertices";
    case Interpretation_kind::REORIENTED_FACES: return "reoriented_faces";
    case Interpretation_kind::DEGENERATE_FACES: return "degenerate_faces";
    case Interpretation_kind::DUPLICATE_FACES: return "duplicate_faces";
    case Interpretation_kind::WELDED_VERTICES: return "welded_vertices";
    case Interpretation_kind::NON_ORIENTABLE_EDGES: return "non_orientable_edges";
    case Interpretation_kind::REPEATED_CORNERS: return "repeated_corners";
    case Interpretation_kind::DIVIDED_FACES: return "divided_faces";
  }
  return "";
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_NAME_OF_INTERPRETATION_H
