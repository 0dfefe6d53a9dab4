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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_RIGID_CHART_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_RIGID_CHART_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Chart_rotation.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Rigid_motion.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/winding_of_segment.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Distance_field.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The same angles, with translations scaled by a factor: about where charts are when the square shrinks.
inline std::vector<Rigid_motion> narrowed(const std::vector<Rigid_motion>& motions, double factor)
{
  std::vector<Rigid_motion> result;
  result.reserve(motions.size());
  for(const Rigid_motion& motion : motions)
    result.emplace_back(motion.angle(), factor * motion.translation());
  return result;
}

// Samples that follow each other, in a circle.
struct Sample_block
{
  int begin, end;
  Eigen::Vector2d center;
  double radius;
};

// A chart that is moved as a whole.
struct Rigid_chart
{
  std::vector<Outline_segment> outline; // with few segments
  Distance_field field;
  std::vector<Eigen::Vector2d> samples; // of the outline, all corners among them that can be closest to another chart
  std::vector<Sample_block> blocks;     // of samples
  std::vector<Eigen::Vector2d> starts;  // of the loops of the outline
  double radius = 0;                    // of a circle around the origin
  double perimeter = 0;
  Chart_rotation rotation;

  // `reach`: up to which distance the field is asked for.
  Rigid_chart(std::vector<Outline_segment> segments, double reach, Chart_rotation rotation = Chart_rotation::ANY)
    : outline(std::move(segments)), field(outline, reach), rotation(rotation)
  {
    constexpr double samples_between_corners = 30;
    for(const Outline_segment& s : outline)
      perimeter += (s.target - s.source).norm();
    const double spacing = perimeter / samples_between_corners;
    double length = 0; // since the last sample
    const auto add_sample = [&](const Eigen::Vector2d& p)
    {
      samples.push_back(p);
      length = 0;
    };
    for(std::size_t i = 0; i < outline.size(); ++i)
    {
      const Outline_segment& s = outline[i];
      if(i == 0 || outline[i - 1].target != s.source)
        starts.push_back(s.source);
      if(length >= spacing || i == 0 || !is_reflex(outline[i - 1], s))
        add_sample(s.source);
      const double rest = (s.target - s.source).norm();
      const int number = rest > spacing ? int(std::ceil(rest / spacing)) : 1;
      for(int k = 1; k < number; ++k)
        add_sample(s.source + double(k) / number * (s.target - s.source));
      length += rest / number;
      radius = (std::max)(radius, s.source.norm());
    }
    constexpr int block_size = 6;
    for(int begin = 0; begin < int(samples.size()); begin += block_size)
      add_block(begin, (std::min)(begin + block_size, int(samples.size())));
  }

  // Where a turn is measured as a length: at infinity if the chart keeps its angle, as no push turns it then.
  double lever() const
  {
    return rotation == Chart_rotation::ANY ? radius : std::numeric_limits<double>::infinity();
  }

private:
  // Whether the outline turns to the right between the segments, so that one of them comes closer to anything outside
  // than their common corner does. What is not known to follow each other is not.
  static bool is_reflex(const Outline_segment& former, const Outline_segment& next)
  {
    const Eigen::Vector2d a = former.target - former.source, b = next.target - next.source;
    return former.target == next.source && a.x() * b.y() - a.y() * b.x() < 0;
  }

  void add_block(int begin, int end)
  {
    Surface_mesh_parameterization::internal::Bounding_box<2> box;
    for(int k = begin; k < end; ++k)
      box.add(samples[k]);
    Sample_block block = {begin, end, 0.5 * (box.low + box.high), 0};
    for(int k = begin; k < end; ++k)
      block.radius = (std::max)(block.radius, (samples[k] - block.center).norm());
    blocks.push_back(block);
  }
};

// Whether `p` lies inside of the outline, to the left of its segments.
inline bool is_inside(const std::vector<Outline_segment>& outline, const Eigen::Vector2d& p)
{
  int winding_number = 0;
  for(const Outline_segment& s : outline)
    winding_number += winding_of_segment(s.source, s.target, p);
  return winding_number != 0;
}

// Whether the charts have points in common, if all corners of each lie apart from the border of the other one.
// O(nm); rounding does not matter, as segments that nearly touch would have a corner close to the other one.
inline bool do_overlap(const Rigid_chart& first, const Rigid_motion& at_first, const Rigid_chart& second,
                       const Rigid_motion& at_second)
{
  const Rigid_motion relative = at_first.relative_to(at_second);
  const auto side = [](const Outline_segment& s, const Eigen::Vector2d& p)
  {
    const Eigen::Vector2d d = s.target - s.source, q = p - s.source;
    return d.x() * q.y() - d.y() * q.x() > 0;
  };
  for(const Outline_segment& segment : first.outline)
  {
    const Outline_segment a = {relative(segment.source), relative(segment.target)};
    for(const Outline_segment& b : second.outline)
      if(side(a, b.source) != side(a, b.target) && side(b, a.source) != side(b, a.target))
        return true;
  }
  const Rigid_motion back = at_second.relative_to(at_first);
  const auto has_inside = [](const Rigid_chart& chart, const Rigid_chart& other, const Rigid_motion& motion)
  {
    return std::any_of(other.starts.begin(), other.starts.end(),
                       [&](const Eigen::Vector2d& p) { return is_inside(chart.outline, motion(p)); });
  };
  return has_inside(second, first, relative) || has_inside(first, second, back);
}

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_RIGID_CHART_H
