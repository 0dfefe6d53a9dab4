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

#include <CGAL/Surface_mesh_cutting/Chart_rotation.h>
#include <CGAL/Surface_mesh_cutting/Effort.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Run_control.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Chart_boxes.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Grid_packing.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Off_grid_growth.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Packed_charts.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/Packing_strategies.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/chart_angles.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Execution.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The pages that charts may be packed into, and the largest common scale.
struct Page_demand
{
  int most_pages = 1;
  double most_scale = std::numeric_limits<double>::infinity();
};

// Packs charts into the unit squares of pages at the largest common scale that it finds.
//
// The charts are drawn on a grid: a chart as the cells that it touches, its margin as the cells that are too close to
// it. Where no chart touches the margin of another one, distances are kept for sure, and not only between cells. The
// scale grows as long as one of several strategies finds places for all charts. Coarse grids are used first; after them,
// still finer ones if there are many charts; up to a thousand on one page then grow off any grid.
class Chart_packer
{
public:
  // The sum of the areas of the outlines is about one. `margin`: between charts and to the border of the square.
  // `rotation` is a decided one. References are kept.
  Chart_packer(const std::vector<Chart_outline>& outlines, double margin, Effort effort, Chart_rotation rotation,
               Execution execution, Run_control& control, const Page_demand& demand = {})
    : m_outlines(outlines), m_margin(margin), m_effort(effort), m_rotation(rotation), m_execution(execution),
      m_control(control), m_demand(demand)
  {}

  // None if no scale was found at which the margins leave room. A run that is ended keeps what it found first.
  std::optional<Packed_charts> pack()
  {
    pack_coarsely();
    return refine();
  }

  // At the largest scale that is allowed, on as few pages as it finds; none if that is too large for some chart, or for
  // so many pages.
  std::optional<Packed_charts> pack_at_most_scale()
  {
    m_control.report(Phase::PACK, 0);
    if(!(m_demand.most_scale <= largest_scale()))
      return std::nullopt;
    if(m_outlines.size() == 1)
      return pack_one();
    prepare();
    std::optional<Packed_charts> boxes = chart_boxes().pack_at(m_demand.most_scale);
    if(boxes && boxes->number_of_pages() == 1)
      return boxes;
    try_scale(are_many() ? 4096 : 2048, m_demand.most_scale);
    return m_best && !(boxes && boxes->number_of_pages() < m_best->number_of_pages()) ? m_best : boxes;
  }

  // At which some chart alone fills the square, or all of them would fill the pages without a gap.
  double largest_scale() const { return (std::min)(side() / longest_side(), scale_of_areas()); }

  // The first part, after which packings with different rotations can be compared: as boxes, and on a coarse grid.
  std::optional<Packed_charts> pack_coarsely()
  {
    m_control.report(Phase::PACK, 0);
    if(!(side() > 0))
      return std::nullopt;
    if(m_outlines.size() == 1)
      return m_best = pack_one();
    prepare();
    Chart_boxes boxes = chart_boxes();
    if(!m_boxes)
      m_boxes = boxes.pack(m_limit, m_control);
    m_are_done = m_boxes && are_boxes_enough(boxes, m_boxes->scale);
    if(m_are_done)
      return m_best = m_boxes;
    if(find_first(coarsest()))
      grow(coarsest(), 1.08, coarsest() < finest() ? 1.02 : 1.004, true);
    return m_best ? m_best : m_boxes;
  }

  // Those that another packer, which may turn charts by quarters, too, has found need not be found again.
  void take_boxes_of(const Chart_packer& other) { m_boxes = other.m_boxes; }

  // The second part: on finer grids, and off any grid.
  std::optional<Packed_charts> refine()
  {
    if(m_are_done || m_outlines.size() == 1)
      return m_best;
    for(int resolution = 2 * coarsest(); m_best && resolution <= finest(); resolution *= 2)
    {
      m_strategies.resize((std::min)(m_strategies.size(), strategies_on_fine_grids));
      m_control.report(Phase::PACK, double(resolution) / (2 * finest())); // each grid takes about as long as all before
      grow(resolution, 1.03, resolution < finest() ? 1.02 : 1.004, false);
    }
    if(m_boxes && !(m_best && m_best->scale > m_boxes->scale))
      m_best = m_boxes;
    if(m_best && m_demand.most_pages == 1 && !are_many())
      push_apart();
    return m_best;
  }

private:
  static constexpr int several = 100, many = 1000; // charts
  static constexpr std::size_t strategies_on_fine_grids = 2;

  bool are_many() const { return int(m_outlines.size()) > many; }

  void prepare()
  {
    choose_turns();
    choose_strategies();
    find_limit();
  }

  // Cells along a side. On the finest grid, charts of average size are some dozen cells wide; the time to place one grows with
  // its cells.
  int coarsest() const { return are_many() ? 1024 : 512; }
  int finest() const
  {
    const bool are_few = int(m_outlines.size()) <= several && m_demand.most_pages == 1;
    return are_few ? 512 : are_many() ? 4096 : 1024;
  }

  // The turn, of those allowed, after which the smallest square around the chart is smallest.
  double smallest_angle(const Chart_outline& outline) const
  {
    return m_rotation == Chart_rotation::ANY ? tightest_square_angle(outline)
         : m_rotation == Chart_rotation::QUARTER ? alignment_angle(outline) : 0;
  }

  double smallest_square(const Chart_outline& outline) const
  {
    return outline.extent(smallest_angle(outline)).maxCoeff();
  }

  double longest_side() const
  {
    double longest = 0;
    for(const Chart_outline& outline : m_outlines)
      longest = (std::max)(longest, smallest_square(outline));
    return longest;
  }

  double scale_of_areas() const { return largest_scale_of_areas(m_outlines, m_margin, m_demand.most_pages); }

  Chart_boxes chart_boxes() const
  {
    std::vector<double> angles;
    for(const Chart_outline& outline : m_outlines)
      angles.push_back(m_rotation == Chart_rotation::NONE ? 0 : alignment_angle(outline));
    return Chart_boxes(m_outlines, std::move(angles), m_rotation != Chart_rotation::NONE, m_margin, m_demand.most_pages);
  }

  // Whether it is not worth while to look for anything better than packed boxes. Where they leave much room, a few turned
  // squares may be better.
  bool are_boxes_enough(const Chart_boxes& boxes, double scale) const
  {
    constexpr double good_share = 0.8; // of the area that any packing can fill
    const double share = scale / m_limit;
    return share * share >= good_share || (boxes.are_full() && m_rotation != Chart_rotation::ANY);
  }

  // Of the square inside of the margin.
  double side() const { return 1 - 2 * m_margin; }

  std::optional<Packed_charts> pack_one() const
  {
    constexpr double rounding = 1e-6;
    const Chart_outline& outline = m_outlines.front();
    Packed_charts packed;
    packed.motions.resize(1);
    Chart_motion& motion = packed.motions.front();
    motion.angle = smallest_angle(outline);
    packed.scale = (std::min)(side() * (1 - rounding) / outline.extent(motion.angle).maxCoeff(), m_demand.most_scale);
    const auto box = outline.box(motion.angle);
    motion.translation = Eigen::Vector2d::Constant(0.5) - 0.5 * packed.scale * (box.low + box.high);
    return packed;
  }

  // Sides of the smallest box along the axes, and turns between, unless only some are allowed; all up to half a turn.
  void choose_turns()
  {
    if(m_rotation == Chart_rotation::NONE)
    {
      m_turns.assign(m_outlines.size(), {0.});
      return;
    }
    const int number = m_rotation == Chart_rotation::QUARTER ? 2 : int(m_outlines.size()) <= several ? 8 : are_many() ? 2 : 4;
    m_turns.resize(m_outlines.size());
    execute(m_execution, int(m_outlines.size()), [&](int i)
    {
      const double first = m_rotation == Chart_rotation::QUARTER ? alignment_angle(m_outlines[i])
                                                                 : smallest_box_angle(m_outlines[i]);
      // Quarter turns come first, that with the chart lying on its side before that with it upright.
      const Eigen::Vector2d size = m_outlines[i].extent(first);
      const double quarter = CGAL_PI / 2, start = size.x() >= size.y() ? first : first + quarter;
      for(int between = 0; between < number / 2; ++between)
        for(int quarters = 0; quarters < 2; ++quarters)
          m_turns[i].push_back(start + quarter * (quarters + 2. * between / number));
    });
  }

  void choose_strategies()
  {
    const bool has_shuffled = int(m_outlines.size()) <= several && m_effort != Effort::FAST;
    m_strategies = Packing_strategies(m_outlines, are_many(), has_shuffled).take();
  }

  // Limits the scale. The chart that fills the square first may lie as it has to then.
  void find_limit()
  {
    m_limit = (std::min)(largest_scale(), m_demand.most_scale);
    if(m_rotation != Chart_rotation::ANY)
      return;
    const double longest = longest_side();
    std::size_t limiting = 0;
    while(smallest_square(m_outlines[limiting]) < longest)
      ++limiting;
    for(int quarters = 0; quarters < 2; ++quarters)
      m_turns[limiting].push_back(tightest_square_angle(m_outlines[limiting]) + quarters * CGAL_PI / 2);
  }

  // Whether there is any scale at which all charts fit.
  bool find_first(int resolution)
  {
    constexpr double shrinking = 0.93, quick_shrinking = 0.8, hopeless = 1e-3;
    const double first = hopeful_scale();
    for(double scale = first; scale > hopeless * first;)
    {
      if(try_scale(resolution, scale))
        return true;
      const bool is_in_haste = !m_control.go_further();
      if(is_in_haste)
        m_strategies.resize(1);
      scale *= is_in_haste ? quick_shrinking : shrinking;
    }
    return false;
  }

  // At which the charts, each with half of the margin around, leave as much room as they may be expected to.
  double hopeful_scale() const
  {
    constexpr double hopeful_fill = 0.75;
    double area = 0, perimeter = 0; // of the margins, not more than that of the hulls
    for(const Chart_outline& outline : m_outlines)
    {
      area += outline.area;
      for(std::size_t i = 0; i < outline.hull.size(); ++i)
        perimeter += (outline.hull[(i + 1) % outline.hull.size()] - outline.hull[i]).norm();
    }
    const double room = hopeful_fill * m_demand.most_pages * (side() + m_margin) * (side() + m_margin);
    const double scale = scale_that_fills(room, area, perimeter, m_margin, m_outlines.size());
    return (std::min)(m_limit, scale > 0 ? scale : side() * std::sqrt(hopeful_fill / area));
  }

  // Scales up by `factor`, while that succeeds again and again if it `does_repeat`, and then by less, until steps are below
  // `finest`.
  void grow(int resolution, double factor, double finest, bool does_repeat)
  {
    double failed = 0;
    while(factor > finest && m_control.go_further())
    {
      const double scale = m_best->scale * factor;
      const bool is_known = std::abs(scale - failed) < 1e-9 * scale;
      const bool is_larger = scale <= m_limit && !is_known && try_scale(resolution, scale);
      if(!is_larger)
        failed = scale;
      if(!is_larger || !does_repeat)
        factor = std::sqrt(factor);
    }
  }

  // The charts leave the grid.
  void push_apart()
  {
    std::vector<std::optional<Rigid_chart> > built(m_outlines.size());
    const double reach = Off_grid_growth::reach(m_margin, m_best->scale);
    execute(m_execution, int(m_outlines.size()), [&](int i)
    { built[i].emplace(simplified_outline(m_outlines[i].segments, Off_grid_growth::tolerance), reach, m_rotation); });
    std::vector<Rigid_chart> charts;
    for(std::optional<Rigid_chart>& chart : built)
      charts.push_back(std::move(*chart));
    m_best = Off_grid_growth(charts, m_margin, m_limit, m_effort, m_control).grow(std::move(*m_best));
  }

  // The first strategy that succeeds with the fewest pages counts; those that fail where others succeed are given up.
  bool try_scale(int resolution, double scale)
  {
    const int size = int(std::floor(side() * resolution));
    if(size < 1)
      return false;
    const Go_further go_further = m_best ? Go_further(m_control) : always_go_further; // the first place is needed in any case
    const std::vector<Chart_masks> masks
      = chart_masks(m_execution, m_outlines, m_turns, scale * resolution, m_margin * resolution,
                                    m_rotation != Chart_rotation::NONE);
    using Places = std::optional<std::vector<Grid_place> >;
    std::vector<Places> found(m_strategies.size());
    execute(m_execution, int(m_strategies.size()), [&](int i)
    {
      if(go_further())
        found[i] = Grid_packing(masks, m_outlines, size).pack(m_strategies[i], m_demand.most_pages, go_further);
    });
    std::vector<Packing_strategy> successful;
    std::optional<Packed_charts> best; // on the fewest pages
    for(std::size_t i = 0; i < found.size(); ++i)
      if(found[i])
      {
        Packed_charts packed = to_motions(*found[i], masks, resolution, scale);
        if(!best || packed.number_of_pages() < best->number_of_pages())
          best = std::move(packed);
        successful.push_back(std::move(m_strategies[i]));
      }
    if(!best)
      return false;
    m_best = std::move(best);
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
      const Chart_mask& mask = masks[i][place.mask];
      const Eigen::Vector2d origin = mask.origin + Eigen::Vector2d(place.cell.x, place.cell.y);
      packed.motions.push_back({mask.angle, Eigen::Vector2d::Constant(m_margin) + origin / resolution, place.page});
    }
    return packed;
  }

  const std::vector<Chart_outline>& m_outlines;
  const double m_margin;
  const Effort m_effort;
  const Chart_rotation m_rotation;
  const Execution m_execution;
  Run_control& m_control;
  const Page_demand m_demand;
  std::vector<std::vector<double> > m_turns; // angles
  std::vector<Packing_strategy> m_strategies;
  double m_limit = 0; // of the scale
  std::optional<Packed_charts> m_boxes;
  bool m_are_done = false; // as boxes
  std::optional<Packed_charts> m_best;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_CHART_PACKER_H
