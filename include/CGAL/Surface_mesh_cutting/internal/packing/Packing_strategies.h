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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACKING_STRATEGIES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACKING_STRATEGIES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/Grid_packing.h>
#include <CGAL/Surface_mesh_cutting/internal/packing/chart_angles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Charts in several orders, large ones first.
class Packing_strategies
{
public:
  // `has_few`: of many charts. `has_shuffled`: also orders in which neighbors changed places.
  Packing_strategies(const std::vector<Chart_outline>& outlines, bool has_few, bool has_shuffled)
  {
    for(const Chart_outline& outline : outlines)
    {
      const Eigen::Vector2d size = outline.extent(smallest_box_angle(outline));
      m_sizes.push_back({outline.area, size.prod(), size.maxCoeff()});
    }
    for(std::size_t size = 0; size < (has_few ? 1 : 3); ++size)
      for(const double height_share : {1., 0.5})
        add({sorted(size), height_share});
    if(has_shuffled)
      add_shuffled(sorted(1));
  }

  std::vector<Packing_strategy> take() { return std::move(m_strategies); }

private:
  using Sizes = std::array<double, 3>; // area, area of the smallest box, and its longer side

  std::vector<int> sorted(std::size_t size) const
  {
    std::vector<int> order(m_sizes.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return m_sizes[a][size] > m_sizes[b][size]; });
    return order;
  }

  void add_shuffled(const std::vector<int>& order)
  {
    std::minstd_rand random; // the same everywhere
    for(int round = 0; round < 10; ++round)
    {
      std::vector<int> shuffled = order;
      for(std::size_t i = 0; i + 1 < shuffled.size(); ++i)
        if(random() % 2 == 0)
          std::swap(shuffled[i], shuffled[i + 1]);
      add({shuffled, round % 2 == 0 ? 1. : 0.5});
    }
  }

  // Unless it only changes places of charts of the same sizes.
  void add(Packing_strategy strategy)
  {
    constexpr double digits = 1e6;
    std::vector<Sizes> sizes;
    for(const int i : strategy.order)
    {
      sizes.push_back(m_sizes[i]);
      for(double& size : sizes.back())
        size = std::round(digits * size);
    }
    if(m_known.insert({strategy.height_share, sizes}).second)
      m_strategies.push_back(std::move(strategy));
  }

  std::vector<Sizes> m_sizes;
  std::set<std::pair<double, std::vector<Sizes> > > m_known;
  std::vector<Packing_strategy> m_strategies;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_PACKING_STRATEGIES_H
