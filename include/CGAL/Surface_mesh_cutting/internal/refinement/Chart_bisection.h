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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_BISECTION_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_BISECTION_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <CGAL/Surface_mesh_parameterization/internal/bijective/Border_overlaps.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Connected_parts.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using Surface_mesh_parameterization::internal::Connected_parts;

// A cheap path from border to border of a disk that separates two places where its flip-free map overlaps itself.
class Chart_bisection
{
  using Shortest_paths = CGAL::internal::Graph_kernel::Shortest_paths;

public:
  // `costs`: per edge; infinite where no path may pass. The references are kept.
  Chart_bisection(const Indexed_mesh& disk, const std::vector<double>& costs, const std::vector<Eigen::Vector2d>& uv)
    : m_disk(disk), m_costs(costs)
  {
    const Corner_table chart = make_chart(disk, Cut(disk.number_of_edges(), 0));
    const Surface_mesh_parameterization::internal::Border_overlaps overlaps(chart, Connected_parts(chart.opposites()), uv);
    m_is_needed = !overlaps.crossings().empty();
    if(m_is_needed)
      separate(overlaps.crossings(), chart.border_loops().front());
  }

  // Whether the map overlaps itself.
  bool is_needed() const { return m_is_needed; }
  // Empty if there is none.
  const std::vector<int>& path() const { return m_path; }

private:
  // Part of the border: vertices, and where each lies along the border.
  struct Arc
  {
    std::vector<int> vertices;
    std::vector<double> positions;

    double length() const { return positions.back() - positions.front(); }
  };

  // The border from the end of one halfedge to the start of another, given by their numbers along it.
  Arc arc_between(const std::vector<int>& border, int first, int last) const
  {
    Arc arc;
    double position = 0;
    const int n = int(border.size());
    for(int i = (first + 1) % n;; i = (i + 1) % n)
    {
      arc.vertices.push_back(m_disk.source(border[i]));
      arc.positions.push_back(position);
      if(i == last)
        return arc;
      position += m_disk.length(m_disk.edge(border[i]));
    }
  }

  // The pair is taken whose two arcs are most alike in length, so that a few steps separate all.
  void separate(const std::vector<std::pair<int, int> >& crossings, const std::vector<int>& border)
  {
    std::vector<double> positions(m_disk.number_of_halfedges(), 0);
    std::vector<int> numbers(m_disk.number_of_halfedges(), -1);
    double length = 0;
    for(int i = 0; i < int(border.size()); ++i)
    {
      numbers[border[i]] = i;
      positions[border[i]] = length;
      length += m_disk.length(m_disk.edge(border[i]));
    }
    const auto imbalance = [&](const std::pair<int, int>& pair)
    { return std::abs(2 * std::abs(positions[pair.first] - positions[pair.second]) - length); };
    const auto [g, h] = *std::min_element(crossings.begin(), crossings.end(), [&](const auto& a, const auto& b)
                                          { return imbalance(a) < imbalance(b); });
    const Arc there = arc_between(border, numbers[g], numbers[h]), back = arc_between(border, numbers[h], numbers[g]);
    find_path(middle(there), middle(back));
    if(m_path.empty())
      find_path(there.vertices, back.vertices);
  }

  // The vertices of the middle half, at least one: a path near a crossing would cut off little.
  static std::vector<int> middle(const Arc& arc)
  {
    std::vector<int> vertices;
    const double center = arc.length() / 2, reach = arc.length() / 4;
    std::size_t nearest = 0;
    for(std::size_t i = 0; i < arc.vertices.size(); ++i)
    {
      const double distance = std::abs(arc.positions[i] - center);
      if(distance <= reach)
        vertices.push_back(arc.vertices[i]);
      if(distance < std::abs(arc.positions[nearest] - center))
        nearest = i;
    }
    return vertices.empty() ? std::vector<int>(1, arc.vertices[nearest]) : vertices;
  }

  // The cheapest path through the interior.
  void find_path(const std::vector<int>& sources, const std::vector<int>& targets)
  {
    std::vector<char> is_closed = open_vertices(m_disk, Cut(m_disk.number_of_edges(), 0)), is_target(is_closed.size(), 0);
    for(int v : targets)
    {
      is_closed[v] = 0;
      is_target[v] = 1;
    }
    Shortest_paths paths(m_disk.graph());
    for(int v : sources)
      paths.add_source(v);
    int end = -1;
    paths.run([&](int v)
              {
                if(is_target[v])
                  end = v;
                return end < 0;
              },
              [&](int a)
              {
                const auto& arc = m_disk.graph().arcs[a];
                return m_disk.is_border_edge(arc.edge) || is_closed[arc.target] ? Shortest_paths::infinity()
                                                                                : m_costs[arc.edge];
              });
    if(end >= 0)
      paths.path(end, std::back_inserter(m_path));
  }

  const Indexed_mesh& m_disk;
  const std::vector<double>& m_costs;
  bool m_is_needed;
  std::vector<int> m_path; // edges
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CHART_BISECTION_H
