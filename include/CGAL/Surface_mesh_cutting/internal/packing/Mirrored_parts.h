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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_MIRRORED_PARTS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_MIRRORED_PARTS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using Surface_mesh_parameterization::internal::Connected_parts;
using Surface_mesh_parameterization::internal::Corner_table;

// How the charts of a layout lie that are mirror images of each other, or of themselves.
struct Mirrored_parts
{
  std::vector<int> images; // of each chart: another one, or itself; -1 if it is not mirrored
  // The reflection of the plane that takes a chart to its image, once both have their middle at the origin: it maps a complex
  // number z to this one, of length 1, times the conjugate of z.
  std::vector<std::complex<double> > reflections;
  // The sum of the border that each chart shares with its image, the chart on the left, over the length of its border.
  std::vector<Eigen::Vector2d> seams;

  // `vertex_images`: per vertex of `chart`, or empty.
  Mirrored_parts(const Corner_table& chart, const Connected_parts& parts, const std::vector<Eigen::Vector2d>& uv,
                 const std::vector<int>& vertex_images)
    : images(parts.number, -1), reflections(parts.number, 1), seams(parts.number, Eigen::Vector2d::Zero())
  {
    if(vertex_images.empty())
      return;
    const std::vector<int> part = Surface_mesh_parameterization::internal::parts_of_vertices(chart, parts);
    find_reflections(part, uv, vertex_images);
    const auto is_shared = [&](int v)
    { return part[vertex_images[v]] != part[v] && chart.origins()[vertex_images[v]] == chart.origins()[v]; };
    std::vector<double> perimeters(parts.number, 0);
    for(int h = 0; h < int(chart.opposites().size()); ++h)
      if(chart.is_border(h))
      {
        const Eigen::Vector2d along = uv[chart.target(h)] - uv[chart.source(h)];
        perimeters[parts.part[h / 3]] += along.norm();
        if(is_shared(chart.source(h)) && is_shared(chart.target(h)))
          seams[parts.part[h / 3]] += along;
      }
    for(std::size_t i = 0; i < seams.size(); ++i)
      if(perimeters[i] > 0)
        seams[i] /= perimeters[i];
  }

private:
  // By least squares. What is far from being mirrored in the plane counts as not mirrored.
  void find_reflections(const std::vector<int>& part, const std::vector<Eigen::Vector2d>& uv,
                        const std::vector<int>& vertex_images)
  {
    constexpr double least_share = 0.5; // of the sum of squares that mirrored charts have
    const auto number = images.size();
    std::vector<Eigen::Vector2d> middles(number, Eigen::Vector2d::Zero());
    std::vector<double> counts(number, 0), squares(number, 0);
    for(std::size_t v = 0; v < uv.size(); ++v)
      if(part[v] >= 0)
      {
        images[part[v]] = part[vertex_images[v]];
        middles[part[v]] += uv[v];
        counts[part[v]] += 1;
      }
    for(std::size_t i = 0; i < number; ++i)
      middles[i] /= counts[i];
    std::vector<std::complex<double> > sums(number, 0);
    for(std::size_t v = 0; v < uv.size(); ++v)
      if(const int i = part[v]; i >= 0)
      {
        const Eigen::Vector2d p = uv[v] - middles[i], q = uv[vertex_images[v]] - middles[images[i]];
        sums[i] += std::complex<double>(p.x(), p.y()) * std::complex<double>(q.x(), q.y());
        squares[i] += 0.5 * (p.squaredNorm() + q.squaredNorm());
      }
    for(std::size_t i = 0; i < number; ++i)
      if(std::abs(sums[i]) > least_share * squares[i])
        reflections[i] = sums[i] / std::abs(sums[i]);
      else
        images[i] = -1;
    for(std::size_t i = 0; i < number; ++i)
      if(images[i] >= 0 && images[images[i]] < 0) // by rounding
        images[i] = -1;
  }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_MIRRORED_PARTS_H
