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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_GRID_PACKING_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_GRID_PACKING_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/Free_cells.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Execution.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using CGAL::internal::Graph_kernel::Execution;
using CGAL::internal::Graph_kernel::execute;

using CGAL::internal::Graph_kernel::Go_further;
using CGAL::internal::Graph_kernel::always_go_further;

// Where a chart lies on the grid of a page, and as which of its masks.
struct Grid_place
{
  int mask;
  Cell cell;
  int page = 0;
};

// A way to pack: the charts one after the other, each with the turn and at the place that is lowest.
struct Packing_strategy
{
  std::vector<int> order;
  double height_share; // what is low: at 1 the top of a chart, at 0 its bottom
};

using Chart_masks = std::vector<Chart_mask>; // for each turn of a chart one or, the second upside down, two

inline std::vector<Chart_masks> chart_masks(Execution execution, const std::vector<Chart_outline>& outlines,
                                            const std::vector<std::vector<double> >& turns, double factor, double margin,
                                            bool with_upside_down = true)
{
  std::vector<Chart_masks> masks(outlines.size());
  execute(execution, int(outlines.size()), [&](int i)
  {
    masks[i].reserve(2 * turns[i].size());
    for(const double angle : turns[i])
    {
      masks[i].emplace_back(outlines[i], angle, factor, margin);
      if(with_upside_down)
        masks[i].push_back(masks[i].back().upside_down());
    }
  });
  return masks;
}

// Fills one grid after the other with charts: each chart lies on the first one with a place for it. Many charts of similar size are
// not tried again where the ones before found no place.
class Grid_packing
{
public:
  Grid_packing(const std::vector<Chart_masks>& masks, const std::vector<Chart_outline>& outlines, int size)
    : m_masks(masks), m_outlines(outlines), m_free(size, longest_run(masks))
  {}

  // None if a chart finds no place on `most_pages` grids, or once `go_further()` does not want more.
  std::optional<std::vector<Grid_place> > pack(const Packing_strategy& strategy, int most_pages = 1,
                                               const Go_further& go_further = always_go_further)
  {
    std::vector<Grid_place> places(m_masks.size());
    std::vector<int> charts = strategy.order, left;
    for(int page = 0; page < most_pages; ++page)
    {
      const bool is_last = page + 1 == most_pages;
      for(const int i : charts)
      {
        if(!go_further())
          return std::nullopt;
        const std::optional<Grid_place> place = best_place(i, strategy.height_share);
        if(!place && is_last)
          return std::nullopt;
        if(!place)
          left.push_back(i);
        else
        {
          places[i] = {place->mask, place->cell, page};
          m_free.take(m_masks[i][place->mask], place->cell);
        }
      }
      if(left.empty())
        return places;
      if(left.size() == charts.size()) // each is larger than a page
        return std::nullopt;
      charts.swap(left);
      left.clear();
      m_free.clear();
      m_area = 0;
      m_begins.clear();
    }
    return std::nullopt;
  }

private:
  static constexpr int few = 500; // charts; below, all places are tried

  static int longest_run(const std::vector<Chart_masks>& masks)
  {
    int longest = 1;
    for(const Chart_masks& turned : masks)
      for(const Chart_mask& mask : turned)
        if(!mask.inner.empty())
          longest = (std::max)(longest, mask.inner.front().length());
    return longest;
  }

  std::optional<Grid_place> best_place(int i, double height_share)
  {
    const Chart_masks& masks = m_masks[i];
    constexpr double similar_area = 0.9;
    if(int(m_masks.size()) < few || m_outlines[i].area < similar_area * m_area || m_begins.size() < masks.size())
    {
      m_area = m_outlines[i].area;
      m_begins.assign(masks.size(), 0);
    }
    std::optional<Grid_place> best;
    double lowest = std::numeric_limits<double>::infinity();
    for(int k = 0; k < int(masks.size()); ++k)
    {
      const double height = height_share * masks[k].height;
      const int end = best ? int(std::ceil(lowest - height)) : m_free.size();
      const std::optional<Cell> cell = m_free.lowest_place(masks[k], m_begins[k], end);
      if(cell)
      {
        best = Grid_place{k, *cell};
        lowest = cell->y + height;
      }
      m_begins[k] = (std::max)(m_begins[k], cell ? cell->y : end);
    }
    return best;
  }

  const std::vector<Chart_masks>& m_masks;
  const std::vector<Chart_outline>& m_outlines;
  Free_cells m_free;
  std::vector<int> m_begins; // for each mask, the first row that is not known to be full
  double m_area = 0;         // of the charts for which that is known
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_GRID_PACKING_H
