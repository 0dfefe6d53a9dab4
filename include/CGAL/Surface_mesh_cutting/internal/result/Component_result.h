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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_COMPONENT_RESULT_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_COMPONENT_RESULT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Trade_off.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Objective.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// What is known about one component of the surface after a run.
struct Component_result
{
  Indexed_status status;
  bool has_cut = false, has_map = false; // a stopped run may have both
  int number_of_candidates = 0, number_of_auxiliary_points = 0;
  std::vector<int> features; // after refinement
  Cut cut;
  double length = 0, cost = 0, lower_bound = 0;
  double loss_for_room = 0; // of the objective, relative: so much better the map could be if it might overlap
  bool is_optimal = false;
  bool is_tree_proven = false; // shortest through its points: the tree that the cut, if refined, was made from
  Corner_table chart;
  std::vector<Eigen::Vector2d> uv;
  double energy = 0;
  std::vector<Trade_off> trade_offs; // of all cuts that were mapped

  // See `Objective::rank()`; last without a map.
  std::pair<double, double> rank(const Objective& objective) const
  {
    return objective.rank(cost, has_map ? energy : std::numeric_limits<double>::infinity());
  }

  void add(const std::vector<Trade_off>& others)
  {
    trade_offs.insert(trade_offs.end(), others.begin(), others.end());
  }

  // From cheap to expensive, with the result. What claims to be better than it on both counts was measured on a
  // coarser version and does not hold. Costs that differ by rounding are the same: mirrored cuts have them.
  void keep_undominated_trade_offs()
  {
    constexpr double rounding = 1e-12;
    const auto is_cheaper = [](double a, double b) { return a < b * (1 - rounding); };
    std::vector<Trade_off> all;
    for(const Trade_off& t : trade_offs)
      if(is_cheaper(cost, t.cut_cost) || t.average_distortion > energy)
        all.push_back(t);
    all.push_back({length, cost, energy});
    std::sort(all.begin(), all.end(), [](const Trade_off& a, const Trade_off& b)
              {
                return a.cut_cost != b.cut_cost ? a.cut_cost < b.cut_cost : a.average_distortion < b.average_distortion;
              });
    trade_offs.clear();
    for(const Trade_off& t : all)
    {
      if(!trade_offs.empty() && t.average_distortion >= trade_offs.back().average_distortion)
        continue;
      if(!trade_offs.empty() && !is_cheaper(trade_offs.back().cut_cost, t.cut_cost))
        trade_offs.pop_back();
      trade_offs.push_back(t);
    }
  }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RESULT_COMPONENT_RESULT_H
