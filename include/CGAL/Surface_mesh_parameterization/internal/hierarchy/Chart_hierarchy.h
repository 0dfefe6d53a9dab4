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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_CHART_HIERARCHY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_CHART_HIERARCHY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Chart_simplification.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Flip_collapse.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/star_placement.h>

#include <Eigen/Core>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// A chart at all resolutions between a few triangles and its own: half-edge collapses (border only
// along the border), undone one after the other with the vertex placed inside the kernel of its
// star [SJZP19]. A flip-free map of a coarse stage thus becomes a flip-free map of the whole chart.
class Chart_hierarchy
{
public:
  // `points`: the position of each chart vertex on the surface. With `keeps_region`, the image of
  // each stage lies inside that of the coarser one, so that refining an injective map keeps it so.
  Chart_hierarchy(const Corner_table& chart, const std::vector<Eigen::Vector3d>& points,
                  bool keeps_region = false)
    : m_chart(chart), m_points(points), m_keeps_region(keeps_region),
      m_minimal_edge(minimal_edge(chart.triangles(), points))
  {}

  // Collapses down to about `size` vertices; those with `is_kept` (empty: none) stay. Returns the number of vertices
  // that are left.
  int coarsen(int size, const std::vector<char>& is_kept = {})
  {
    Chart_simplification simplification(m_chart, m_points, m_keeps_region);
    simplification.reduce_to(size, is_kept);
    m_number_of_vertices = simplification.number_of_vertices();
    return m_number_of_vertices;
  }

  // Collapses what is flipped under `uv` (over the vertices of the whole chart) instead. False if
  // flips remain.
  bool collapse_flips(const std::vector<Eigen::Vector2d>& uv)
  {
    const bool is_flip_free = Flip_collapse(m_chart, uv)();
    m_number_of_vertices = int(m_points.size()) - m_chart.number_of_collapses();
    return is_flip_free;
  }

  bool is_complete() const { return m_chart.number_of_collapses() == 0; }
  int number_of_vertices() const { return m_number_of_vertices; }

  // The current stage as a chart of its own.
  struct Stage
  {
    Corner_table chart;
    std::vector<int> vertices;       // of the whole chart, per vertex of the stage
    std::vector<Eigen::Vector3d> points;
    std::vector<Rest_shape> shapes;
  };

  Stage stage() const
  {
    Stage s;
    std::vector<int> compact(m_points.size(), -1), numbers(m_chart.triangles().size(), -1);
    std::vector<Triangle> triangles;
    std::vector<int> origin;
    for(int t = 0; t < int(numbers.size()); ++t)
    {
      if(m_chart.is_dormant(t))
        continue;
      numbers[t] = int(triangles.size());
      Triangle corners = m_chart.triangles()[t];
      s.shapes.push_back(shape(3 * t));
      for(int& v : corners)
      {
        if(compact[v] < 0)
        {
          compact[v] = int(s.vertices.size());
          s.vertices.push_back(v);
          s.points.push_back(m_points[v]);
        }
        v = compact[v];
      }
      triangles.push_back(corners);
      origin.push_back(t);
    }
    std::vector<int> opposites;
    for(int t : origin)
      for(int k = 0; k < 3; ++k)
      {
        const int o = m_chart.opposites()[3 * t + k];
        opposites.push_back(o < 0 ? -1 : 3 * numbers[o / 3] + o % 3);
      }
    s.chart = Corner_table(std::move(triangles), std::move(opposites), int(s.vertices.size()));
    return s;
  }

  // Undoes collapses until `size` vertices are there, extending the flip-free map `uv` (over the
  // vertices of the whole chart). False if a star has no kernel in floating point; then that
  // collapse alone is undone and `uv` is not valid.
  template <typename Energy>
  bool refine_to(int size, std::vector<Eigen::Vector2d>& uv)
  {
    Star_placement<Energy> place;
    std::vector<int> placed;
    while(m_number_of_vertices < size && m_chart.number_of_collapses() > 0)
    {
      placed.push_back(m_chart.undo());
      ++m_number_of_vertices;
      collect_star(placed.back(), uv, [this](int h) { return shape(h); });
      if(!place(m_star, uv[placed.back()]))
        return false;
    }
    improve<Energy>(placed, uv);
    return true;
  }

private:
  // The stars of vertices have changed since they were placed: further rounds take out what would hold up the global
  // solve.
  template <typename Energy>
  void improve(const std::vector<int>& placed, std::vector<Eigen::Vector2d>& uv)
  {
    constexpr int number_of_rounds = 2;
    std::vector<Rest_shape> shapes(m_chart.triangles().size()); // each is needed for several stars and rounds
    for(int t = 0; t < int(shapes.size()); ++t)
      if(!m_chart.is_dormant(t))
        shapes[t] = shape(3 * t);
    const auto shape_from = [&shapes](int h)
    {
      const Rest_shape& s = shapes[h / 3];
      return h % 3 == 0 ? s : h % 3 == 1 ? Rest_shape{s.g1, s.g2, s.g0, s.area} : Rest_shape{s.g2, s.g0, s.g1, s.area};
    };
    for(int round = 0; round < number_of_rounds; ++round)
      for(int v : placed)
        if(!m_keeps_region || !m_chart.is_on_border(v))
        {
          collect_star(v, uv, shape_from);
          Star_placement<Energy>::improve(m_star, uv[v]);
        }
  }

  // `shape_from(h)`: the shape of the triangle of `h`, corner 0 at the source of `h`.
  template <typename ShapeFrom>
  void collect_star(int v, const std::vector<Eigen::Vector2d>& uv, const ShapeFrom& shape_from)
  {
    m_chart.fan(v, m_fan);
    m_star.clear();
    for(int h : m_fan)
      m_star.push_back({uv[m_chart.target(h)], uv[m_chart.source(previous_halfedge(h))], shape_from(h)});
    if(m_keeps_region && m_chart.is_on_border(v))
      m_star.push_back(wall());
  }

  // Keeps a border vertex on the left of the edge that its collapse made of its two border edges.
  // That region has a kernel unless the vertex is the tip of a single triangle.
  Star_triangle wall() const
  {
    Star_triangle wall{m_star.back().b, m_star.front().a, m_star.front().shape};
    wall.shape.area = 0; // no energy
    return wall;
  }

  // The shape of the triangle of `h`, corner 0 at the source of `h`.
  Rest_shape shape(int h) const
  {
    const auto point = [&](int i) -> const Eigen::Vector3d& { return m_points[m_chart.source(i)]; };
    return rest_shape(point(h), point(next_halfedge(h)), point(previous_halfedge(h)), m_minimal_edge,
                      minimal_coarse_height);
  }

  Collapsible_chart m_chart;
  const std::vector<Eigen::Vector3d>& m_points;
  bool m_keeps_region;
  double m_minimal_edge;
  int m_number_of_vertices = 0;
  std::vector<int> m_fan;
  std::vector<Star_triangle> m_star;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_CHART_HIERARCHY_H
