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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_COLLAPSIBLE_CHART_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_COLLAPSIBLE_CHART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Half-edge collapses in their order, with all that it takes to undo them.
struct Collapse_log
{
  struct Collapse
  {
    int vertex, first_corner, first_halfedge;
    int triangles[2]; // that went, or -1
  };

  int size() const { return int(collapses.size()); }

  std::vector<Collapse> collapses;
  std::vector<int> moved_corners;
  std::vector<std::pair<int, int> > former_halfedges; // of vertices
};

// The connectivity of a chart under half-edge collapses that can be undone in the reverse order.
// Triangles and vertices keep their numbers; collapsed ones are dormant. Collapses of vertices whose neighbors are
// all in one region touch nothing else, so that regions may be worked on at the same time, each with a log of its own.
class Collapsible_chart
{
public:
  explicit Collapsible_chart(const Corner_table& chart)
    : m_triangles(chart.triangles()), m_opposites(chart.opposites()),
      m_is_dormant(m_triangles.size(), 0), m_halfedges(chart.number_of_vertices(), -1)
  {
    for(int h = 0; h < int(m_opposites.size()); ++h)
    {
      int& first = m_halfedges[source(h)];
      if(first < 0 || m_opposites[h] < 0)
        first = h;
    }
  }

  int source(int h) const { return m_triangles[h / 3][h % 3]; }
  int target(int h) const { return source(next_halfedge(h)); }
  bool is_used(int v) const { return m_halfedges[v] >= 0; }
  bool is_on_border(int v) const { return m_opposites[m_halfedges[v]] < 0; }
  bool is_dormant(int t) const { return m_is_dormant[t] != 0; }
  const std::vector<Triangle>& triangles() const { return m_triangles; }
  const std::vector<int>& opposites() const { return m_opposites; }

  // The vertices of triangles that are not dormant, in ascending order.
  std::vector<int> vertices_in_use() const
  {
    std::vector<char> is_in_use(m_halfedges.size(), 0);
    for(int t = 0; t < int(m_triangles.size()); ++t)
      if(!is_dormant(t))
        for(int v : m_triangles[t])
          is_in_use[v] = 1;
    std::vector<int> vertices;
    for(int v = 0; v < int(is_in_use.size()); ++v)
      if(is_in_use[v])
        vertices.push_back(v);
    return vertices;
  }

  // The halfedges that leave `v`, counterclockwise, a border vertex's border halfedge first.
  void fan(int v, std::vector<int>& halfedges) const
  {
    halfedges.clear();
    const int first = m_halfedges[v];
    int h = first;
    do
    {
      halfedges.push_back(h);
      h = m_opposites[previous_halfedge(h)];
    }
    while(h >= 0 && h != first);
  }

  // The neighbors of `v` counterclockwise, from its fan; a border vertex has one more neighbor than halfedges.
  void ring(int v, const std::vector<int>& fan, std::vector<int>& neighbors) const
  {
    neighbors.clear();
    for(int h : fan)
      neighbors.push_back(target(h));
    if(is_on_border(v))
      neighbors.push_back(source(previous_halfedge(fan.back())));
  }

  // More neighbors than vertices of usual surfaces have. To judge collapses of such a vertex or into it would take time that is
  // quadratic in their number, so there are none.
  static constexpr int many_neighbors = 1000;

  // Whether merging `v` into its neighbor ring[j] leaves a chart of the same topology: a border
  // vertex moves along the border only, and the two have no common neighbors but those across their
  // edge (link condition). False where the neighbor has many neighbors itself.
  bool can_collapse(int v, const std::vector<int>& fan, const std::vector<int>& ring, int j) const
  {
    const bool is_border = is_on_border(v);
    const int last = int(ring.size()) - 1;
    if(is_border && j != 0 && j != last)
      return false;
    if(is_border && fan.size() == 1 && m_opposites[next_halfedge(fan[0])] < 0)
      return false; // the last triangle
    if(!is_border && ring.size() < 3)
      return false;
    const int before_j = j > 0 ? j - 1 : is_border ? -1 : last;
    const int after_j = j < last ? j + 1 : is_border ? -1 : 0;
    const auto is_common = [&](int w)
    {
      for(int i = 0; i <= last; ++i)
        if(ring[i] == w && i != before_j && i != after_j)
          return true;
      return false;
    };
    const int u = ring[j], first = m_halfedges[u];
    int h = first, number = 0;
    do
    {
      if(is_common(target(h)) || ++number > many_neighbors)
        return false;
      const int before = previous_halfedge(h);
      if(m_opposites[before] < 0)
        return !is_common(source(before));
      h = m_opposites[before];
    }
    while(h != first);
    return true;
  }

  // Merges `v` into ring[j]; `can_collapse()` must hold.
  void collapse(int v, const std::vector<int>& fan, const std::vector<int>& ring, int j, Collapse_log& log)
  {
    const int u = ring[j];
    Collapse record{v, int(log.moved_corners.size()), int(log.former_halfedges.size()), {-1, -1}};
    const int size = int(fan.size());
    const bool is_border = is_on_border(v);
    // Triangles j-1 and j of the fan hold the edge from v to u.
    int removed = 0;
    if(!is_border || j < size)
      record.triangles[removed++] = fan[j] / 3;
    if(!is_border || j > 0)
      record.triangles[removed++] = fan[(j + size - 1) % size] / 3;
    for(int w : ring)
      log.former_halfedges.emplace_back(w, m_halfedges[w]);
    for(int h : fan)
      if(h / 3 != record.triangles[0] && h / 3 != record.triangles[1])
      {
        log.moved_corners.push_back(h);
        m_triangles[h / 3][h % 3] = u;
      }
    for(int t : record.triangles)
      if(t >= 0)
        remove(t, v, u);
    for(int w : ring)
      update_halfedge(w, fan, record);
    log.collapses.push_back(record);
  }

  // Undoes the latest collapse of a log and returns its vertex.
  int undo(Collapse_log& log)
  {
    const Collapse record = log.collapses.back();
    log.collapses.pop_back();
    for(int t : {record.triangles[1], record.triangles[0]})
      if(t >= 0)
      {
        m_is_dormant[t] = 0;
        for(int k = 0; k < 3; ++k)
          if(m_opposites[3 * t + k] >= 0)
            m_opposites[m_opposites[3 * t + k]] = 3 * t + k;
      }
    for(std::size_t i = record.first_corner; i < log.moved_corners.size(); ++i)
      m_triangles[log.moved_corners[i] / 3][log.moved_corners[i] % 3] = record.vertex;
    log.moved_corners.resize(record.first_corner);
    for(std::size_t i = record.first_halfedge; i < log.former_halfedges.size(); ++i)
      m_halfedges[log.former_halfedges[i].first] = log.former_halfedges[i].second;
    log.former_halfedges.resize(record.first_halfedge);
    return record.vertex;
  }

private:
  using Collapse = Collapse_log::Collapse;

  // Takes out triangle t, which holds the collapsing edge, and joins what lies across its two other
  // edges. Its own entries stay as they are: undo() reads them.
  void remove(int t, int v, int u)
  {
    m_is_dormant[t] = 1;
    int outer[2], count = 0;
    for(int k = 0; k < 3; ++k)
    {
      const int s = m_triangles[t][k], e = m_triangles[t][(k + 1) % 3];
      if(!((s == v && e == u) || (s == u && e == v)))
        outer[count++] = m_opposites[3 * t + k];
    }
    for(int i = 0; i < 2; ++i)
      if(outer[i] >= 0)
        m_opposites[outer[i]] = outer[1 - i];
  }

  // Finds a halfedge that leaves `w` again, the border one if there is one, should its former one have been taken out.
  // The collapse touched only `fan` and what lay across the removed triangles.
  void update_halfedge(int w, const std::vector<int>& fan, const Collapse& record)
  {
    const int former = m_halfedges[w];
    if(!m_is_dormant[former / 3])
      return;
    int h = left_halfedge(w, fan, record);
    if(m_opposites[former] < 0) // the entries of what has been taken out are kept
      while(m_opposites[h] >= 0)
        h = next_halfedge(m_opposites[h]);
    m_halfedges[w] = h;
  }

  // Any that leaves `w` and has not been taken out.
  int left_halfedge(int w, const std::vector<int>& fan, const Collapse& record) const
  {
    for(int c : fan)
      for(int k = 0; k < 3; ++k)
        if(!m_is_dormant[c / 3] && source(3 * (c / 3) + k) == w)
          return 3 * (c / 3) + k;
    for(int t : record.triangles)
      for(int k = 0; t >= 0 && k < 3; ++k)
      {
        const int o = m_opposites[3 * t + k];
        if(o >= 0 && !m_is_dormant[o / 3] && (source(o) == w || target(o) == w))
          return source(o) == w ? o : next_halfedge(o);
      }
    return -1;
  }

  std::vector<Triangle> m_triangles;
  std::vector<int> m_opposites;
  std::vector<char> m_is_dormant;
  std::vector<int> m_halfedges; // per vertex, one that leaves it; on the border the border one
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_COLLAPSIBLE_CHART_H
