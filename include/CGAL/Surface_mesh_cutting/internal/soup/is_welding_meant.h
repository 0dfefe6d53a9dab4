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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_IS_WELDING_MEANT_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_IS_WELDING_MEANT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/soup/Soup_edges.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Welded_vertices.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Welding.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/are_polygons_apart.h>

#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Whether a soup consists of pieces of a few polygons that nearly all meet along their borders, as programs write surfaces with
// flat shading: at least three quarters of the border edges have the ends of exactly one other border edge, in the opposite
// direction. Parts that were separated on purpose are larger.
inline bool do_small_pieces_meet(const std::vector<Point>& points, const Polygons& polygons, const std::vector<int>& parts,
                                 Execution execution)
{
  constexpr int polygons_per_piece = 10; // on average
  CGAL::internal::Graph_kernel::Disjoint_sets pieces(int(points.size()));
  for(int p = 0; p < polygons.number(); ++p)
    for(int c = polygons.begin(p); c < polygons.end(p); ++c)
      pieces.unite(polygons.vertices[c], polygons.vertices[polygons.begin(p)]);
  std::vector<char> is_piece(points.size(), 0);
  for(int v : polygons.vertices)
    is_piece[pieces.find(v)] = 1;
  const auto number_of_pieces = std::count(is_piece.begin(), is_piece.end(), char(1));
  if(number_of_pieces < 2 || polygons_per_piece * number_of_pieces < polygons.number())
    return false;

  Polygons welded = polygons;
  const std::vector<int> representatives = Welded_vertices(points, polygons, 0, parts).representatives();
  for(int& v : welded.vertices)
    v = representatives[v];
  const std::vector<char> all(polygons.ends.size(), 1);
  const Soup_edges edges(polygons, all, int(points.size()), execution);
  const Soup_edges welded_edges(welded, all, int(points.size()), execution);
  std::vector<char> is_border(polygons.vertices.size(), 0);
  for(int e = 0; e < edges.number(); ++e)
    is_border[edges.side(e, 0).corner] = edges.size(e) == 1;
  std::size_t number_of_joined = 0;
  for(int e = 0; e < welded_edges.number(); ++e)
    if(welded_edges.size(e) == 2 && welded_edges.low(e) != welded_edges.high(e) &&
       welded_edges.side(e, 0).is_upward != welded_edges.side(e, 1).is_upward &&
       is_border[welded_edges.side(e, 0).corner] && is_border[welded_edges.side(e, 1).corner])
      number_of_joined += 2;
  const auto number_of_borders = std::size_t(std::count(is_border.begin(), is_border.end(), char(1)));
  return number_of_joined > 0 && 4 * number_of_joined >= 3 * number_of_borders;
}

// Whether vertices count as one with `Welding::AUTO`.
inline bool is_welding_meant(const std::vector<Point>& points, const Polygons& polygons, const Welding& welding,
                             Execution execution)
{
  return welding.tolerance > 0 || are_polygons_apart(polygons.vertices, points.size(), polygons.number()) ||
         do_small_pieces_meet(points, polygons, welding.parts, execution);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_IS_WELDING_MEANT_H
