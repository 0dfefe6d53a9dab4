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

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Chart_simplification.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Flip_collapse.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/stars.h>

#include <Eigen/Core>

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A chart at all resolutions between a few triangles and its own: half-edge collapses (border only
// along the border), undone one after the other with the vertex placed inside the kernel of its
// star [SJZP19]. A flip-free map of a coarse stage thus becomes a flip-free map of the whole chart.
// CGAL's Surface_mesh_simplification cannot undo collapses, works on meshes and not on index arrays, and is sequential.
class Chart_hierarchy
{
public:
  // `points`: the position of each chart vertex on the surface. With `keeps_region`, the image of
  // each stage lies inside that of the coarser one, so that refining an injective map keeps it so; what is near the
  // border goes last, since a border with few edges leaves too little room to reinsert vertices.
  Chart_hierarchy(const Corner_table& chart, const std::vector<Eigen::Vector3d>& points,
                  bool keeps_region = false, Execution execution = Execution::SEQUENTIAL)
    : m_chart(chart), m_points(points), m_keeps_region(keeps_region), m_execution(execution),
      m_minimal_edge(minimal_edge(chart.triangles(), points))
  {
    for(int v = 0; v < int(points.size()); ++v)
      m_number_of_vertices += m_chart.is_used(v);
  }

  // Collapses down to about `size` vertices; those with `is_kept` (empty: none) stay. Vertices go where that changes the
  // shape least. A large chart is first coarsened region by region, in parallel and evenly, down to
  // `size_in_regions`. Call once. Returns the number of vertices that are left.
  int coarsen(int size, int size_in_regions = (std::numeric_limits<int>::max)(), const std::vector<char>& is_kept = {})
  {
    std::vector<char> may_go(m_points.size());
    for(int v = 0; v < int(m_points.size()); ++v)
      may_go[v] = m_chart.is_used(v) && (is_kept.empty() || !is_kept[v]);
    std::vector<Quadric> quadrics = vertex_quadrics(m_chart, m_points, m_execution);
    std::vector<char> is_stale(m_points.size(), 0);
    Chart_simplification simplification(m_chart, m_points, m_keeps_region, quadrics, is_stale);
    if(m_keeps_region)
    {
      std::vector<char> may_go_first = may_go;
      keep_border(may_go_first);
      const int first_size = (std::max)(size, int(least_share * m_number_of_vertices));
      coarsen_in_regions((std::max)(first_size, size_in_regions), simplification, may_go_first);
      coarsen_whole(first_size, simplification, may_go_first);
      exclude_collapsed(may_go);
    }
    coarsen_in_regions((std::max)(size, size_in_regions), simplification, may_go);
    coarsen_whole(size, simplification, may_go);
    return m_number_of_vertices;
  }

  // Collapses what is flipped under `uv` (over the vertices of the whole chart) instead. False if flips remain.
  bool collapse_flips(const std::vector<Eigen::Vector2d>& uv, int maximum_number_of_collapses)
  {
    Phase phase(1);
    const bool is_flip_free = Flip_collapse(m_chart, uv, phase.front())(maximum_number_of_collapses);
    add(std::move(phase));
    return is_flip_free;
  }

  bool is_complete() const { return m_phases.empty(); }
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
    std::vector<int> opposites(3 * origin.size());
    s.shapes.resize(origin.size());
    execute_blocks(m_execution, int(origin.size()), [&](int begin, int end)
    {
      for(int i = begin; i < end; ++i)
      {
        s.shapes[i] = shape(3 * origin[i]);
        for(int k = 0; k < 3; ++k)
        {
          const int o = m_chart.opposites()[3 * origin[i] + k];
          opposites[3 * i + k] = o < 0 ? -1 : 3 * numbers[o / 3] + o % 3;
        }
      }
    });
    s.chart = Corner_table(std::move(triangles), std::move(opposites), int(s.vertices.size()));
    return s;
  }

  // Undoes collapses until `size` vertices or a few more are there, extending the flip-free map `uv` (over the
  // vertices of the whole chart). False if a star has no kernel in floating point; then `uv` is not valid.
  template <typename Energy>
  bool refine_to(int size, std::vector<Eigen::Vector2d>& uv)
  {
    std::vector<std::vector<Refinement<Energy> > > undone; // of phases
    while(m_number_of_vertices < size && !is_complete())
    {
      undone.emplace_back(m_phases.back().size(), Refinement<Energy>(*this, uv));
      if(!undo_last_phase(size, undone.back()))
        return false;
    }
    constexpr int number_of_rounds = 2; // they take out what would hold up the global solve
    const Shapes shapes = shapes_of_triangles(); // each is needed for several stars and rounds
    for(int round = 0; round < number_of_rounds; ++round)
      for(std::vector<Refinement<Energy> >& regions : undone)
        execute(m_execution, int(regions.size()), [&](int r) { regions[r].improve(shapes); });
    return true;
  }

private:
  // Per triangle, of those that are not dormant. Not a vector, which would fill all of it first, with one thread.
  using Shapes = std::unique_ptr<Rest_shape[]>;

  // Undoes the collapses of a log.
  template <typename Energy>
  class Refinement
  {
  public:
    Refinement(Chart_hierarchy& hierarchy, std::vector<Eigen::Vector2d>& uv) : m_hierarchy(&hierarchy), m_uv(&uv) {}

    // Until so many collapses are left.
    bool undo(int number_left, Collapse_log& log)
    {
      Star_placement<Energy> place;
      while(log.size() > number_left)
      {
        const int v = m_hierarchy->m_chart.undo(log);
        m_placed.push_back(v);
        collect(v, [this](int h) { return m_hierarchy->shape(h); });
        if(!place(m_star, (*m_uv)[v]))
          return false;
      }
      return true;
    }

    // Places the vertices once more: their stars have changed.
    void improve(const Shapes& shapes)
    {
      const auto shape_of = [&shapes](int h) { return rotated(shapes[h / 3], h % 3); };
      for(int v : m_placed)
        if(!m_hierarchy->m_keeps_region || !m_hierarchy->m_chart.is_on_border(v))
        {
          collect(v, shape_of);
          Star_placement<Energy>::improve(m_star, (*m_uv)[v]);
        }
    }

  private:
    template <typename ShapeOf>
    void collect(int v, const ShapeOf& shape_of)
    {
      const Collapsible_chart& chart = m_hierarchy->m_chart;
      chart.fan(v, m_fan);
      collect_star(m_fan, chart.triangles(), *m_uv, shape_of, m_star);
      if(m_hierarchy->m_keeps_region && chart.is_on_border(v))
        m_star.push_back(wall(m_star));
    }

    Chart_hierarchy* m_hierarchy;
    std::vector<Eigen::Vector2d>* m_uv;
    std::vector<int> m_placed, m_fan;
    std::vector<Star_triangle> m_star;
  };

  // Collapses of the regions, or of the whole if there is one log.
  using Phase = std::vector<Collapse_log>;

  static int number_of_collapses(const Phase& phase)
  {
    return std::accumulate(phase.begin(), phase.end(), 0,
                           [](int sum, const Collapse_log& log) { return sum + log.size(); });
  }

  void add(Phase phase)
  {
    const int number = number_of_collapses(phase);
    m_number_of_vertices -= number;
    if(number > 0)
      m_phases.push_back(std::move(phase));
  }

  static std::vector<int> marked(const std::vector<char>& marks)
  {
    std::vector<int> result;
    for(int v = 0; v < int(marks.size()); ++v)
      if(marks[v])
        result.push_back(v);
    return result;
  }

  // The share of the vertices that is left when collapses near borders begin: errors decide about most stages.
  static constexpr double least_share = 0.25;

  // Takes the marks of what is at most a few edges from the border.
  void keep_border(std::vector<char>& may_go) const
  {
    constexpr int number_of_rings = 3;
    std::vector<char> is_near(may_go.size(), 0);
    for(int v = 0; v < int(is_near.size()); ++v)
      is_near[v] = m_chart.is_used(v) && m_chart.is_on_border(v);
    for(int ring = 0; ring < number_of_rings; ++ring)
    {
      const std::vector<char> former = is_near;
      for(const Triangle& t : m_chart.triangles())
        if(former[t[0]] || former[t[1]] || former[t[2]])
          for(int v : t)
            is_near[v] = 1;
    }
    for(std::size_t v = 0; v < may_go.size(); ++v)
      may_go[v] = may_go[v] && !is_near[v];
  }

  void exclude_collapsed(std::vector<char>& may_go) const
  {
    for(const Phase& phase : m_phases)
      for(const Collapse_log& log : phase)
        for(const Collapse_log::Collapse& c : log.collapses)
          may_go[c.vertex] = 0;
  }

  // Down to about `size` vertices, by a certain share at a time: the next regions are larger, so that most of what was at
  // the edge of one is inside then. Ends where borders and edges of regions hold most vertices.
  void coarsen_in_regions(int size, const Chart_simplification& simplification, std::vector<char>& may_go)
  {
    for(bool goes_on = true; goes_on && m_number_of_vertices > size;)
    {
      const int former = m_number_of_vertices, wanted = former - (std::max)(size, int(least_share * former));
      coarsen_regions(wanted, simplification, may_go);
      goes_on = former - m_number_of_vertices > least_share * wanted;
    }
  }

  // Takes this number of vertices, if the chart is large: from each region the same share. Those that are gone may not go
  // any more.
  void coarsen_regions(int number, const Chart_simplification& simplification, std::vector<char>& may_go)
  {
    const double share = double(number) / m_number_of_vertices;
    const Chart_regions regions(m_chart, m_points, m_execution);
    Phase phase(regions.size());
    execute(m_execution, regions.size(), [&](int r)
    {
      std::vector<int> vertices = regions.inner_vertices(r);
      vertices.erase(std::remove_if(vertices.begin(), vertices.end(), [&](int v) { return !may_go[v]; }), vertices.end());
      Chart_simplification(simplification).reduce_by(int(share * regions.number_of_vertices(r)), vertices, phase[r],
                                                     Execution::SEQUENTIAL);
      for(const Collapse_log::Collapse& c : phase[r].collapses)
        may_go[c.vertex] = 0;
    });
    add(std::move(phase));
  }

  void coarsen_whole(int size, Chart_simplification& simplification, const std::vector<char>& may_go)
  {
    Phase phase(1);
    simplification.reduce_by(m_number_of_vertices - size, marked(may_go), phase.front(), m_execution);
    add(std::move(phase));
  }

  // Until `size` vertices or a few more are there, in all regions the same share of what is left to undo.
  template <typename Energy>
  bool undo_last_phase(int size, std::vector<Refinement<Energy> >& regions)
  {
    Phase& phase = m_phases.back();
    const int number = number_of_collapses(phase);
    const int number_left = (std::max)(0, number - (size - m_number_of_vertices));
    std::vector<char> is_extended(regions.size(), 1);
    execute(m_execution, int(regions.size()), [&](int r)
    {
      const long long scaled = static_cast<long long>(number_left) * phase[r].size();
      is_extended[r] = regions[r].undo(int(scaled / number), phase[r]);
    });
    m_number_of_vertices += number - number_of_collapses(phase);
    if(number_of_collapses(phase) == 0)
      m_phases.pop_back();
    return std::find(is_extended.begin(), is_extended.end(), char(0)) == is_extended.end();
  }

  Shapes shapes_of_triangles() const
  {
    const int size = int(m_chart.triangles().size());
    Shapes shapes(new Rest_shape[size]);
    execute_blocks(m_execution, size, [&](int begin, int end)
    {
      for(int t = begin; t < end; ++t)
        if(!m_chart.is_dormant(t))
          shapes[t] = shape(3 * t);
    });
    return shapes;
  }

  // Keeps a border vertex on the left of the edge that its collapse made of its two border edges.
  // That region has a kernel unless the vertex is the tip of a single triangle.
  static Star_triangle wall(const std::vector<Star_triangle>& star)
  {
    Star_triangle wall{star.back().b, star.front().a, star.front().shape};
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
  Execution m_execution;
  double m_minimal_edge;
  int m_number_of_vertices = 0;
  std::vector<Phase> m_phases; // none without collapses
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_CHART_HIERARCHY_H
