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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_SCAFFOLD_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_SCAFFOLD_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/bijective/Marked_triangulation.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A triangulation of what a flat chart leaves free of a box around it [JSP17]: its holes and its outside. As long as
// no triangle of the chart and of the scaffold flips and the box stands still, the borders of the chart cannot cross.
class Scaffold
{
public:
  // `uv` maps the chart without flips, and no two of its border edges touch. False if they do.
  // O(b log b) for b border edges on usual charts.
  bool build(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv)
  {
    m_points = uv;
    m_triangulation.clear();
    if(!insert_border(chart))
      return false;
    insert_box(chart);
    if(!mark_outside(chart))
      return false;
    refine();
    collect();
    return true;
  }

  // Over the vertices of the chart, followed by those of the scaffold.
  const std::vector<Triangle>& triangles() const { return m_triangles; }
  const std::vector<Eigen::Vector2d>& points() const { return m_points; }
  // The vertices of the scaffold start with the corners of the box.
  static constexpr int number_of_corners = 4;

private:
  // Whose marks say whether a face is outside of the chart. Where borders cross, it throws.
  using Triangulation = Marked_triangulation;
  using Vertex_handle = Triangulation::Vertex_handle;
  using Face_handle = Triangulation::Face_handle;
  using Point_2 = Triangulation::Point;

  Vertex_handle insert(int v, Face_handle hint)
  {
    const Vertex_handle handle = m_triangulation.insert(Point_2(m_points[v].x(), m_points[v].y()), hint);
    handle->info() = v;
    return handle;
  }

  // The borders become constraints.
  bool insert_border(const Corner_table& chart)
  {
    m_handles.assign(chart.number_of_vertices(), Vertex_handle());
    m_border.clear();
    Face_handle hint;
    for(const std::vector<int>& loop : chart.border_loops())
      for(int h : loop)
      {
        m_border.push_back(h);
        m_handles[chart.source(h)] = insert(chart.source(h), hint);
        hint = m_handles[chart.source(h)]->face();
      }
    if(m_triangulation.number_of_vertices() != m_border.size())
      return false;
    try
    {
      for(int h : m_border)
        m_triangulation.insert_constraint(m_handles[chart.source(h)], m_handles[chart.target(h)]);
    }
    catch(const Triangulation::Intersection_of_constraints_exception&)
    {
      return false;
    }
    return true;
  }

  void insert_box(const Corner_table& chart)
  {
    constexpr double margin = 0.5; // on each side, as a fraction of the extent
    Bounding_box<2> box;
    for(int h : m_border)
      box.add(m_points[chart.source(h)]);
    box.grow(margin * box.longest_side());
    const Eigen::Vector2d corners[number_of_corners]
      = {box.low, Eigen::Vector2d(box.high.x(), box.low.y()), box.high, Eigen::Vector2d(box.low.x(), box.high.y())};
    for(const Eigen::Vector2d& corner : corners)
    {
      m_points.push_back(corner);
      insert(int(m_points.size()) - 1, Face_handle());
    }
  }

  // Fills the outside from the right sides of the border. False if a border edge is no edge.
  bool mark_outside(const Corner_table& chart)
  {
    for(Face_handle f : m_triangulation.finite_face_handles())
      f->info() = false;
    std::vector<Face_handle> stack;
    const auto push = [&](Face_handle f)
    {
      if(!m_triangulation.is_infinite(f) && !std::exchange(f->info(), true))
        stack.push_back(f);
    };
    for(int h : m_border)
    {
      Face_handle f;
      int i;
      if(!m_triangulation.is_edge(m_handles[chart.target(h)], m_handles[chart.source(h)], f, i))
        return false;
      // The edge runs counterclockwise in its face on the right of the border.
      push(f->vertex(Triangulation::ccw(i)) == m_handles[chart.target(h)] ? f : f->neighbor(i));
    }
    while(!stack.empty())
    {
      const Face_handle f = stack.back();
      stack.pop_back();
      for(int i = 0; i < 3; ++i)
        if(!f->is_constrained(i))
          push(f->neighbor(i));
    }
    return true;
  }

  struct Off_center
  {
    Eigen::Vector2d point;
    double clearance; // from other vertices and from constraints
  };

  // Inserts off-centers [U04] of slim triangles, so that the triangles grow away from the border.
  // Without these points, triangles with three corners in a row on the border would keep it from
  // bending. The border itself is never split: what cannot be improved otherwise stays.
  void refine()
  {
    constexpr int maximum_passes = 16; // a limit
    std::vector<Off_center> centers;
    for(int pass = 0; pass < maximum_passes; ++pass)
    {
      centers.clear();
      for(Face_handle f : m_triangulation.finite_face_handles())
        if(f->info())
          propose(f, centers);
      const std::size_t former = m_points.size();
      Face_handle hint;
      for(const Off_center& center : centers)
        hint = insert(center, hint);
      if(m_points.size() == former)
        return;
    }
  }

  const Eigen::Vector2d& point(Face_handle f, int i) const { return m_points[f->vertex(i)->info()]; }

  void propose(Face_handle f, std::vector<Off_center>& centers) const
  {
    constexpr double largest_ratio = 2; // of circumradius and shortest edge
    double squared_length[3]; // across from each corner
    for(int i = 0; i < 3; ++i)
      squared_length[i] = (point(f, (i + 1) % 3) - point(f, (i + 2) % 3)).squaredNorm();
    const int apex = int(std::min_element(squared_length, squared_length + 3) - squared_length);
    const Eigen::Vector2d& origin = point(f, (apex + 1) % 3);
    const Eigen::Vector2d base = point(f, (apex + 2) % 3) - origin, side = point(f, apex) - origin;
    // The circumcenter: half the base, and up along its normal.
    const double length = std::sqrt(squared_length[apex]);
    const Eigen::Vector2d normal(-base.y() / length, base.x() / length);
    const Eigen::Vector2d other_side = side - base;
    const double height = side.dot(other_side) / (2 * side.dot(normal));
    const double radius = std::sqrt(height * height + 0.25 * squared_length[apex]);
    if(!(radius > largest_ratio * length))
      return;
    // Where the apex over this edge would just make the triangle good enough.
    const double good_height = length * (largest_ratio + std::sqrt(largest_ratio * largest_ratio - 0.25));
    // Closer points would make slimmer triangles.
    centers.push_back({origin + 0.5 * base + (std::min)(height, good_height) * normal, length / largest_ratio});
  }

  static double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
  {
    const Eigen::Vector2d d = b - a;
    Eigen::Vector2d to_point = p - a;
    const double t = d.squaredNorm() > 0 ? to_point.dot(d) / d.squaredNorm() : 0;
    to_point -= (std::max)(0., (std::min)(1., t)) * d;
    return to_point.norm();
  }

  // Whether the face `f` that contains a center is outside and leaves it its clearance.
  bool has_room(Face_handle f, const Off_center& center) const
  {
    if(m_triangulation.is_infinite(f) || !f->info())
      return false;
    for(int k = 0; k < 3; ++k)
    {
      const Eigen::Vector2d &a = point(f, (k + 1) % 3), &b = point(f, (k + 2) % 3);
      const bool is_wall = f->is_constrained(k) || m_triangulation.is_infinite(f->neighbor(k));
      if((a - center.point).norm() < center.clearance ||
         (is_wall && distance_to_segment(center.point, a, b) < center.clearance))
        return false;
    }
    return true;
  }

  // Unless it lies too close to what is there. Returns a face near by.
  Face_handle insert(const Off_center& center, Face_handle hint)
  {
    Triangulation::Locate_type type;
    int i;
    const Point_2 p(center.point.x(), center.point.y());
    const Face_handle f = m_triangulation.locate(p, type, i, hint);
    if((type != Triangulation::FACE && type != Triangulation::EDGE) || !has_room(f, center))
      return f;
    m_points.push_back(center.point);
    const Vertex_handle v = m_triangulation.insert(p, type, f, i);
    v->info() = int(m_points.size()) - 1;
    auto around = m_triangulation.incident_faces(v), done = around;
    do
      around->info() = true;
    while(++around != done);
    return v->face();
  }

  // The triangles of the outside.
  void collect()
  {
    m_triangles.clear();
    for(Face_handle f : m_triangulation.finite_face_handles())
      if(f->info())
        m_triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  }

  Triangulation m_triangulation;
  std::vector<Vertex_handle> m_handles; // per chart vertex
  std::vector<int> m_border;            // halfedges
  std::vector<Triangle> m_triangles;
  std::vector<Eigen::Vector2d> m_points;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_SCAFFOLD_H
