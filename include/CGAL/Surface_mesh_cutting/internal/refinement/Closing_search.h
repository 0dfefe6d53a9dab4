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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CLOSING_SEARCH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CLOSING_SEARCH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Leaf_branches.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Running_map.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A branch of a cut, or its outer part, to be closed again.
struct Closing
{
  int tip = -1;
  int new_tip = -1; // where the branch ends then, if it does not vanish
  std::vector<int> edges;
  double length = 0;
};

// Looks for the part of a cut that contributes least for its length. What closing a part costs is known
// where it was tried. Elsewhere it grows with the square of the gap that has to vanish, so that the outer
// half of a branch costs about a quarter of what all of it does.
class Closing_search
{
  static constexpr double cost_of_half = 0.25; // relative

public:
  Closing_search(const Flat_mesh& mesh, const Edge_constraints& constraints)
    : m_mesh(mesh), m_constraints(constraints)
  {}

  // Among what may cost at most `allowed_cost(length)`, the longest part of known cost, otherwise the one with
  // the smallest gap per length. The tip is -1 if there is none. Branches end at `features`, if not before;
  // those with the tip at a vertex with `is_kept` stay.
  template <typename AllowedCost>
  Closing best(const Running_map& map, const std::vector<int>& features,
               const std::vector<char>& is_kept, AllowedCost allowed_cost) const
  {
    std::vector<char> is_end(m_mesh.number_of_vertices(), 0);
    for(int v : features)
      is_end[v] = 1;
    const std::vector<double> gaps = map.gaps();
    const std::size_t open_edges = number_of_open_edges(map.cut());
    Closing best;
    std::pair<double, double> best_rank;
    for(const Leaf_branch& branch : leaf_branches(m_mesh, map.cut(), is_end))
    {
      if(is_kept[branch.vertices.front()])
        continue;
      double least_cost = 0; // about
      for(std::size_t size = number_of_free_edges(branch); size > 0; size /= 2, least_cost *= cost_of_half)
      {
        if(open_edges < size + 2) // it takes two open edges on a closed surface
          continue;
        Closing closing = outer_part(branch, size);
        const auto known = m_costs.find({closing.tip, closing.new_tip});
        if(known != m_costs.end())
          least_cost = known->second;
        if(!(least_cost < allowed_cost(closing.length)))
          continue;
        const std::pair<double, double> rank = known != m_costs.end()
                                               ? std::make_pair(0., -closing.length)
                                               : std::make_pair(1., squared_gap(branch, size, gaps) / closing.length);
        if(best.tip < 0 || rank < best_rank)
        {
          best = std::move(closing);
          best_rank = rank;
        }
        break; // the shorter ones after this one
      }
    }
    return best;
  }

  // What closing this part costs, in energy.
  void remember(const Closing& closing, double cost) { m_costs[{closing.tip, closing.new_tip}] = cost; }

private:
  // Mandatory edges, and what is between them and the rest of the cut, stay.
  std::size_t number_of_free_edges(const Leaf_branch& branch) const
  {
    return std::find_if(branch.edges.begin(), branch.edges.end(), [this](int e) { return m_constraints.mandatory[e]; }) -
           branch.edges.begin();
  }

  Closing outer_part(const Leaf_branch& branch, std::size_t size) const
  {
    Closing closing;
    closing.tip = branch.vertices.front();
    if(size < branch.edges.size())
      closing.new_tip = branch.vertices[size];
    closing.edges.assign(branch.edges.begin(), branch.edges.begin() + size);
    closing.length = total_length(m_mesh, closing.edges);
    return closing;
  }

  static double squared_gap(const Leaf_branch& branch, std::size_t size, const std::vector<double>& gaps)
  {
    double gap = 0;
    for(std::size_t i = 0; i < size; ++i)
      gap = (std::max)(gap, gaps[branch.vertices[i]]);
    return gap * gap;
  }

  std::size_t number_of_open_edges(const Cut& cut) const
  {
    std::size_t count = 0;
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
      count += cut[e] || m_mesh.is_border_edge(e);
    return count;
  }

  const Flat_mesh& m_mesh;
  const Edge_constraints& m_constraints;
  std::map<std::pair<int, int>, double> m_costs; // by former and new tip
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CLOSING_SEARCH_H
