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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_CHART_REGIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_CHART_REGIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Collapsible_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Divides the vertices of a large chart into regions of neighbors, about equally large: boxes are halved across their
// longest side. What happens to the inner vertices of a region, all of whose triangles are in it, does not touch the
// others, so that threads work on regions at the same time. A small chart is not divided.
class Chart_regions
{
public:
  // Of the chart as far as it is not collapsed. `points`: of all its vertices.
  Chart_regions(const Collapsible_chart& chart, const std::vector<Eigen::Vector3d>& points, Execution execution)
  {
    // With what belongs to so many vertices, a core's own cache is not full. Of smaller regions, too many are at edges.
    constexpr int largest = 4096;
    std::vector<int> vertices = chart.vertices_in_use();
    if(int(vertices.size()) <= largest)
      return;
    m_starts = {0, int(vertices.size())};
    while(m_starts[1] > largest)
      halve(points, execution, vertices);
    keep_inner(chart, execution, vertices, int(points.size()));
  }

  int size() const { return int(m_inner.size()); }

  // The number of vertices of a region, and those of them that are inner ones, in ascending order.
  int number_of_vertices(int r) const { return m_starts[r + 1] - m_starts[r]; }
  const std::vector<int>& inner_vertices(int r) const { return m_inner[r]; }

private:
  // Ties by index: the same regions everywhere.
  void halve(const std::vector<Eigen::Vector3d>& points, Execution execution, std::vector<int>& vertices)
  {
    const int number = int(m_starts.size()) - 1;
    std::vector<int> starts(2 * number + 1);
    execute(execution, number, [&](int r)
    {
      const auto begin = vertices.begin() + m_starts[r], end = vertices.begin() + m_starts[r + 1];
      const auto middle = begin + (end - begin) / 2;
      Bounding_box<3> box;
      for(auto v = begin; v != end; ++v)
        box.add(points[*v]);
      int axis;
      box.size().maxCoeff(&axis);
      std::nth_element(begin, middle, end, [&](int v, int w)
                       { return points[v][axis] != points[w][axis] ? points[v][axis] < points[w][axis] : v < w; });
      starts[2 * r + 1] = int(middle - vertices.begin());
      starts[2 * r + 2] = m_starts[r + 1];
    });
    m_starts = std::move(starts);
  }

  void keep_inner(const Collapsible_chart& chart, Execution execution, const std::vector<int>& vertices,
                  int number_of_all_vertices)
  {
    const int number = int(m_starts.size()) - 1;
    std::vector<int> region(number_of_all_vertices, -1);
    for(int r = 0; r < number; ++r)
      for(int i = m_starts[r]; i < m_starts[r + 1]; ++i)
        region[vertices[i]] = r;
    std::vector<char> is_inner(number_of_all_vertices, 1);
    for(int f = 0; f < int(chart.triangles().size()); ++f)
    {
      const Triangle& t = chart.triangles()[f];
      if(!chart.is_dormant(f) && (region[t[0]] != region[t[1]] || region[t[0]] != region[t[2]]))
        for(int v : t)
          is_inner[v] = 0;
    }
    m_inner.resize(number);
    execute(execution, number, [&](int r)
    {
      for(int i = m_starts[r]; i < m_starts[r + 1]; ++i)
        if(is_inner[vertices[i]])
          m_inner[r].push_back(vertices[i]);
      std::sort(m_inner[r].begin(), m_inner[r].end());
    });
  }

  std::vector<int> m_starts{0};
  std::vector<std::vector<int> > m_inner;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_CHART_REGIONS_H
