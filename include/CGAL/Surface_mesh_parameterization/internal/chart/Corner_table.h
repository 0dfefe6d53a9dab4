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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_CORNER_TABLE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_CORNER_TABLE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>
#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

using CGAL::internal::Graph_kernel::Buckets;
using CGAL::internal::Graph_kernel::Disjoint_sets;
using Triangle = std::array<int, 3>;

// Halfedges are numbered by the corner they start from: halfedge 3t+k of triangle t leads from corner k to corner k+1.
inline int next_halfedge(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline int previous_halfedge(int h) { return h % 3 == 0 ? h + 2 : h - 1; }

// A piece of surface that was cut open: triangles over chart vertices, and for each halfedge the
// one across the edge, or -1 on the chart's border. The corners of a chart vertex always form one
// fan; where a cut separates the corners of a surface vertex, it has several chart vertices.
class Corner_table
{
public:
  Corner_table() = default;

  // `open()` keeps all of this up to date. `opposites` has three entries per triangle.
  Corner_table(std::vector<Triangle> triangles, std::vector<int> opposites, int number_of_vertices)
    : m_triangles(std::move(triangles)), m_opposites(std::move(opposites)), m_origins(number_of_vertices)
  {
    for(int v = 0; v < number_of_vertices; ++v)
      m_origins[v] = v;
  }

  int number_of_vertices() const { return int(m_origins.size()); }
  int number_of_triangles() const { return int(m_triangles.size()); }
  const std::vector<Triangle>& triangles() const { return m_triangles; }
  const std::vector<int>& opposites() const { return m_opposites; }
  // The surface vertex that a chart vertex is a copy of.
  const std::vector<int>& origins() const { return m_origins; }

  int source(int h) const { return m_triangles[h / 3][h % 3]; }
  int target(int h) const { return source(next_halfedge(h)); }
  int opposite(int h) const { return m_opposites[h]; }
  bool is_border(int h) const { return m_opposites[h] < 0; }

  // The halfedge that leaves the source of `h` next in counterclockwise order, -1 past the border.
  int next_around_source(int h) const { return m_opposites[previous_halfedge(h)]; }
  // The same in clockwise order.
  int previous_around_source(int h) const
  {
    const int o = m_opposites[h];
    return o < 0 ? -1 : next_halfedge(o);
  }

  // The border halfedge that follows the border halfedge `h` along its loop, the surface on the left. O(valence).
  int next_on_border(int h) const
  {
    h = next_halfedge(h);
    while(!is_border(h))
      h = next_halfedge(m_opposites[h]);
    return h;
  }

  // All halfedges that leave the source of `h`: counterclockwise, and from `h` on if it is on the border.
  std::vector<int> ring(int h) const
  {
    constexpr std::size_t usual_valence = 8; // seldom more
    std::vector<int> corners;
    corners.reserve(usual_valence);
    corners.push_back(h);
    int c = next_around_source(h);
    for(; c >= 0 && c != h; c = next_around_source(c))
      corners.push_back(c);
    if(c < 0)
      for(c = previous_around_source(h); c >= 0; c = previous_around_source(c))
        corners.push_back(c);
    return corners;
  }

  // One entry per loop: its border halfedges in order; loops sorted by their lowest halfedge. O(n).
  std::vector<std::vector<int> > border_loops() const
  {
    std::vector<std::vector<int> > loops;
    std::vector<char> is_visited(m_opposites.size(), 0);
    for(int h = 0; h < int(m_opposites.size()); ++h)
    {
      if(!is_border(h) || is_visited[h])
        continue;
      loops.emplace_back();
      for(int b = h; !is_visited[b]; b = next_on_border(b))
      {
        is_visited[b] = 1;
        loops.back().push_back(b);
      }
    }
    return loops;
  }

  // vertices - edges + triangles: 1 for a disk. Unused vertices are not counted. O(n).
  int euler_characteristic() const
  {
    std::vector<char> is_used(m_origins.size(), 0);
    int vertices = 0, border = 0;
    for(int h = 0; h < int(m_opposites.size()); ++h)
    {
      border += is_border(h);
      if(!std::exchange(is_used[source(h)], char(1)))
        ++vertices;
    }
    const int halfedges = int(m_opposites.size());
    return vertices - (halfedges + border) / 2 + number_of_triangles();
  }

  // One part of several: all triangles that are connected to the given ones are among these. O(n).
  Corner_table part(const std::vector<int>& triangles) const
  {
    Corner_table result;
    std::vector<int> new_vertex(m_origins.size(), -1), new_triangle(m_triangles.size(), -1);
    for(std::size_t i = 0; i < triangles.size(); ++i)
      new_triangle[triangles[i]] = int(i);
    for(int t : triangles)
    {
      result.m_triangles.push_back(m_triangles[t]);
      for(int& v : result.m_triangles.back())
      {
        if(new_vertex[v] < 0)
        {
          new_vertex[v] = result.number_of_vertices();
          result.m_origins.push_back(m_origins[v]);
        }
        v = new_vertex[v];
      }
      for(int h = 3 * t; h < 3 * t + 3; ++h)
        result.m_opposites.push_back(is_border(h) ? -1 : 3 * new_triangle[opposite(h) / 3] + opposite(h) % 3);
    }
    return result;
  }

  // Records the changes of `open()`, so that `close()` can take them back.
  struct Opening
  {
    std::vector<std::pair<int, int> > opposites; // halfedge, former opposite
    std::vector<std::pair<int, int> > corners;   // halfedge, former source
    int number_of_vertices = 0;                  // before
  };

  // Opens the given edges (one halfedge each; border edges are passed over): their two sides become
  // border, and each vertex whose corners fall apart is split; the first fan keeps the vertex, the
  // others get new ones at the end. O(length of the path + its one-rings).
  Opening open(const std::vector<int>& halfedges)
  {
    Opening opening;
    opening.number_of_vertices = number_of_vertices();
    std::vector<std::vector<int> > rings;
    for(int h : halfedges)
      for(int c : {h, next_halfedge(h)})
        rings.push_back(ring(c));
    for(int h : halfedges)
    {
      const int o = m_opposites[h];
      if(o < 0)
        continue;
      opening.opposites.emplace_back(h, o);
      opening.opposites.emplace_back(o, h);
      m_opposites[h] = m_opposites[o] = -1;
    }
    for(const std::vector<int>& corners : rings)
      split(corners, opening);
    return opening;
  }

  // Takes the latest opening back; openings are closed in the reverse order of their making.
  void close(const Opening& opening)
  {
    for(auto it = opening.opposites.rbegin(); it != opening.opposites.rend(); ++it)
      m_opposites[it->first] = it->second;
    for(auto it = opening.corners.rbegin(); it != opening.corners.rend(); ++it)
      corner(it->first) = it->second;
    m_origins.resize(opening.number_of_vertices);
  }

private:
  // Gives each fan that the corners of one former vertex form now a vertex of its own.
  void split(const std::vector<int>& corners, Opening& opening)
  {
    const int v = source(corners.front());
    const std::vector<int> kept = ring(corners.front());
    if(kept.size() == corners.size())
      return;
    for(int c : kept)
      corner(c) = -1; // passed over below
    for(int c : corners)
    {
      if(source(c) != v)
        continue; // of a fan already split off
      const int copy = number_of_vertices();
      m_origins.push_back(m_origins[v]);
      for(int f : ring(c))
      {
        opening.corners.emplace_back(f, v);
        corner(f) = copy;
      }
    }
    for(int c : kept)
      corner(c) = v;
  }

  int& corner(int h) { return m_triangles[h / 3][h % 3]; }

  std::vector<Triangle> m_triangles;
  std::vector<int> m_opposites;
  std::vector<int> m_origins;
};

// The corners, 3t+k, at each vertex. O(n).
inline Buckets<int> corners_at_vertices(const std::vector<Triangle>& triangles, int number_of_vertices)
{
  return {number_of_vertices, [&](const auto& visit)
          {
            for(int c = 0; c < 3 * int(triangles.size()); ++c)
              visit(triangles[c / 3][c % 3], c);
          }};
}

// The place of the source of each halfedge, which remains when a chart is cut otherwise.
inline std::vector<Eigen::Vector2d> corner_uvs(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv)
{
  std::vector<Eigen::Vector2d> corners;
  corners.reserve(chart.opposites().size());
  for(int h = 0; h < int(chart.opposites().size()); ++h)
    corners.push_back(uv[chart.source(h)]);
  return corners;
}

// The UVs of the vertices; another check says whether corners disagree.
inline std::vector<Eigen::Vector2d> vertex_uvs(const Corner_table& chart, const std::vector<Eigen::Vector2d>& corners)
{
  std::vector<Eigen::Vector2d> uv(chart.number_of_vertices(), Eigen::Vector2d::Zero());
  for(int h = 0; h < int(corners.size()); ++h)
    uv[chart.source(h)] = corners[h];
  return uv;
}

// The parts of a chart that edges connect which are not open; `part[t]` is the number of the part
// that the triangle `t` belongs to. Parts are numbered in the order of their lowest triangles.
struct Connected_parts
{
  std::vector<int> part;
  int number = 0;

  // `opposites` as in `Corner_table`. Nearly linear time.
  explicit Connected_parts(const std::vector<int>& opposites)
    : Connected_parts(opposites, [](int) { return false; })
  {}

  // The same without some triangles, which belong to part -1.
  template <typename IsExcluded>
  Connected_parts(const std::vector<int>& opposites, IsExcluded is_excluded)
    : part(opposites.size() / 3, -1)
  {
    Disjoint_sets sets(int(part.size()));
    for(int h = 0; h < int(opposites.size()); ++h)
      if(const int o = opposites[h]; o >= 0 && o < h && !is_excluded(h / 3) && !is_excluded(o / 3))
        sets.unite(h / 3, o / 3);
    for(int t = 0; t < int(part.size()); ++t)
      if(!is_excluded(t))
      {
        const int lowest = sets.find(t);
        part[t] = lowest == t ? number++ : part[lowest];
      }
  }
};

// The part that each vertex belongs to; -1 for vertices of no triangle. No vertex is in two parts of a chart. O(n).
inline std::vector<int> parts_of_vertices(const Corner_table& chart, const Connected_parts& parts)
{
  std::vector<int> result(chart.number_of_vertices(), -1);
  for(int h = 0; h < int(chart.opposites().size()); ++h)
    result[chart.source(h)] = parts.part[h / 3];
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_CORNER_TABLE_H
