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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_BRANCH_REMOVAL_SEARCH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_BRANCH_REMOVAL_SEARCH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/input/Edge_constraints.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Leaf_branches.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Incremental_parameterization.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A branch of a cut, or its outer part, to be closed again.
struct Branch_removal
{
  int tip = -1;
  int new_tip = -1; // where the branch ends then, if it does not vanish
  std::vector<int> edges;
  double cost = 0; // saved
};

// Looks for the part of a cut that contributes least for its cost. What closing a part costs is known
// where it was tried. Elsewhere it grows with the square of the opening that has to vanish, so that the outer
// half of a branch costs about a quarter of what all of it does.
class Branch_removal_search
{
  static constexpr double energy_of_half = 0.25; // relative

public:
  Branch_removal_search(const Indexed_mesh& mesh, const Edge_constraints& constraints)
    : m_mesh(mesh), m_constraints(constraints)
  {}

  // Among what may cost at most `allowed_energy(cost)`, the most expensive part of known energy, otherwise the one with
  // the smallest opening per cost. The tip is -1 if there is none. Branches end at `features`, if not before;
  // those with the tip at a vertex with `is_kept` stay.
  template <typename AllowedEnergy>
  Branch_removal best(const Incremental_parameterization& map, const std::vector<int>& features,
               const std::vector<char>& is_kept, AllowedEnergy allowed_energy) const
  {
    std::vector<char> is_end(m_mesh.number_of_vertices(), 0);
    for(int v : features)
      is_end[v] = 1;
    const std::vector<double> seam_openings = map.state().seam_openings(m_mesh.number_of_vertices());
    const std::size_t open_edges = number_of_open_edges(map.cut());
    Branch_removal best;
    std::pair<double, double> best_rank;
    for(const Leaf_branch& branch : leaf_branches(m_mesh, map.cut(), is_end))
    {
      if(is_kept[branch.vertices.front()])
        continue;
      double least_energy = 0; // about
      for(std::size_t size = number_of_free_edges(branch); size > 0; size /= 2, least_energy *= energy_of_half)
      {
        if(open_edges < size + 2) // it takes two open edges on a closed surface
          continue;
        Branch_removal removal = outer_part(branch, size);
        const auto known = m_energies.find({removal.tip, removal.new_tip});
        if(known != m_energies.end())
          least_energy = known->second;
        if(!(least_energy < allowed_energy(removal.cost)))
          continue;
        const std::pair<double, double> rank = known != m_energies.end()
                                               ? std::make_pair(0., -removal.cost)
                                               : std::make_pair(1., squared_opening(branch, size, seam_openings) / removal.cost);
        if(best.tip < 0 || rank < best_rank)
        {
          best = std::move(removal);
          best_rank = rank;
        }
        break; // the shorter ones after this one
      }
    }
    return best;
  }

  // Whether any part of a branch can be closed, whatever energy that takes; those with the tip at a vertex with `is_kept`
  // stay.
  bool exist(const Cut& cut, const std::vector<char>& is_kept) const
  {
    const std::vector<Leaf_branch> branches = leaf_branches(m_mesh, cut, is_kept);
    return std::any_of(branches.begin(), branches.end(), [&](const Leaf_branch& branch)
                       { return !is_kept[branch.vertices.front()] && number_of_free_edges(branch) > 0; });
  }

  // The most expensive of the outer parts of branches that cost at most `limit`, or are an edge, or a whole branch that
  // costs little more; of those that end at a vertex with `is_excluded`, none.
  Branch_removal most_expensive_part(const Cut& cut, const std::vector<int>& features,
                                     const std::vector<char>& is_excluded, double limit) const
  {
    constexpr double little_more = 1.5;
    std::vector<char> is_end(m_mesh.number_of_vertices(), 0);
    for(int v : features)
      is_end[v] = 1;
    const std::size_t open_edges = number_of_open_edges(cut);
    Branch_removal best;
    for(const Leaf_branch& branch : leaf_branches(m_mesh, cut, is_end))
    {
      const std::size_t free_edges = number_of_free_edges(branch);
      if(is_excluded[branch.vertices.front()] || free_edges == 0)
        continue;
      Branch_removal part = outer_part(branch, free_edges);
      if(part.cost > little_more * limit)
        part = outer_part(branch, number_of_edges_within(branch, limit));
      if(part.cost > best.cost && open_edges >= part.edges.size() + 2)
        best = std::move(part);
    }
    return best;
  }

  // What closing this part costs, in energy.
  void remember(const Branch_removal& removal, double energy) { m_energies[{removal.tip, removal.new_tip}] = energy; }

private:
  // Mandatory edges, and what is between them and the rest of the cut, stay.
  std::size_t number_of_free_edges(const Leaf_branch& branch) const
  {
    return std::find_if(branch.edges.begin(), branch.edges.end(), [this](int e) { return m_constraints.mandatory[e]; }) -
           branch.edges.begin();
  }

  Branch_removal outer_part(const Leaf_branch& branch, std::size_t size) const
  {
    Branch_removal removal;
    removal.tip = branch.vertices.front();
    if(size < branch.edges.size())
      removal.new_tip = branch.vertices[size];
    removal.edges.assign(branch.edges.begin(), branch.edges.begin() + size);
    removal.cost = total_cost(m_constraints, removal.edges);
    return removal;
  }

  // From the tip, at least one.
  std::size_t number_of_edges_within(const Leaf_branch& branch, double cost) const
  {
    std::size_t size = 0;
    for(double sum = 0; size < branch.edges.size() && sum + m_constraints.weights[branch.edges[size]] <= cost; ++size)
      sum += m_constraints.weights[branch.edges[size]];
    return (std::max)(size, std::size_t(1));
  }

  static double squared_opening(const Leaf_branch& branch, std::size_t size, const std::vector<double>& seam_openings)
  {
    double opening = 0;
    for(std::size_t i = 0; i < size; ++i)
      opening = (std::max)(opening, seam_openings[branch.vertices[i]]);
    return opening * opening;
  }

  std::size_t number_of_open_edges(const Cut& cut) const
  {
    std::size_t count = 0;
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
      count += cut[e] || m_mesh.is_border_edge(e);
    return count;
  }

  const Indexed_mesh& m_mesh;
  const Edge_constraints& m_constraints;
  // By former and new tip. Where a branch comes to fork elsewhere, that of its former whole is a guess for the new one.
  std::map<std::pair<int, int>, double> m_energies;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_BRANCH_REMOVAL_SEARCH_H
