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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACKING_CERTIFICATE_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACKING_CERTIFICATE_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/Packing_margin.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Page_tile.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>

#include <CGAL/Surface_mesh_parameterization/internal/bijective/Border_overlaps.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/box_intersection_d.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <Eigen/Core>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using Surface_mesh_parameterization::internal::Connected_parts;
using Surface_mesh_parameterization::internal::Corner_table;
using Surface_mesh_parameterization::internal::Triangle;

// Proves that each chart lies on a page, and all apart: no chart on another one, all distances at least the margin.
// What decides is exact, numbers of type `double` only sort out the clear cases.
class Packing_certificate
{
public:
  // `uv` is finite and without flips. O(n log n) for borders that have few neighbors.
  Packing_certificate(const Corner_table& chart, const std::vector<Eigen::Vector2d>& uv, const Packing_margin& margin,
                      int number_of_pages = 1)
    : m_chart(chart), m_parts(chart.opposites()), m_uv(uv), m_margin(margin), m_number_of_pages(number_of_pages)
  {
    find_outside();
    find_close();
    find_overlaps();
    CGAL::internal::Graph_kernel::sort_unique(m_faces);
  }

  explicit operator bool() const { return m_faces.empty(); }
  int outside() const { return m_outside; }   // triangles too far out
  int too_close() const { return m_too_close; } // pairs of border edges of different charts
  int overlaps() const { return m_overlaps; } // pairs of border edges or charts

  Indexed_status status() const
  {
    if(m_faces.empty())
      return Indexed_status();
    std::string message = "the charts are not packed: triangles outside of the square or too close to its border: "
                        + std::to_string(m_outside) + ", edges of charts too close to each other: "
                        + std::to_string(m_too_close) + ", overlaps of different charts: " + std::to_string(m_overlaps);
    return Indexed_status(Status_code::NOT_CERTIFIED, std::move(message), Element_kind::FACE, m_faces);
  }

private:
  using Number = Exact_rational;
  using Kernel = Simple_cartesian<Number>;
  using Box = Box_intersection_d::Box_with_info_d<double, 2, int>;
  static constexpr double doubt = 1e-12; // far above what is rounded in the unit square

  const Eigen::Vector2d& source(int h) const { return m_uv[m_chart.source(h)]; }
  const Eigen::Vector2d& target(int h) const { return m_uv[m_chart.target(h)]; }

  // From `begin`, one side of a page long.
  bool is_inside(double coordinate, double begin) const
  {
    const double distance = (std::min)(coordinate - begin, begin + 1 - coordinate);
    if(distance > m_margin.distance() + doubt)
      return true;
    const Number texels = (Number(coordinate) - begin) * m_margin.texture_size, margin = m_margin.texels;
    return texels >= margin && m_margin.texture_size - texels >= margin;
  }

  // The page at the middle of each part.
  std::vector<int> pages_of_parts() const
  {
    std::vector<Surface_mesh_parameterization::internal::Bounding_box<2> > boxes(m_parts.number);
    for(int f = 0; f < m_chart.number_of_triangles(); ++f)
      for(const int v : m_chart.triangles()[f])
        boxes[m_parts.part[f]].add(m_uv[v]);
    std::vector<int> pages;
    for(const auto& box : boxes)
      pages.push_back(page_at(0.5 * (box.low + box.high)));
    return pages;
  }

  void find_outside()
  {
    const std::vector<int> pages = pages_of_parts();
    for(int f = 0; f < m_chart.number_of_triangles(); ++f)
    {
      const int page = pages[m_parts.part[f]];
      const Eigen::Vector2d corner = corner_of_page((std::max)(page, 0));
      const Triangle& t = m_chart.triangles()[f];
      const auto is_on_page = [&](int v) { return is_inside(m_uv[v].x(), corner.x()) && is_inside(m_uv[v].y(), corner.y()); };
      if(page >= 0 && page < m_number_of_pages && std::all_of(t.begin(), t.end(), is_on_page))
        continue;
      ++m_outside;
      m_faces.push_back(f);
    }
  }

  static double squared_distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b)
  {
    const Eigen::Vector2d d = b - a;
    const double length = d.squaredNorm();
    const double t = length > 0 ? (std::min)(1., (std::max)(0., (p - a).dot(d) / length)) : 0;
    return (p - a - t * d).squaredNorm();
  }

  // Of edges that do not cross; if they do, that is an overlap.
  bool are_too_close(int g, int h) const
  {
    const double squared = (std::min)((std::min)(squared_distance_to_segment(source(g), source(h), target(h)),
                                                 squared_distance_to_segment(target(g), source(h), target(h))),
                                      (std::min)(squared_distance_to_segment(source(h), source(g), target(g)),
                                                 squared_distance_to_segment(target(h), source(g), target(g))));
    const double wanted = m_margin.distance() * m_margin.distance();
    if(squared > wanted + doubt)
      return false;
    const auto exact_segment = [this](int i)
    {
      return Kernel::Segment_2(Kernel::Point_2(Number(source(i).x()), Number(source(i).y())),
                               Kernel::Point_2(Number(target(i).x()), Number(target(i).y())));
    };
    const Number size = m_margin.texture_size, texels = m_margin.texels;
    return squared_distance(exact_segment(g), exact_segment(h)) * size * size < texels * texels;
  }

  Bbox_2 box_of(int h) const
  {
    const Eigen::Vector2d low = source(h).cwiseMin(target(h)), high = source(h).cwiseMax(target(h));
    return Bbox_2(low.x(), low.y(), high.x(), high.y());
  }

  // Half of the margin and more on all sides, so that boxes of what is too close meet.
  Bbox_2 grown(const Bbox_2& box) const
  {
    const double r = 0.5 * m_margin.distance() + doubt;
    return Bbox_2(box.xmin() - r, box.ymin() - r, box.xmax() + r, box.ymax() + r);
  }

  // Charts whose boxes are close, and then what of their borders is.
  void find_close()
  {
    std::vector<std::vector<int> > borders(m_parts.number);
    std::vector<Bbox_2> boxes_of_parts(m_parts.number);
    for(int h = 0; h < int(m_chart.opposites().size()); ++h)
      if(m_chart.is_border(h))
      {
        borders[m_parts.part[h / 3]].push_back(h);
        boxes_of_parts[m_parts.part[h / 3]] += box_of(h);
      }
    std::vector<Box> parts;
    for(int i = 0; i < m_parts.number; ++i)
      if(!borders[i].empty())
        parts.emplace_back(grown(boxes_of_parts[i]), i);
    std::vector<std::pair<int, int> > close;
    box_self_intersection_d(parts.begin(), parts.end(), [&close](const Box& a, const Box& b)
                            { close.push_back(std::minmax(a.info(), b.info())); });
    std::sort(close.begin(), close.end());
    for(const auto& [i, j] : close)
      compare_borders(borders[i], boxes_of_parts[i], borders[j], boxes_of_parts[j]);
  }

  void compare_borders(const std::vector<int>& first, const Bbox_2& first_box, const std::vector<int>& second,
                       const Bbox_2& second_box)
  {
    const auto edges_near = [this](const std::vector<int>& border, const Bbox_2& other)
    {
      std::vector<Box> edges;
      for(const int h : border)
        if(do_overlap(grown(box_of(h)), grown(other)))
          edges.emplace_back(grown(box_of(h)), h);
      return edges;
    };
    std::vector<Box> a = edges_near(first, second_box), b = edges_near(second, first_box);
    box_intersection_d(a.begin(), a.end(), b.begin(), b.end(), [this](const Box& g, const Box& h)
    {
      if(!are_too_close(g.info(), h.info()))
        return;
      ++m_too_close;
      m_faces.push_back(g.info() / 3);
      m_faces.push_back(h.info() / 3);
    });
  }

  void find_overlaps()
  {
    const Surface_mesh_parameterization::internal::Border_overlaps overlaps(m_chart, m_parts, m_uv);
    for(const auto& [g, h] : overlaps.crossings())
      if(m_parts.part[g / 3] != m_parts.part[h / 3])
      {
        ++m_overlaps;
        m_faces.push_back(g / 3);
        m_faces.push_back(h / 3);
      }
    for(const auto& containment : overlaps.containments())
    {
      ++m_overlaps;
      const auto begin = m_parts.part.begin();
      m_faces.push_back(int(std::find(begin, m_parts.part.end(), containment.first) - begin));
    }
  }

  const Corner_table& m_chart;
  const Connected_parts m_parts;
  const std::vector<Eigen::Vector2d>& m_uv;
  const Packing_margin m_margin;
  const int m_number_of_pages;
  int m_outside = 0, m_too_close = 0, m_overlaps = 0;
  std::vector<int> m_faces;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACKING_CERTIFICATE_H
