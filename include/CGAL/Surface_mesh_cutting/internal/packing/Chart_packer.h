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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_PACKER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_PACKER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/Grid_packing.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/chart_angles.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Go_further.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using CGAL::internal::Graph_kernel::Go_further;

// A turn about the origin of the chart's outline, the scale that is common to all charts, and a translation.
struct Chart_motion
{
  double angle = 0;
  Eigen::Vector2d translation = Eigen::Vector2d::Zero();
};

struct Packed_charts
{
  double scale = 0;
  std::vector<Chart_motion> motions;
};

// Packs charts into the unit square at the largest common scale that it finds.
//
// The charts are drawn on a grid: a chart as the cells that it touches, its margin as the cells that are too close to
// it. Where no chart touches the margin of another one, distances are kept for sure, and not only between cells. The
// scale grows as long as one of several strategies finds places for all charts; a coarse grid is used first.
template <typename ConcurrencyTag>
class Chart_packer
{
public:
  // The sum of the areas of the outlines is about one. `margin`: between charts and to the border of the square.
  Chart_packer(std::vector<Chart_outline> outlines, double margin, Go_further go_further)
    : m_outlines(std::move(outlines)), m_margin(margin), m_go_further(std::move(go_further))
  {}

  // None if no scale was found at which the margins leave room. A run that is ended keeps what it found first.
  std::optional<Packed_charts> pack()
  {
    if(!(side() > 0))
      return std::nullopt;
    if(m_outlines.size() == 1)
      return pack_one();
    choose_turns();
    choose_strategies();
    const bool are_many = int(m_outlines.size()) > many;
    const int coarse = are_many ? 1024 : 512, fine = 2048;
    if(!find_first(coarse))
      return std::nullopt;
    grow(coarse, 1.08, are_many ? 1.02 : 1.004);
    grow(fine, 1.03, are_many ? 1.005 : 1.0015);
    return m_best;
  }

private:
  static constexpr int several = 100, many = 1000; // charts

  // Of the square inside of the margin.
  double side() const { return 1 - 2 * m_margin; }

  std::optional<Packed_charts> pack_one() const
  {
    constexpr double rounding = 1e-6;
    const Chart_outline& outline = m_outlines.front();
    Packed_charts packed;
    packed.motions.resize(1);
    Chart_motion& motion = packed.motions.front();
    motion.angle = tightest_square_angle(outline);
    packed.scale = side() * (1 - rounding) / outline.extent(motion.angle).maxCoeff();
    const double c = std::cos(motion.angle), s = std::sin(motion.angle);
    Surface_mesh_parameterization::internal::Bounding_box<2> box;
    for(const Eigen::Vector2d& p : outline.hull)
      box.add(Eigen::Vector2d(c * p.x() - s * p.y(), s * p.x() + c * p.y()));
    motion.translation = Eigen::Vector2d::Constant(0.5) - 0.5 * packed.scale * (box.low + box.high);
    return packed;
  }

  // Sides of the smallest box along the axes, and turns between.
  void choose_turns()
  {
    const int number = int(m_outlines.size()) <= several ? 16 : int(m_outlines.size()) <= many ? 8 : 4;
    m_turns.resize(m_outlines.size());
    CGAL::internal::Graph_kernel::for_each_index<ConcurrencyTag>(int(m_outlines.size()), [&](int i)
    {
      const double first = smallest_box_angle(m_outlines[i]);
      // Quarter turns come first, that with the chart lying on its side before that with it upright.
      const Eigen::Vector2d size = m_outlines[i].extent(first);
      const double quarter = CGAL_PI / 2, start = size.x() >= size.y() ? first : first + quarter;
      for(int between = 0; between < number / 4; ++between)
        for(const int quarters : {0, 2, 1, 3})
          m_turns[i].push_back(start + quarter * (quarters + 4. * between / number));
    });
  }

  void choose_strategies()
  {
    const auto sorted = [&](auto size_of)
    {
      std::vector<double> sizes;
      for(const Chart_outline& outline : m_outlines)
        sizes.push_back(size_of(outline));
      std::vector<int> order(m_outlines.size());
      std::iota(order.begin(), order.end(), 0);
      std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return sizes[a] > sizes[b]; });
      return order;
    };
    const std::vector<int> by_area = sorted([](const Chart_outline& o) { return o.area; });
    const std::vector<int> by_box = sorted([](const Chart_outline& o) { return o.extent(smallest_box_angle(o)).prod(); });
    const std::vector<int> by_length
      = sorted([](const Chart_outline& o) { return o.extent(smallest_box_angle(o)).maxCoeff(); });
    for(const std::vector<int>* order : {&by_area, &by_box, &by_length})
      for(const double height_share : {1., 0.5})
        m_strategies.push_back({*order, height_share});
    if(int(m_outlines.size()) > many)
      m_strategies.resize(2);
    else if(int(m_outlines.size()) <= several)
      add_shuffled(by_box);
  }

  // Orders in which neighbors changed places.
  void add_shuffled(const std::vector<int>& order)
  {
    std::minstd_rand random; // the same everywhere
    for(int round = 0; round < 10; ++round)
    {
      std::vector<int> shuffled = order;
      for(std::size_t i = 0; i + 1 < shuffled.size(); ++i)
        if(random() % 2 == 0)
          std::swap(shuffled[i], shuffled[i + 1]);
      m_strategies.push_back({shuffled, round % 2 == 0 ? 1. : 0.5});
    }
  }

  // Whether there is any scale at which all charts fit.
  bool find_first(int resolution)
  {
    constexpr double hopeful_fill = 0.75, shrinking = 0.93, hopeless = 1e-3;
    double longest = 0, area = 0;
    for(const Chart_outline& outline : m_outlines)
    {
      longest = (std::max)(longest, outline.extent(tightest_square_angle(outline)).maxCoeff());
      area += outline.area;
    }
    const double first = side() * (std::min)(1 / longest, std::sqrt(hopeful_fill / area));
    for(double scale = first; scale > hopeless * first; scale *= shrinking)
      if(try_scale(resolution, scale))
        return true;
    return false;
  }

  // Scales up by `factor` as long as that succeeds, then by less, until steps are below `finest`.
  void grow(int resolution, double factor, double finest)
  {
    while(factor > finest && m_go_further())
      if(!try_scale(resolution, m_best->scale * factor))
        factor = std::sqrt(factor);
  }

  // The first strategy that succeeds counts; those that fail where others succeed are given up.
  bool try_scale(int resolution, double scale)
  {
    const int size = int(std::floor(side() * resolution));
    if(size < 1)
      return false;
    const std::vector<Chart_masks> masks
      = chart_masks<ConcurrencyTag>(m_outlines, m_turns, scale * resolution, m_margin * resolution);
    using Places = std::optional<std::vector<Grid_place> >;
    std::vector<Places> found(m_strategies.size());
    CGAL::internal::Graph_kernel::for_each_index<ConcurrencyTag>(int(m_strategies.size()), [&](int i)
    {
      if(!m_best || m_go_further())
        found[i] = Grid_packing(masks, m_outlines, size).pack(m_strategies[i]);
    });
    std::vector<Packing_strategy> successful;
    for(std::size_t i = 0; i < found.size(); ++i)
      if(found[i])
      {
        if(successful.empty())
          m_best = to_motions(*found[i], masks, resolution, scale);
        successful.push_back(std::move(m_strategies[i]));
      }
    if(successful.empty())
      return false;
    m_strategies = std::move(successful);
    return true;
  }

  Packed_charts to_motions(const std::vector<Grid_place>& places, const std::vector<Chart_masks>& masks, int resolution,
                           double scale) const
  {
    Packed_charts packed;
    packed.scale = scale;
    for(std::size_t i = 0; i < places.size(); ++i)
    {
      const Grid_place& place = places[i];
      const Eigen::Vector2d origin = masks[i][place.turn].origin + Eigen::Vector2d(place.cell.x, place.cell.y);
      packed.motions.push_back({m_turns[i][place.turn], Eigen::Vector2d::Constant(m_margin) + origin / resolution});
    }
    return packed;
  }

  const std::vector<Chart_outline> m_outlines;
  const double m_margin;
  const Go_further m_go_further;
  std::vector<std::vector<double> > m_turns; // angles
  std::vector<Packing_strategy> m_strategies;
  std::optional<Packed_charts> m_best;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_PACKER_H
