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

#include <CGAL/Surface_mesh_cutting/internal/context/work.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_mesh.h>

#include <CGAL/Surface_mesh_parameterization/internal/bijective/Border_overlaps.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>
#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using Surface_mesh_parameterization::internal::Connected_parts;

// A cheap path from border to border of a disk that separates places where its flip-free map overlaps itself.
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

  // Of the paths that separate some of the pairs, from the pair whose two arcs are most alike in length on, the one that
  // separates most pairs for its cost: a few steps separate all, along short paths.
  void separate(std::vector<std::pair<int, int> > crossings, const std::vector<int>& border)
  {
    std::vector<int> numbers(m_disk.number_of_halfedges(), -1); // along the border
    std::vector<double> positions(m_disk.number_of_vertices(), -1);
    double length = 0;
    for(int i = 0; i < int(border.size()); ++i)
    {
      numbers[border[i]] = i;
      positions[m_disk.source(border[i])] = length;
      length += m_disk.length(m_disk.edge(border[i]));
    }
    const auto position = [&](int h) { return positions[m_disk.source(h)]; };
    CGAL::internal::Graph_kernel::sort_by_key(crossings, [&](const std::pair<int, int>& pair)
    { return std::abs(2 * std::abs(position(pair.first) - position(pair.second)) - length); });
    const std::size_t number_of_paths = (std::min)(largest_number_of_paths(), crossings.size());
    double best_number = 0, best_cost = 0;
    for(std::size_t i = 0; i < number_of_paths; ++i)
    {
      const auto [g, h] = crossings[crossings.size() * i / number_of_paths];
      std::vector<int> path = path_between(arc_between(border, numbers[g], numbers[h]),
                                           arc_between(border, numbers[h], numbers[g]));
      if(path.empty())
        continue;
      const auto [first, last] = ends(path, positions);
      const auto is_between = [&, first = first, last = last](int b) { return first <= position(b) && position(b) < last; };
      const double number = double(std::count_if(crossings.begin(), crossings.end(), [&](const std::pair<int, int>& pair)
                                                 { return is_between(pair.first) != is_between(pair.second); }));
      double cost = 0;
      for(int e : path)
        cost += m_costs[e];
      const double gain = number * best_cost, best_gain = best_number * cost; // equal if nothing costs anything
      if(m_path.empty() || gain > best_gain || (gain == best_gain && number > best_number))
      {
        best_number = number;
        best_cost = cost;
        m_path = std::move(path);
      }
    }
  }

  // Each is a search in the whole part: few in large ones.
  std::size_t largest_number_of_paths() const
  {
    constexpr int most = 16;
    return std::clamp(affordable_steps(m_disk.number_of_faces()), 1, most);
  }

  // The two vertices of a path that lie on the border, by their positions there, the lower one first.
  std::pair<double, double> ends(const std::vector<int>& path, const std::vector<double>& positions) const
  {
    std::pair<double, double> result(std::numeric_limits<double>::infinity(), -1);
    for(int e : path)
      for(int h : {m_disk.halfedge(e), next_halfedge(m_disk.halfedge(e))})
        if(const double position = positions[m_disk.source(h)]; position >= 0)
          result = {(std::min)(result.first, position), (std::max)(result.second, position)};
    return result;
  }

  // From the middle of one arc to that of the other, if possible.
  std::vector<int> path_between(const Arc& there, const Arc& back) const
  {
    const std::vector<int> path = cheapest_path(middle(there), middle(back));
    return path.empty() ? cheapest_path(there.vertices, back.vertices) : path;
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

  // The cheapest path through the interior; empty if there is none.
  std::vector<int> cheapest_path(const std::vector<int>& sources, const std::vector<int>& targets) const
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
    std::vector<int> path;
    if(end >= 0)
      paths.path(end, std::back_inserter(path));
    return path;
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
