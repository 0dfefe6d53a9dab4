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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_POLYGON_PARTS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_POLYGON_PARTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/soup/Polygons.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/constrained_triangulation.h>

#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The polygons of a soup without what has no area. Neighboring corners at the same vertex are one corner. A polygon that has a
// vertex more than once stays whole where it is a disk that touches itself, as a polygon is whose hole is connected by a
// bridge. Else it is divided into the loops between its visits of a vertex, of which those with two corners are left out.
class Polygon_parts
{
public:
  // O(n) on polygons that do not touch themselves; others are triangulated. Stops where that takes long.
  Polygon_parts(const std::vector<Point>& points, const Polygons& soup, const Go_further& go_further)
    : m_points(points), m_soup(soup), m_go_further(go_further), m_substitutes(soup.vertices.size(), -1)
  {
    m_polygons.vertices.reserve(soup.vertices.size());
    m_polygons.ends.reserve(soup.ends.size());
    m_corners.reserve(soup.vertices.size());
    m_origins.reserve(soup.ends.size());
    const std::vector<char> is_simple = soup.are_simple(int(points.size()));
    for(int p = 0; p < soup.number() && !m_is_stopped; ++p)
      if(is_simple[p])
      {
        for(int c = soup.begin(p); c < soup.end(p); ++c)
          keep(c);
        close(p);
      }
      else
        divide(p);
  }

  const Polygons& polygons() const { return m_polygons; }
  // Per part, the polygon of the soup.
  const std::vector<int>& origins() const { return m_origins; }
  // Per corner of a part, that of the soup.
  const std::vector<int>& corners() const { return m_corners; }
  // Per corner of the soup, the one that it counts as, which is in a part; -1 in polygons without area.
  const std::vector<int>& substitutes() const { return m_substitutes; }

  // Of the soup.
  const std::vector<int>& without_area() const { return m_without_area; }
  const std::vector<int>& with_repeated_corners() const { return m_with_repeated_corners; }
  const std::vector<int>& divided() const { return m_divided; }

  // Then the parts are any.
  bool is_stopped() const { return m_is_stopped; }

private:
  int vertex(int c) const { return m_soup.vertices[c]; }

  void keep(int c)
  {
    m_substitutes[c] = c;
    m_corners.push_back(c);
    m_polygons.vertices.push_back(vertex(c));
  }

  void close(int p)
  {
    m_polygons.close();
    m_origins.push_back(p);
  }

  void divide(int p)
  {
    const std::vector<int> outline = without_repetitions(p);
    const int former = int(m_corners.size());
    std::vector<std::vector<int> > parts = loops(outline);
    const bool is_whole = parts.size() == 1 && parts.front().size() == outline.size();
    if(outline.size() >= 3 && !is_whole && is_disk(outline))
      parts = {outline};
    else if(parts.size() > 1)
      m_divided.push_back(p);
    for(const std::vector<int>& part : parts)
    {
      for(int c : part)
        keep(c);
      close(p);
    }
    const int number_of_kept = int(m_corners.size()) - former;
    if(number_of_kept == 0)
      m_without_area.push_back(p);
    else if(number_of_kept < m_soup.size(p))
    {
      m_with_repeated_corners.push_back(p);
      substitute(p);
    }
  }

  // The corners that are not at the vertex of the previous one.
  std::vector<int> without_repetitions(int p) const
  {
    std::vector<int> outline;
    for(int c = m_soup.begin(p); c < m_soup.end(p); ++c)
      if(outline.empty() || vertex(c) != vertex(outline.back()))
        outline.push_back(c);
    while(outline.size() > 1 && vertex(outline.back()) == vertex(outline.front()))
      outline.pop_back();
    return outline;
  }

  bool is_disk(const std::vector<int>& outline)
  {
    std::vector<Point> corners;
    for(int c : outline)
      corners.push_back(m_points[vertex(c)]);
    const auto is_same_vertex = [&](int i, int j) { return vertex(outline[i]) == vertex(outline[j]); };
    const bool is_disk = !touching_triangulation(corners, is_same_vertex, m_go_further).empty();
    m_is_stopped = m_is_stopped || (int(outline.size()) > maximal_size_of_least && !m_go_further());
    return is_disk;
  }

  // Those with three corners or more, each of which has a vertex once. Every corner is in one of all.
  std::vector<std::vector<int> > loops(const std::vector<int>& outline) const
  {
    std::vector<std::vector<int> > result;
    std::vector<int> open;
    std::unordered_map<int, std::size_t> places; // in `open`, per vertex
    const auto close_loop = [&](std::size_t begin)
    {
      const std::vector<int> loop(open.begin() + std::ptrdiff_t(begin), open.end());
      for(int c : loop)
        places.erase(vertex(c));
      open.resize(begin);
      if(loop.size() >= 3)
        result.push_back(loop);
    };
    for(int c : outline)
    {
      if(const auto former = places.find(vertex(c)); former != places.end())
        close_loop(former->second);
      places[vertex(c)] = open.size();
      open.push_back(c);
    }
    close_loop(0);
    return result;
  }

  // Corners that are left out count as the previous one where that is at the same vertex or no corner in a part is.
  void substitute(int p)
  {
    std::unordered_map<int, int> kept; // per vertex
    int start = -1;
    for(int c = m_soup.begin(p); c < m_soup.end(p); ++c)
      if(m_substitutes[c] >= 0)
      {
        kept.emplace(vertex(c), c);
        start = start < 0 ? c : start;
      }
    for(int previous = start, c = m_soup.next(p, start); c != start; previous = std::exchange(c, m_soup.next(p, c)))
      if(m_substitutes[c] < 0)
      {
        const auto same = kept.find(vertex(c));
        m_substitutes[c] = vertex(c) == vertex(previous) || same == kept.end() ? m_substitutes[previous] : same->second;
      }
  }

  const std::vector<Point>& m_points;
  const Polygons& m_soup;
  const Go_further& m_go_further;
  Polygons m_polygons;
  std::vector<int> m_origins, m_corners, m_substitutes;
  std::vector<int> m_without_area, m_with_repeated_corners, m_divided;
  bool m_is_stopped = false;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_POLYGON_PARTS_H
