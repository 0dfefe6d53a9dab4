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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_BORDER_OVERLAPS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_BORDER_OVERLAPS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Decides exactly whether the interiors of the parts of a flat, flip-free chart are disjoint and
// each covers the plane at most once.
//
// This holds iff nowhere on the borders the surface at the left of one border reaches into the surface at the left of
// another, and no part lies inside another. Such a reach is a proper crossing of two segments, two segments on top of
// each other in the same direction, or a vertex on a segment or another vertex where the two angles of surface
// overlap. Mere contact (angles that do not overlap, segments on top of each other in opposite directions) is no
// overlap: the map is injective up to contact.
class Border_overlaps
{
public:
  // `uv` is finite. O(n + (b + k) log b) for b border segments with k pairs of meeting boxes.
  Border_overlaps(const Corner_table& chart, const Connected_parts& parts, const std::vector<Eigen::Vector2d>& uv)
    : m_chart(chart), m_parts(parts), m_incoming(chart.number_of_vertices(), -1)
  {
    m_points.reserve(uv.size());
    for(const Eigen::Vector2d& p : uv)
      m_points.emplace_back(p.x(), p.y());
    for(int h = 0; h < int(chart.opposites().size()); ++h)
      if(chart.is_border(h))
      {
        m_border.push_back(h);
        m_incoming[chart.target(h)] = h;
      }
    find_crossings();
    find_containments();
  }

  // Pairs of border halfedges, and of parts where the first lies inside the second, both sorted.
  const std::vector<std::pair<int, int> >& crossings() const { return m_crossings; }
  const std::vector<std::pair<int, int> >& containments() const { return m_containments; }

private:
  using Point_2 = Exact_predicates_inexact_constructions_kernel::Point_2;
  using Box = Box_intersection_d::Box_with_info_d<double, 2, int>;

  // An angle of surface: counterclockwise from `begin` to `end`, a full turn where they agree.
  struct Sector { Point_2 begin, end; };

  const Point_2& source(int h) const { return m_points[m_chart.source(h)]; }
  const Point_2& target(int h) const { return m_points[m_chart.target(h)]; }

  Sector sector_at_source(int h) const
  {
    return {target(h), source(m_incoming[m_chart.source(h)])};
  }
  // That of a point between the ends of a border segment.
  Sector sector_along(int h) const { return {target(h), source(h)}; }

  static bool have_same_direction(const Point_2& center, const Point_2& p, const Point_2& q)
  {
    return collinear(center, p, q) && compare_xy(center, p) == compare_xy(center, q);
  }

  // Whether the direction of `p` is in `s`; the begin belongs to it, the end does not.
  static bool is_in_sector(const Point_2& center, const Point_2& p, const Sector& s)
  {
    if(have_same_direction(center, p, s.begin) || have_same_direction(center, s.begin, s.end))
      return true;
    switch(orientation(center, s.begin, s.end))
    {
    case LEFT_TURN:
      return left_turn(center, s.begin, p) && left_turn(center, p, s.end);
    case RIGHT_TURN: // the rest is less than half a turn
      return !have_same_direction(center, p, s.end) &&
             !(left_turn(center, s.end, p) && left_turn(center, p, s.begin));
    default:
      return left_turn(center, s.begin, p);
    }
  }

  static bool do_overlap(const Point_2& center, const Sector& s, const Sector& t)
  {
    return is_in_sector(center, s.begin, t) || is_in_sector(center, t.begin, s);
  }

  static bool is_between(const Point_2& p, const Point_2& q, const Point_2& r)
  {
    return collinear_are_strictly_ordered_along_line(p, q, r);
  }

  // Whether the surfaces along two border halfedges overlap at a point of both segments. The
  // targets are left to the next halfedges.
  bool do_overlap(int g, int h) const
  {
    const Point_2 &p = source(g), &q = target(g), &r = source(h), &s = target(h);
    const Orientation pqr = orientation(p, q, r), pqs = orientation(p, q, s);
    const Orientation rsp = orientation(r, s, p), rsq = orientation(r, s, q);
    if(pqr * pqs < 0 && rsp * rsq < 0)
      return true;
    if(p == r)
      return m_chart.source(g) != m_chart.source(h)
          && do_overlap(p, sector_at_source(g), sector_at_source(h));
    if(pqr == COLLINEAR && is_between(p, r, q)
       && do_overlap(r, sector_along(g), sector_at_source(h)))
      return true;
    return rsp == COLLINEAR && is_between(r, p, s)
        && do_overlap(p, sector_along(h), sector_at_source(g));
  }

  std::vector<Box> boxes_of_segments() const
  {
    std::vector<Box> boxes;
    for(int h : m_border)
      boxes.emplace_back(source(h).bbox() + target(h).bbox(), h);
    return boxes;
  }

  void find_crossings()
  {
    std::vector<Box> boxes = boxes_of_segments();
    box_self_intersection_d(boxes.begin(), boxes.end(), [this](const Box& a, const Box& b)
    {
      if(do_overlap(a.info(), b.info()))
        m_crossings.push_back(std::minmax(a.info(), b.info()));
    });
    std::sort(m_crossings.begin(), m_crossings.end());
  }

  // Borders that do not cross are nested or apart: one vertex of each part tells, by the winding
  // numbers of the other borders around it, which are counted along a ray to the right. Where it
  // lies on another border, the crossings have told already.
  void find_containments()
  {
    std::vector<int> probe(m_parts.number, -1); // a border halfedge per part
    for(int h : m_border)
      if(probe[m_parts.part[h / 3]] < 0)
        probe[m_parts.part[h / 3]] = h;
    if(m_parts.number < 2)
      return;

    std::vector<Box> segments = boxes_of_segments(), rays;
    double right = source(m_border.front()).x();
    for(int h : m_border)
      right = (std::max)(right, source(h).x());
    for(int h : probe)
      if(h >= 0)
        rays.emplace_back(Bbox_2(source(h).x(), source(h).y(), right, source(h).y()), h);

    std::vector<std::pair<int, int> > crossing_parts;
    for(const std::pair<int, int>& c : m_crossings)
      crossing_parts.push_back(std::minmax(m_parts.part[c.first / 3], m_parts.part[c.second / 3]));
    std::sort(crossing_parts.begin(), crossing_parts.end());

    constexpr int contact = 0;
    std::vector<std::array<int, 3> > meetings; // inner part, outer part, turn
    box_intersection_d(rays.begin(), rays.end(), segments.begin(), segments.end(),
                       [&](const Box& ray, const Box& segment)
    {
      const int inner = m_parts.part[ray.info() / 3], outer = m_parts.part[segment.info() / 3];
      const Point_2& p = source(ray.info());
      const Point_2 &s = source(segment.info()), &t = target(segment.info());
      if(inner == outer)
        return;
      const Orientation side = orientation(s, t, p);
      if(side == COLLINEAR && collinear_are_ordered_along_line(s, p, t))
        meetings.push_back({inner, outer, contact});
      else if(s.y() <= p.y() && p.y() < t.y() && side == LEFT_TURN)
        meetings.push_back({inner, outer, 1});
      else if(t.y() <= p.y() && p.y() < s.y() && side == RIGHT_TURN)
        meetings.push_back({inner, outer, -1});
    });
    std::sort(meetings.begin(), meetings.end());
    for(auto first = meetings.begin(); first != meetings.end(); )
    {
      const int inner = (*first)[0], outer = (*first)[1];
      int winding_number = 0;
      bool has_contact = std::binary_search(crossing_parts.begin(), crossing_parts.end(),
                                            std::pair<int, int>(std::minmax(inner, outer)));
      auto last = first;
      for(; last != meetings.end() && (*last)[0] == inner && (*last)[1] == outer; ++last)
      {
        winding_number += (*last)[2];
        has_contact = has_contact || (*last)[2] == contact;
      }
      if(winding_number != 0 && !has_contact)
        m_containments.emplace_back(inner, outer);
      first = last;
    }
  }

  const Corner_table& m_chart;
  const Connected_parts& m_parts;
  std::vector<Point_2> m_points; // per chart vertex
  std::vector<int> m_border;     // all border halfedges
  std::vector<int> m_incoming;   // per chart vertex, the border halfedge that leads to it
  std::vector<std::pair<int, int> > m_crossings, m_containments;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_BORDER_OVERLAPS_H
