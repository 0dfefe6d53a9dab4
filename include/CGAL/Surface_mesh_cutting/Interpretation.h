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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERPRETATION_H
#define CGAL_SURFACE_MESH_CUTTING_INTERPRETATION_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// what in a polygon soup is not a plain surface, and how `unwrap_polygon_soup()` reads it. Points and polygons stay
/// as they are.
enum class Interpretation_kind
{
  NON_MANIFOLD_EDGES,    ///< edges with more than two polygons. Pairs of these polygons stay connected, chosen so that
                         ///  borders get short and sheets continue; the others get a border there.
  NON_MANIFOLD_VERTICES, ///< vertices whose polygons do not hang together through edges. The surface has one vertex for
                         ///  each fan.
  REORIENTED_FACES,      ///< polygons read backward, so that all neighbors agree about which side is up.
  DEGENERATE_FACES,      ///< polygons without area: fewer than three different corners, or all sides lead there and back.
                         ///  They are not part of the surface; their corners get UVs of the place where they lie.
  DUPLICATE_FACES,       ///< polygons with the vertices of a former one in the same cyclic order. They are not part of
                         ///  the surface; their corners get the UVs of the former one, on which they lie. They are no
                         ///  overlaps.
  WELDED_VERTICES,       ///< vertices taken for a former one at exactly the same point, or within the tolerance.
  NON_ORIENTABLE_EDGES,  ///< edges that are opened because the surface has only one side, as a Moebius strip.
  REPEATED_CORNERS,      ///< polygons with corners that are left out, as they repeat their neighbors or lead there and back.
                         ///  These get the UVs of the corners that they count as.
  DIVIDED_FACES          ///< polygons that visit a vertex several times and are read as the loops between the visits.
                         ///  Those whose hole is connected by a bridge are not divided.
};

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// the occurrences of one kind; one of the three lists is not empty.
struct Interpretation
{
  Interpretation_kind kind;                       ///< what was found.
  std::vector<std::size_t> vertices;              ///< indices of points.
  std::vector<std::array<std::size_t, 2> > edges; ///< pairs of indices of points.
  std::vector<std::size_t> polygons;              ///< indices of polygons.

  /// the number of occurrences.
  std::size_t count() const { return vertices.size() + edges.size() + polygons.size(); }
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERPRETATION_H
