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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_SIDE_CHOICE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_SIDE_CHOICE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <tuple>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// How good it is to connect two sides of an edge: what is compared first comes first.
struct Side_choice
{
  int fans = -1; // that this closes
  bool is_same_piece = false;
  int reverses = 0; // sides whose polygons are there reversed, too: who has fewer partners is connected first
  bool agrees = false;
  double flatness = 0;
  int first = -1, second = -1; // sides of the edge

  bool operator<(const Side_choice& other) const
  {
    return std::tie(fans, is_same_piece, reverses, agrees, flatness)
           < std::tie(other.fans, other.is_same_piece, other.reverses, other.agrees, other.flatness);
  }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_SIDE_CHOICE_H
