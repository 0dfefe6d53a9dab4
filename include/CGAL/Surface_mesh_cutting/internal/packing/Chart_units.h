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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_UNITS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_UNITS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Chart_rotation.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Chart_outline.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Mirrored_parts.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Packed_charts.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/chart_angles.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <complex>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Charts as they are packed: a chart and its mirror image side by side as one, both and those that are their own mirror images
// with a vertical axis, and any other ones.
class Chart_units
{
public:
  // `gap`: between a chart and its image. With `Chart_rotation::NONE`, charts keep their directions but for images.
  Chart_units(const std::vector<Chart_outline>& outlines, const Mirrored_parts& mirrored, Chart_rotation rotation, double gap)
    : m_mirrored(mirrored), m_rotation(rotation)
  {
    for(int i = 0; i < int(outlines.size()); ++i)
    {
      const int image = mirrored.images[i];
      if(image >= 0 && image < i)
        continue;
      m_outlines.emplace_back();
      m_outlines.back().has_axis = image >= 0;
      m_members.emplace_back();
      const double angle = angle_of(outlines, i);
      if(image < 0 || image == i)
        add({i, angle, Eigen::Vector2d::Zero()}, outlines[i]);
      else
      {
        const double image_angle = CGAL_PI - angle - std::arg(mirrored.reflections[i]);
        const auto box = outlines[i].box(angle), image_box = outlines[image].box(image_angle);
        const double height = 0.5 * (box.low.y() + box.high.y()), image_height = 0.5 * (image_box.low.y() + image_box.high.y());
        add({i, angle, Eigen::Vector2d(-0.5 * gap - box.high.x(), -height)}, outlines[i]);
        add({image, image_angle, Eigen::Vector2d(0.5 * gap - image_box.low.x(), -image_height)}, outlines[image]);
      }
      move_to_middle();
    }
  }

  const std::vector<Chart_outline>& outlines() const { return m_outlines; }

  // The motions of the charts, by those of the units.
  Packed_charts of_charts(const Packed_charts& units) const
  {
    Packed_charts packed;
    packed.scale = units.scale;
    packed.motions.resize(m_mirrored.images.size());
    for(std::size_t i = 0; i < m_members.size(); ++i)
      for(const Member& member : m_members[i])
      {
        const Chart_motion& unit = units.motions[i];
        packed.motions[member.chart] = {unit.angle + member.angle,
                                        units.scale * (Eigen::Rotation2Dd(unit.angle) * member.shift) + unit.translation,
                                        unit.page};
      }
    return packed;
  }

private:
  struct Member
  {
    int chart;
    double angle;          // by which it is turned, before
    Eigen::Vector2d shift; // it is moved
  };

  // By which the axis gets vertical. The axis of a pair is along the border that both share, if there is much of it, and along
  // their longer side otherwise.
  double angle_of(const std::vector<Chart_outline>& outlines, int i) const
  {
    const bool is_turned = m_rotation != Chart_rotation::NONE;
    const int image = m_mirrored.images[i];
    if(image == i && is_turned)
      return 0.5 * (CGAL_PI - std::arg(m_mirrored.reflections[i]));
    if(!is_turned || (image < 0 && m_rotation != Chart_rotation::UPRIGHT))
      return 0;
    const double angle = alignment_angle(outlines[i]), quarter = CGAL_PI / 2;
    if(image < 0)
      return angle;
    constexpr double much = 0.1; // of the border
    const Eigen::Vector2d size = outlines[i].extent(angle), &seam = m_mirrored.seams[i];
    if(seam.norm() > much)
      return quarter - std::atan2(seam.y(), seam.x());
    return size.x() > size.y() ? angle + quarter : angle;
  }

  void add(const Member& member, const Chart_outline& outline)
  {
    Chart_outline& unit = m_outlines.back();
    const Eigen::Rotation2Dd turn(member.angle);
    for(const Outline_segment& s : outline.segments)
      unit.segments.push_back({turn * s.source + member.shift, turn * s.target + member.shift});
    unit.area += outline.area;
    m_members.back().push_back(member);
  }

  void move_to_middle()
  {
    Chart_outline& unit = m_outlines.back();
    Surface_mesh_parameterization::internal::Bounding_box<2> box;
    for(const Outline_segment& s : unit.segments)
      box.add(s.source);
    unit.center = Eigen::Vector2d::Zero();
    const Eigen::Vector2d middle = 0.5 * (box.low + box.high);
    for(Outline_segment& s : unit.segments)
    {
      s.source -= middle;
      s.target -= middle;
    }
    for(Member& member : m_members.back())
      member.shift -= middle;
    unit.hull = convex_hull(unit.segments);
  }

  const Mirrored_parts& m_mirrored;
  const Chart_rotation m_rotation;
  std::vector<Chart_outline> m_outlines;
  std::vector<std::vector<Member> > m_members;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_UNITS_H
