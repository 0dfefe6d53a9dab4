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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_WELDING_ADVICE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_WELDING_ADVICE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Soup_surface.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Welded_vertices.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Welding.h>

#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/read_soup.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// What welding would change about a surface.
struct Welding_advice
{
  double tolerance = 0;
  int vertices = 0; // that are at the point of a former one, or near it
  int pieces = 0, pieces_if_welded = 0;
  int joined_edges = 0;

  // Not where nothing would be left.
  explicit operator bool() const
  {
    return vertices > 0 && pieces_if_welded > 0 && (pieces_if_welded < pieces || joined_edges > 0);
  }
};

// How the user asks for welding; a tolerance stands between two of the words.
struct Welding_words
{
  std::string on, before_tolerance, after_tolerance;

  std::string message(const Welding_advice& advice) const
  {
    std::ostringstream text;
    text << advice.vertices << (advice.vertices == 1 ? " vertex is" : " vertices are");
    if(advice.tolerance > 0)
      text << " within " << advice.tolerance << " bounding box diagonals of another one; with " << before_tolerance
           << advice.tolerance << after_tolerance;
    else
      text << " at the same point as another one; with " << on;
    if(advice.pieces_if_welded < advice.pieces)
      text << ", the surface has " << advice.pieces_if_welded << (advice.pieces_if_welded == 1 ? " piece" : " pieces")
           << " instead of " << advice.pieces;
    else
      text << ", " << advice.joined_edges << (advice.joined_edges == 1 ? " more edge is" : " more edges are")
           << " inside of the surface";
    return text.str();
  }
};

// Finds out whether welding, or welding border vertices within a tolerance, would leave fewer pieces. Linear time unless some
// are near enough.
class Welding_adviser
{
public:
  Welding_adviser(const std::vector<Point>& points, const Polygons& soup, const Soup_surface& surface,
                  const Welding& welding, Execution execution, const Go_further& go_further)
    : m_points(points), m_soup(soup), m_surface(surface), m_welding(welding), m_execution(execution),
      m_go_further(go_further)
  {
    for(int p = 0; p < surface.polygons.number(); ++p)
      for(int c = surface.polygons.begin(p); c < surface.polygons.end(p); ++c)
        if(surface.opposites[c] < 0)
          for(int corner : {c, surface.polygons.next(p, c)})
            m_border.vertices.push_back(surface.origins[surface.polygons.vertices[corner]]);
    m_border.close();
  }

  Welding_advice operator()() const
  {
    const Welding_advice exact = m_surface.is_welded ? Welding_advice() : advice(0, number_of_welded(m_soup, 0));
    const int number_of_equal = number_of_welded(m_border, 0);
    Welding_advice best = exact;
    for(const double tolerance : {1e-5, 1e-6, 1e-7, 1e-8}) // the least one that helps
    {
      const int number = number_of_welded(m_border, tolerance);
      if((m_surface.is_welded && tolerance <= m_welding.tolerance) || number == number_of_equal)
        break;
      const Welding_advice next = advice(tolerance, number);
      const bool is_better = best.tolerance > 0 ? next.pieces_if_welded == best.pieces_if_welded
                                                : next.pieces_if_welded < (exact ? exact.pieces_if_welded : next.pieces);
      if(!is_better)
        break;
      best = next;
    }
    return best;
  }

private:
  int number_of_welded(const Polygons& polygons, double tolerance) const
  {
    const std::vector<int> first = Welded_vertices(m_points, polygons, tolerance, m_welding.parts).representatives();
    int number = 0;
    for(int v = 0; v < int(first.size()); ++v)
      number += first[v] != v;
    return number;
  }

  Welding_advice advice(double tolerance, int number_of_vertices) const
  {
    Welding_advice result;
    result.tolerance = tolerance;
    result.vertices = number_of_vertices;
    if(result.vertices == 0)
      return result;
    const Soup_surface welded
      = read_soup(m_points, m_soup, {Welding::ON, tolerance, m_welding.parts}, m_execution, m_go_further);
    if(welded.is_stopped)
      return Welding_advice();
    result.pieces = number_of_pieces(m_surface);
    result.pieces_if_welded = number_of_pieces(welded);
    result.joined_edges = (number_of_border_sides(m_surface) - number_of_border_sides(welded)) / 2;
    return result;
  }

  static int number_of_border_sides(const Soup_surface& surface)
  {
    return int(std::count(surface.opposites.begin(), surface.opposites.end(), -1));
  }

  static int number_of_pieces(const Soup_surface& surface)
  {
    CGAL::internal::Graph_kernel::Disjoint_sets pieces(surface.polygons.number());
    const std::vector<int> owners = surface.polygons.owners();
    int number = surface.polygons.number();
    for(std::size_t c = 0; c < owners.size(); ++c)
      if(surface.opposites[c] >= 0)
        number -= pieces.unite(owners[c], owners[surface.opposites[c]]);
    return number;
  }

  const std::vector<Point>& m_points;
  const Polygons& m_soup;
  const Soup_surface& m_surface;
  const Welding& m_welding;
  const Execution m_execution;
  const Go_further& m_go_further;
  Polygons m_border;
};

// What the user should know about how a soup is read, in plain words.
inline std::vector<std::string> soup_warnings(const Soup_surface& surface, const Welding_advice& advice,
                                              const Welding_words& words)
{
  std::vector<std::string> warnings;
  for(const Interpretation& finding : surface.findings)
    if(finding.kind == Interpretation_kind::DUPLICATE_FACES)
      warnings.push_back(std::to_string(finding.polygons.size())
                         + (finding.polygons.size() == 1 ? " face repeats a former one and lies" : " faces repeat former ones and lie")
                         + " on the same texture coordinates; the first is face "
                         + std::to_string(finding.polygons.front()));
  if(advice)
    warnings.push_back(words.message(advice));
  return warnings;
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_WELDING_ADVICE_H
