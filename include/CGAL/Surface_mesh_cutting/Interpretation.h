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
/// the kinds of defects of a polygon soup, and how `unwrap_polygon_soup()` reads them. Points and polygons stay as they
/// are.
enum class Interpretation_kind
{
  NON_MANIFOLD_EDGES,    ///< edges with more than two polygons. Pairs of these polygons stay connected, chosen so that
                         ///  borders get short and sheets continue; the others get a border there.
  NON_MANIFOLD_VERTICES, ///< vertices whose polygons form several fans. The surface has one vertex for each fan.
  REORIENTED_FACES,      ///< polygons read backward, so that all neighbors agree about which side is up.
  DEGENERATE_FACES,      ///< polygons without area: fewer than three different corners, or all sides lead there and back.
                         ///  They are not part of the surface; their corners get UVs of the place where they lie.
  DUPLICATE_FACES,       ///< polygons with the vertices of an earlier polygon in the same cyclic order. They are not part
                         ///  of the surface; their corners get the UVs of the earlier polygon. They count as no overlaps.
  WELDED_VERTICES,       ///< vertices merged with an earlier one at exactly the same point, or within the tolerance.
  NON_ORIENTABLE_EDGES,  ///< edges that are opened because the surface has only one side, like a Moebius strip.
  REPEATED_CORNERS,      ///< polygons with corners that are left out, as they repeat their neighbors or lead there and back.
                         ///  These corners get the UVs of the corners that they repeat.
  DIVIDED_FACES          ///< polygons that visit a vertex several times and are read as the loops between the visits.
                         ///  A polygon with a hole that is connected by a bridge is not divided.
};

/// \ingroup PkgSurfaceMeshCuttingRef
///
/// holds all defects of one kind; exactly one of the three lists is not empty.
struct Interpretation
{
  Interpretation_kind kind;                       ///< kind of the defect.
  std::vector<std::size_t> vertices;              ///< indices of points.
  std::vector<std::array<std::size_t, 2> > edges; ///< pairs of indices of points.
  std::vector<std::size_t> polygons;              ///< indices of polygons.

  /// returns the number of defects.
  std::size_t count() const { return vertices.size() + edges.size() + polygons.size(); }
};

} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERPRETATION_H
