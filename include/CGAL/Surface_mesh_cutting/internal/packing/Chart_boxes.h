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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_BOXES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_BOXES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/Box_packing.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Packed_charts.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/chart_angles.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Execution.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using CGAL::internal::Graph_kernel::Go_further;

// Packs the boxes around charts, which takes milliseconds, and hardly any packing fills more where the charts fill their
// boxes. Best fits are found at growing scales, at first with the right widths, then with misjudged ones.
class Chart_boxes
{
public:
  // `angles`: to which charts are turned first.
  Chart_boxes(const std::vector<Chart_outline>& outlines, std::vector<double> angles, bool may_turn, double margin,
              int most_pages)
    : m_angles(std::move(angles)), m_may_turn(may_turn), m_margin(margin), m_most_pages(most_pages), m_random(0)
  {
    for(std::size_t i = 0; i < outlines.size(); ++i)
    {
      m_boxes.push_back(outlines[i].box(m_angles[i]));
      const double area = m_boxes.back().size().prod();
      m_area += area;
      m_are_full = m_are_full && outlines[i].area >= full_share * area;
    }
  }

  // Whether all charts are rectangles, or nearly.
  bool are_full() const { return m_are_full; }

  // At a given scale; none if there is no room.
  std::optional<Packed_charts> pack_at(double scale)
  {
    const auto places = try_scale(scale, 0);
    return places ? std::make_optional(to_motions(*places, scale)) : std::nullopt;
  }

  // At the largest scale found up to `limit`; none if there is none above a thousandth of that at which they fill the pages.
  std::optional<Packed_charts> pack(double limit, const Go_further& go_further)
  {
    constexpr double first = 1.05, finest = 1.0005, rounding = 1e-7, hopeless = 1e-3;
    constexpr double tried_boxes = 200000; // in all
    constexpr double patience = 0.3;       // the share of tries after which it ends where it has not grown
    limit = (std::min)(limit, std::sqrt(m_most_pages / m_area));
    double scale = limit;
    std::optional<std::vector<Box_place> > best;
    while(scale > hopeless * limit && !(best = try_scale(scale, 0)))
      scale /= first;
    if(!best)
      return std::nullopt;
    const int tries = int(tried_boxes / double(m_boxes.size())) + 20;
    double factor = first;
    int failed = 0; // with this factor
    for(int k = 0, last = 0; k < tries && k - last < patience * tries && scale < limit && go_further(); ++k)
    {
      const double next = (std::min)(scale * factor, limit), noises[] = {0, 0.05, 0.2, 0.5, 1};
      if(auto places = try_scale(next, noises[failed % 5]))
      {
        best = std::move(places);
        scale = next;
        failed = 0;
        last = k;
      }
      else if(++failed % 25 == 0 || (factor > coarse && failed == 1))
      {
        factor = (std::max)(finest, std::sqrt(factor));
        failed = 0;
      }
    }
    for(double rest = finest - 1; rest > rounding && go_further(); rest /= 2)
      if(auto places = try_scale((std::min)(scale * (1 + rest), limit), 0))
      {
        best = std::move(places);
        scale = (std::min)(scale * (1 + rest), limit);
      }
    return to_motions(*best, scale);
  }

private:
  static constexpr double full_share = 0.98; // of the area of a box
  static constexpr double reserve = 2e-6;    // for rounding of coordinates of type `float`, where there is no margin
  static constexpr double coarse = 1.005;    // steps that are not worth many tries

  std::optional<std::vector<Box_place> > try_scale(double scale, double noise)
  {
    std::vector<Eigen::Vector2d> sizes;
    for(const auto& box : m_boxes)
      sizes.push_back(scale * box.size() + Eigen::Vector2d::Constant(m_margin + reserve));
    return Box_packing(sizes, 1 - m_margin - reserve, m_may_turn).pack(m_most_pages, noise, m_random);
  }

  // Boxes include the margin on their right and above.
  Packed_charts to_motions(const std::vector<Box_place>& places, double scale) const
  {
    Packed_charts packed;
    packed.scale = scale;
    for(std::size_t i = 0; i < places.size(); ++i)
    {
      const Box_place& place = places[i];
      const Eigen::Vector2d low = place.is_turned ? Eigen::Vector2d(-m_boxes[i].high.y(), m_boxes[i].low.x()) : m_boxes[i].low;
      packed.motions.push_back({m_angles[i] + (place.is_turned ? CGAL_PI / 2 : 0),
                                place.corner + Eigen::Vector2d::Constant(m_margin + reserve) - scale * low, place.page});
    }
    return packed;
  }

  const std::vector<double> m_angles;
  const bool m_may_turn;
  const double m_margin;
  const int m_most_pages;
  Packing_random m_random;
  std::vector<Surface_mesh_parameterization::internal::Bounding_box<2> > m_boxes; // of turned charts
  double m_area = 0; // of the boxes
  bool m_are_full = true;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_BOXES_H
