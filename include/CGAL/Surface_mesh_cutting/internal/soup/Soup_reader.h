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
#include <CGAL/Surface_mesh_cutting/internal/soup/Sheet_joiner.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Soup_surface.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/left_out_polygons.h>

#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#ifndef CGAL_SURFACE_MESH_CUTTING_USE_LIBRARY
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/triangulate_polygons.h>
#endif

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Reads a polygon soup as a surface. Nearly linear time, and the same result wherever it runs.
class Soup_reader
{
  using Disjoint_sets = CGAL::internal::Graph_kernel::Disjoint_sets;

public:
  // Points are finite and indices in range. `do_weld`: whether vertices at exactly the same point are one.
  Soup_reader(const std::vector<Point>& points, const Polygons& soup, bool do_weld, Execution execution)
    : m_points(points), m_soup(soup), m_execution(execution), m_welded(soup), m_representatives(points.size()),
      m_owners(soup.owners())
  {
    weld(do_weld);
    const std::vector<char> is_simple = m_welded.are_simple(number_of_points());
    m_former = former_duplicates(m_welded, is_simple, number_of_points(), m_execution);
    m_is_used = is_simple;
    for(int p = 0; p < m_welded.number(); ++p)
    {
      if(!is_simple[p])
        add(Interpretation_kind::DEGENERATE_FACES).polygons.push_back(std::size_t(p));
      if(m_former[p] >= 0)
      {
        m_is_used[p] = 0;
        add(Interpretation_kind::DUPLICATE_FACES).polygons.push_back(std::size_t(p));
      }
    }
  }

  Soup_surface run()
  {
    const Soup_edges edges(m_welded, m_is_used, number_of_points(), m_execution);
    const Sheet_joiner joiner(m_points, m_welded, m_is_used, edges);
    m_mates = joiner.mates();
    m_is_turned = joiner.is_turned();
    m_fans = fans_across(m_mates);
    execute_both(m_execution, [&] { describe(edges, joiner); }, [&] { number_fans(); });
    while(open_double_edges(edges) || (assemble(), open_doubled_polygons()))
    {
      m_fans = fans_across(m_mates);
      number_fans();
    }
    place_left_out_polygons();
    for(Interpretation& finding : m_findings)
      if(finding.count() > 0)
        m_surface.findings.push_back(std::move(finding));
    return std::move(m_surface);
  }

private:
  int number_of_points() const { return int(m_points.size()); }

  Interpretation& add(Interpretation_kind kind) { return m_findings[std::size_t(kind)]; }

  void weld(bool do_weld)
  {
    for(int v = 0; v < number_of_points(); ++v)
      m_representatives[v] = v;
    for(std::size_t kind = 0; kind < m_findings.size(); ++kind)
      m_findings[kind].kind = Interpretation_kind(kind);
    if(!do_weld)
      return;
    m_representatives = first_vertices_at_points(m_points, m_soup);
    for(int v = 0; v < number_of_points(); ++v)
      if(m_representatives[v] != v)
        add(Interpretation_kind::WELDED_VERTICES).vertices.push_back(std::size_t(v));
    for(int& v : m_welded.vertices)
      v = m_representatives[v];
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
    for(int p = 0; p < m_welded.number(); ++p)
      if(m_is_turned[p])
        add(Interpretation_kind::REORIENTED_FACES).polygons.push_back(std::size_t(p));
    describe_vertices(edges);
  }

  void describe_vertices(const Soup_edges& edges)
  {
    const std::vector<int> fans = all_are_joined(edges) ? m_fans : fans_around(edges);
    std::vector<int> fan_of_vertex(m_points.size(), -1);
    std::vector<char> has_several(m_points.size(), 0);
    for_each_used_corner([&](int, int c)
    {
      const int v = m_welded.vertices[c], fan = fans[c];
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
    Disjoint_sets fans(m_welded.number_of_corners());
    for(int e = 0; e < edges.number(); ++e)
      for(int i = 1; i < edges.size(e); ++i)
        unite_ends(edges.side(e, 0).corner, edges.side(e, i).corner, fans);
    return representatives(fans);
  }

  // The same where `mates` are neighbors.
  std::vector<int> fans_across(const std::vector<int>& mates) const
  {
    Disjoint_sets fans(m_welded.number_of_corners());
    for(int side = 0; side < m_welded.number_of_corners(); ++side)
      if(mates[side] >= 0 && mates[side] < side)
        unite_ends(mates[side], side, fans);
    return representatives(fans);
  }

  std::vector<int> representatives(Disjoint_sets& sets) const
  {
    std::vector<int> result(m_welded.vertices.size());
    for(int c = 0; c < m_welded.number_of_corners(); ++c)
      result[c] = sets.find(c);
    return result;
  }

  template <typename Visit>
  void for_each_used_corner(Visit visit) const
  {
    for(int p = 0; p < m_welded.number(); ++p)
      if(m_is_used[p])
        for(int c = m_welded.begin(p); c < m_welded.end(p); ++c)
          visit(p, c);
  }

  // Unites the corners of two sides at the same vertices.
  void unite_ends(int a, int b, Disjoint_sets& sets) const
  {
    const int a_end = m_welded.next(m_owners[a], a), b_end = m_welded.next(m_owners[b], b);
    const bool is_same_direction = m_welded.vertices[a] == m_welded.vertices[b];
    sets.unite(a, is_same_direction ? b : b_end);
    sets.unite(a_end, is_same_direction ? b_end : b);
  }

  // Gives the corners of each fan a vertex of the surface. The first fan keeps the number of the vertex among those
  // that are not welded to another one, the others get numbers behind all of these.
  void number_fans()
  {
    std::vector<int> first_fans(m_points.size(), -1), vertices_of_fans(m_welded.vertices.size(), -1);
    m_surface.origins.clear();
    std::vector<int> numbers(m_points.size(), -1);
    for(int v = 0; v < number_of_points(); ++v)
      if(m_representatives[v] == v)
      {
        numbers[v] = int(m_surface.origins.size());
        m_surface.origins.push_back(v);
      }
    m_vertices.assign(m_welded.vertices.size(), -1);
    for_each_used_corner([&](int, int c)
    {
      const int v = m_welded.vertices[c], fan = m_fans[c];
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
        const int c = side.corner, end = m_welded.next(m_owners[c], c);
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
    for(int c = m_welded.begin(polygon); c < m_welded.end(polygon); ++c)
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
    m_surface.polygons.vertices.reserve(m_welded.vertices.size());
    m_surface.polygons.ends.reserve(m_welded.ends.size());
    m_surface.polygon_origins.clear();
    m_surface.polygon_origins.reserve(m_welded.ends.size());
    m_surface.corners.assign(m_soup.vertices.size(), -1);
    m_surface.is_on_surface.assign(m_soup.vertices.size(), 0);
    for(int p = 0; p < m_welded.number(); ++p)
    {
      if(!m_is_used[p])
        continue;
      int c = m_welded.begin(p);
      for(int i = 0; i < m_welded.size(p); ++i, c = m_is_turned[p] ? m_welded.previous(p, c) : m_welded.next(p, c))
      {
        m_surface.corners[c] = m_surface.polygons.number_of_corners();
        m_surface.is_on_surface[c] = 1;
        m_surface.polygons.vertices.push_back(m_vertices[c]);
      }
      m_surface.polygons.close();
      m_surface.polygon_origins.push_back(p);
    }
    m_surface.opposites.assign(m_surface.polygons.vertices.size(), -1);
    execute_blocks(m_execution, m_welded.number_of_corners(), [&](int begin, int end)
    {
      for(int c = begin; c < end; ++c)
        if(m_mates[c] >= 0)
          m_surface.opposites[side_of_surface(c)] = side_of_surface(m_mates[c]);
    });
  }

  int side_of_surface(int side) const
  {
    const int p = m_owners[side];
    return m_surface.corners[m_is_turned[p] ? m_welded.next(p, side) : side];
  }

  bool open_doubled_polygons()
  {
    if(m_surface.polygons.number_of_corners() == 3 * m_surface.polygons.number())
      return false;
    bool has_changed = false;
    for(int p : triangulate_polygons(m_surface.points, m_surface.polygons, m_surface.opposites).doubled)
      has_changed = open(m_surface.polygon_origins[p]) || has_changed;
    return has_changed;
  }

  // Duplicates have the UVs of the polygon that they repeat, degenerate polygons those of the surface at their
  // vertices, if possible of a single polygon.
  void place_left_out_polygons()
  {
    if(int(m_surface.polygon_origins.size()) == m_welded.number())
      return;
    std::vector<int> first_corners(m_points.size(), -1); // at each vertex
    for_each_used_corner([&](int, int c)
    {
      if(first_corners[m_welded.vertices[c]] < 0)
        first_corners[m_welded.vertices[c]] = c;
    });
    for(int p = 0; p < m_welded.number(); ++p)
    {
      if(m_is_used[p])
        continue;
      int place = -1; // a corner of the soup on the surface
      for(int c = m_welded.begin(p); c < m_welded.end(p) && place < 0; ++c)
        place = m_former[p] >= 0 ? m_welded.begin(m_former[p]) : first_corners[m_welded.vertices[c]];
      for(int c = m_welded.begin(p); c < m_welded.end(p) && place >= 0; ++c)
        m_surface.corners[c] = m_surface.corners[nearest_corner(m_welded.vertices[c], place, first_corners)];
    }
  }

  // At this vertex in the polygon of the corner `place`, or in any polygon, or `place`.
  int nearest_corner(int v, int place, const std::vector<int>& first_corners) const
  {
    const int polygon = m_owners[place];
    for(int c = m_welded.begin(polygon); c < m_welded.end(polygon); ++c)
      if(m_welded.vertices[c] == v)
        return c;
    return first_corners[v] >= 0 ? first_corners[v] : place;
  }

  const std::vector<Point>& m_points;
  const Polygons& m_soup;
  const Execution m_execution;
  Polygons m_welded; // the soup, of the vertices that stand for others
  std::vector<int> m_representatives;
  const std::vector<int> m_owners;
  std::vector<int> m_former;
  std::vector<char> m_is_used;
  std::vector<int> m_mates; // per side of the soup
  std::vector<int> m_fans;  // per corner of the soup, one that stands for its fan
  std::vector<char> m_is_turned;
  std::vector<int> m_vertices; // per corner of the soup, of the surface
  std::array<Interpretation, 7> m_findings;
  Soup_surface m_surface;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_SOUP_READER_H
