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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_SOUP_READER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_SOUP_READER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Corner_fans.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Polygon_parts.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Sheet_joiner.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Soup_surface.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Welded_vertices.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Welding.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/former_duplicates.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/is_welding_meant.h>

#include <array>
#include <cstddef>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/triangulate_polygons.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Reads a polygon soup as a surface. Nearly linear time on usual polygons, and the same result wherever it runs.
class Soup_reader
{
public:
  // Points that polygons use are finite, and indices in range.
  Soup_reader(const std::vector<Point>& points, const Polygons& soup, const Welding& welding, Execution execution,
              const Go_further& go_further)
    : m_points(points), m_execution(execution), m_go_further(go_further), m_representatives(representatives(soup, welding)),
      m_soup(renumbered(soup, m_representatives)), m_parts(points, m_soup, go_further), m_polygons(m_parts.polygons()),
      m_owners(m_polygons.owners()), m_former(former_duplicates(m_polygons, number_of_points(), execution)),
      m_is_used(m_polygons.ends.size(), 1)
  {
    for(std::size_t kind = 0; kind < m_findings.size(); ++kind)
      m_findings[kind].kind = Interpretation_kind(kind);
    for(int v = 0; v < number_of_points(); ++v)
      if(m_representatives[v] != v)
        add(Interpretation_kind::WELDED_VERTICES).vertices.push_back(std::size_t(v));
    add(Interpretation_kind::DEGENERATE_FACES, m_parts.without_area());
    add(Interpretation_kind::REPEATED_CORNERS, m_parts.with_repeated_corners());
    add(Interpretation_kind::DIVIDED_FACES, m_parts.divided());
    for(int p = 0; p < m_polygons.number(); ++p)
      if(m_former[p] >= 0)
      {
        m_is_used[p] = 0;
        add_polygon_of(p, Interpretation_kind::DUPLICATE_FACES);
      }
  }

  Soup_surface run()
  {
    if(m_parts.is_stopped())
      return stopped_surface();
    const Soup_edges edges(m_polygons, m_is_used, number_of_points(), m_execution);
    const Sheet_joiner joiner(m_points, m_polygons, m_is_used, edges);
    m_mates = joiner.mates();
    m_is_turned = joiner.is_turned();
    m_fans = fans_across(m_mates);
    execute_both(m_execution, [&] { describe(edges, joiner); }, [&] { number_fans(); });
    while(open_double_edges(edges) || (assemble(), open_doubled_polygons()))
    {
      m_fans = fans_across(m_mates);
      number_fans();
    }
    if(m_surface.is_stopped)
      return stopped_surface();
    place_corners();
    for(Interpretation& finding : m_findings)
      if(finding.count() > 0)
        m_surface.findings.push_back(std::move(finding));
    return std::move(m_surface);
  }

private:
  int number_of_points() const { return int(m_points.size()); }

  std::vector<int> representatives(const Polygons& soup, const Welding& welding)
  {
    m_surface.is_welded = welding.mode == Welding::ON
      || (welding.mode == Welding::AUTO && is_welding_meant(m_points, soup, welding, m_execution));
    if(m_surface.is_welded)
      return Welded_vertices(m_points, soup, welding.tolerance, welding.parts).representatives();
    std::vector<int> all(m_points.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }

  Interpretation& add(Interpretation_kind kind) { return m_findings[std::size_t(kind)]; }

  void add(Interpretation_kind kind, const std::vector<int>& polygons)
  { add(kind).polygons.assign(polygons.begin(), polygons.end()); }
  // Once, though several of its loops may be meant.
  void add_polygon_of(int part, Interpretation_kind kind)
  {
    std::vector<std::size_t>& polygons = add(kind).polygons;
    const std::size_t polygon = std::size_t(m_parts.origins()[part]);
    if(polygons.empty() || polygons.back() != polygon)
      polygons.push_back(polygon);
  }

  void describe(const Soup_edges& edges, const Sheet_joiner& joiner)
  {
    const auto ends = [&](int e)
    { return std::array<std::size_t, 2>{{std::size_t(edges.low(e)), std::size_t(edges.high(e))}}; };
    for(int e = 0; e < edges.number(); ++e)
      if(edges.size(e) > 2)
        add(Interpretation_kind::NON_MANIFOLD_EDGES).edges.push_back(ends(e));
    for(int e : joiner.non_orientable_edges())
      add(Interpretation_kind::NON_ORIENTABLE_EDGES).edges.push_back(ends(e));
    for(int p = 0; p < m_polygons.number(); ++p)
      if(m_is_turned[p])
        add_polygon_of(p, Interpretation_kind::REORIENTED_FACES);
    describe_vertices(edges);
  }

  void describe_vertices(const Soup_edges& edges)
  {
    const std::vector<int> fans = all_are_joined(edges) ? m_fans : fans_around(edges);
    std::vector<int> fan_of_vertex(m_points.size(), -1);
    std::vector<char> has_several(m_points.size(), 0);
    for_each_used_corner([&](int, int c)
    {
      const int v = m_polygons.vertices[c], fan = fans[c];
      has_several[v] = has_several[v] || (fan_of_vertex[v] >= 0 && fan_of_vertex[v] != fan);
      fan_of_vertex[v] = fan;
    });
    for(int v = 0; v < number_of_points(); ++v)
      if(has_several[v])
        add(Interpretation_kind::NON_MANIFOLD_VERTICES).vertices.push_back(std::size_t(v));
  }

  // Whether the sides of each edge are those that have become neighbors.
  bool all_are_joined(const Soup_edges& edges) const
  {
    for(int e = 0; e < edges.number(); ++e)
      if(edges.size(e) > 2 || (edges.size(e) == 2 && m_mates[edges.side(e, 0).corner] < 0))
        return false;
    return true;
  }

  // Per corner, one that stands for its fan, where all sides of an edge are neighbors.
  std::vector<int> fans_around(const Soup_edges& edges) const
  {
    Corner_fans fans(m_polygons, m_owners);
    for(int e = 0; e < edges.number(); ++e)
      for(int i = 1; i < edges.size(e); ++i)
        fans.unite(edges.side(e, 0).corner, edges.side(e, i).corner);
    return fans.representatives();
  }

  // The same where `mates` are neighbors.
  std::vector<int> fans_across(const std::vector<int>& mates) const
  {
    Corner_fans fans(m_polygons, m_owners);
    for(int side = 0; side < m_polygons.number_of_corners(); ++side)
      if(mates[side] >= 0 && mates[side] < side)
        fans.unite(mates[side], side);
    return fans.representatives();
  }

  template <typename Visit>
  void for_each_used_corner(Visit visit) const
  {
    for(int p = 0; p < m_polygons.number(); ++p)
      if(m_is_used[p])
        for(int c = m_polygons.begin(p); c < m_polygons.end(p); ++c)
          visit(p, c);
  }

  // Gives the corners of each fan a vertex of the surface. The first fan keeps the number of the vertex among those
  // that are not welded to another one, the others get numbers behind all of these.
  void number_fans()
  {
    std::vector<int> first_fans(m_points.size(), -1), vertices_of_fans(m_polygons.vertices.size(), -1);
    m_surface.origins.clear();
    std::vector<int> numbers(m_points.size(), -1);
    for(int v = 0; v < number_of_points(); ++v)
      if(m_representatives[v] == v)
      {
        numbers[v] = int(m_surface.origins.size());
        m_surface.origins.push_back(v);
      }
    m_vertices.assign(m_polygons.vertices.size(), -1);
    for_each_used_corner([&](int, int c)
    {
      const int v = m_polygons.vertices[c], fan = m_fans[c];
      if(first_fans[v] < 0)
      {
        first_fans[v] = fan;
        vertices_of_fans[fan] = numbers[v];
      }
      if(vertices_of_fans[fan] < 0)
      {
        vertices_of_fans[fan] = int(m_surface.origins.size());
        m_surface.origins.push_back(v);
      }
      m_vertices[c] = vertices_of_fans[fan];
    });
  }

  // Makes each polygon a piece of its own that belongs to an edge of the surface with the two vertices of
  // another one: what two such edges enclose may not have a map.
  bool open_double_edges(const Soup_edges& edges)
  {
    std::vector<int> opened;
    for(int e = 0; e < edges.number(); ++e)
    {
      if(edges.size(e) == 1 || (edges.size(e) == 2 && m_mates[edges.side(e, 0).corner] >= 0))
        continue;
      std::set<std::pair<int, int> > ends;
      for(int i = 0; i < edges.size(e); ++i)
      {
        const Soup_edges::Side& side = edges.side(e, i);
        const int c = side.corner, end = m_polygons.next(m_owners[c], c);
        if(m_mates[c] >= 0 && m_mates[c] < c)
          continue; // met already
        if(!ends.emplace(m_vertices[side.is_upward ? c : end], m_vertices[side.is_upward ? end : c]).second)
          opened.push_back(m_owners[c]);
      }
    }
    bool has_changed = false;
    for(int p : opened)
      has_changed = open(p) || has_changed;
    return has_changed;
  }

  // Makes all sides of a polygon border; false if they are.
  bool open(int polygon)
  {
    bool has_changed = false;
    for(int c = m_polygons.begin(polygon); c < m_polygons.end(polygon); ++c)
      if(const int mate = std::exchange(m_mates[c], -1); mate >= 0)
      {
        m_mates[mate] = -1;
        has_changed = true;
      }
    return has_changed;
  }

  void assemble()
  {
    m_surface.points.clear();
    m_surface.points.reserve(m_surface.origins.size());
    for(int v : m_surface.origins)
      m_surface.points.push_back(m_points[v]);
    m_surface.polygons = Polygons();
    m_surface.polygons.vertices.reserve(m_polygons.vertices.size());
    m_surface.polygons.ends.reserve(m_polygons.ends.size());
    m_parts_of_surface.clear();
    m_places.assign(m_polygons.vertices.size(), -1);
    for(int p = 0; p < m_polygons.number(); ++p)
    {
      if(!m_is_used[p])
        continue;
      int c = m_polygons.begin(p);
      for(int i = 0; i < m_polygons.size(p); ++i, c = m_is_turned[p] ? m_polygons.previous(p, c) : m_polygons.next(p, c))
      {
        m_places[c] = m_surface.polygons.number_of_corners();
        m_surface.polygons.vertices.push_back(m_vertices[c]);
      }
      m_surface.polygons.close();
      m_parts_of_surface.push_back(p);
    }
    m_surface.opposites.assign(m_surface.polygons.vertices.size(), -1);
    execute_blocks(m_execution, m_polygons.number_of_corners(), [&](int begin, int end)
    {
      for(int c = begin; c < end; ++c)
        if(m_mates[c] >= 0)
          m_surface.opposites[side_of_surface(c)] = side_of_surface(m_mates[c]);
    });
  }

  int side_of_surface(int side) const
  {
    const int p = m_owners[side];
    return m_places[m_is_turned[p] ? m_polygons.next(p, side) : side];
  }

  bool open_doubled_polygons()
  {
    if(m_surface.polygons.number_of_corners() == 3 * m_surface.polygons.number())
      return false;
    const Polygon_triangulation triangulation
      = triangulate_polygons(m_surface.points, m_surface.polygons, m_surface.opposites, m_go_further);
    m_surface.is_stopped = triangulation.is_stopped;
    if(m_surface.is_stopped)
      return false;
    bool has_changed = false;
    for(int p : triangulation.doubled)
      has_changed = open(m_parts_of_surface[p]) || has_changed;
    return has_changed;
  }

  // Duplicates have the UVs of the polygon that they repeat, corners without area those of the corners that they count as,
  // and polygons without area those of the surface at their vertices, if possible of a single polygon.
  void place_corners()
  {
    for(int p : m_parts_of_surface)
      m_surface.polygon_origins.push_back(m_parts.origins()[p]);
    m_surface.corners.assign(m_soup.vertices.size(), -1);
    m_surface.is_on_surface.assign(m_soup.vertices.size(), 0);
    m_surface.is_bound.assign(m_soup.vertices.size(), 0);
    for(int p = 0; p < m_polygons.number(); ++p)
    {
      if(m_former[p] >= 0)
        place_duplicate(p);
      for(int c = m_polygons.begin(p); c < m_polygons.end(p); ++c)
      {
        m_surface.corners[m_parts.corners()[c]] = m_places[c];
        m_surface.is_on_surface[m_parts.corners()[c]] = m_is_used[p];
      }
    }
    for(int c = 0; c < m_soup.number_of_corners(); ++c)
      if(const int other = m_parts.substitutes()[c]; other >= 0)
      {
        m_surface.corners[c] = m_surface.corners[other];
        m_surface.is_bound[c] = other == c || m_soup.vertices[other] == m_soup.vertices[c];
      }
    place_polygons_without_area();
  }

  void place_duplicate(int p)
  {
    const int former = m_former[p];
    int c = first_corner(m_polygons, p), d = first_corner(m_polygons, former);
    for(int i = 0; i < m_polygons.size(p); ++i, c = m_polygons.next(p, c), d = m_polygons.next(former, d))
      m_places[c] = m_places[d];
  }

  void place_polygons_without_area()
  {
    if(m_parts.without_area().empty())
      return;
    std::vector<int> first_corners(m_points.size(), -1); // at each vertex
    for_each_used_corner([&](int, int c)
    {
      if(first_corners[m_polygons.vertices[c]] < 0)
        first_corners[m_polygons.vertices[c]] = c;
    });
    for(int p : m_parts.without_area())
    {
      int place = -1;
      for(int c = m_soup.begin(p); c < m_soup.end(p) && place < 0; ++c)
        place = first_corners[m_soup.vertices[c]];
      for(int c = m_soup.begin(p); c < m_soup.end(p) && place >= 0; ++c)
        m_surface.corners[c] = m_places[nearest_corner(m_soup.vertices[c], place, first_corners)];
    }
  }

  // At this vertex in the polygon of the corner `place`, or in any polygon, or `place`.
  int nearest_corner(int v, int place, const std::vector<int>& first_corners) const
  {
    const int polygon = m_owners[place];
    for(int c = m_polygons.begin(polygon); c < m_polygons.end(polygon); ++c)
      if(m_polygons.vertices[c] == v)
        return c;
    return first_corners[v] >= 0 ? first_corners[v] : place;
  }

  Soup_surface m_surface;
  const std::vector<Point>& m_points;
  const Execution m_execution;
  const Go_further& m_go_further;
  const std::vector<int> m_representatives;
  const Polygons m_soup; // of the vertices that stand for others
  const Polygon_parts m_parts;
  const Polygons& m_polygons; // the parts
  const std::vector<int> m_owners, m_former;
  std::vector<char> m_is_used, m_is_turned;
  std::vector<int> m_mates, m_fans;      // per side; per corner, one that stands for its fan
  std::vector<int> m_vertices, m_places; // per corner, of the surface
  std::vector<int> m_parts_of_surface; // per polygon of the surface
  std::array<Interpretation, 9> m_findings;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_SOUP_READER_H
