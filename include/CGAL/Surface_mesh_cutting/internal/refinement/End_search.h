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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_END_SEARCH_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_END_SEARCH_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Cutting_parameters.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/context/work.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Branch_removal_search.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Objective.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Slit_search.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Working_cut.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Moves the ends of a cut about: trims or prolongs a branch, lets its end slide aside, or opens a slit elsewhere
// instead. The outer part of the branch is closed, and windows around slits to other ends tell what each of them would
// gain, relative to what closing has cost. The ways between the ends move to where the map is distorted. With a bound of the
// energy, the cut stays near it, above or below.
class End_search
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double ideal = Symmetric_Dirichlet_energy::ideal;
  static constexpr double worthwhile = 0.9995; // of the cost: less is not worth another cut

public:
  // The references are kept. `keeps_tree`: see `Refinement_goal`.
  End_search(const Problem& problem, const Cutting_parameters& parameters, const Objective& objective, bool keeps_tree,
             Working_cut& cut)
    : m_problem(problem), m_mesh(problem.mesh), m_parameters(parameters), m_keeps_tree(keeps_tree), m_cut(cut),
      m_removals(problem.mesh, problem.constraints), m_slits(problem.mesh, problem.constraints),
      m_objective(objective)
  {}

  // Once for each branch, the most expensive first, of which at most such a share of the whole cut is closed.
  void move_ends(double share)
  {
    std::vector<char> is_done = m_problem.terminal_marks();
    for(int i = 0; i < maximum_number_of_ends() && m_cut.goes_on(); ++i)
    {
      const Branch_removal part
        = m_removals.most_expensive_part(m_cut.cut(), m_cut.features(), is_done, share * m_cut.cost());
      if(part.tip < 0)
        return;
      is_done[part.tip] = 1;
      m_objective.compare_with(m_cut.energy());
      Mapped_cut former = m_cut.state();
      if(move_end(part, former, is_done) && (!m_keeps_tree || reconnect(former)))
      {
        m_objective.adapt(m_cut.energy());
        keep_best();
      }
      else
        m_cut.restore(std::move(former));
    }
  }

  // Leads the cut where the map is distorted, as far as it does better so. It need not remain a tree of least cost.
  void reroute()
  {
    constexpr double shares[] = {0.05, 0.1}; // see `distortion_tree()`
    for(double share : shares)
    {
      if(!m_cut.goes_on())
        return;
      m_objective.compare_with(m_cut.energy());
      Mapped_cut former = m_cut.state();
      if(m_cut.reroute(share) && is_better_than(former))
      {
        m_objective.adapt(m_cut.energy());
        keep_best();
      }
      else
        m_cut.restore(std::move(former));
    }
  }

  // The best cut that keeps the bound and that the search has come by, if any.
  const std::optional<Mapped_cut>& best() const { return m_best; }

  // Whether the surface is not too large.
  bool can_move() const { return maximum_number_of_ends() > 0; }

private:
  void keep_best()
  {
    if(m_objective.keeps_bound(m_cut.energy()) &&
       (!m_best || m_objective.rank(m_cut.cost(), m_cut.energy()) < m_objective.rank(m_best->cost, m_best->energy())))
      m_best = m_cut.state();
  }

  int maximum_number_of_ends() const
  {
    constexpr int solves = 8; // of the whole surface, for each end
    return affordable_steps(m_mesh.number_of_faces(), solves);
  }

  // Of the map that counts, if the running map leaves a chance: its energy is known, and no higher.
  bool is_better_than(const Mapped_cut& former) const
  {
    const double limit = worthwhile * m_objective(former.cost, former.energy());
    const auto is_below = [&](double energy)
    { return m_objective.can_tell(energy) && m_objective(m_cut.cost(), energy) < limit; };
    return is_below(m_cut.running_energy()) && is_below(m_cut.energy());
  }

  // Closes the part and opens what gains most instead, if anything, which is done then. False if the former cut is
  // better.
  bool move_end(const Branch_removal& part, const Mapped_cut& former, std::vector<char>& is_done)
  {
    if(!m_cut.close(part.edges, part.tip, part.new_tip))
      return false;
    const Slit slit = best_slit(part, former.chart.energy);
    if(slit.tip >= 0)
    {
      m_cut.open(slit);
      is_done[slit.tip] = 1;
      if(part.new_tip >= 0 && cut_degrees(m_mesh, m_cut.cut())[part.new_tip] > 1)
        m_cut.drop_feature(part.new_tip); // the branch passes it
    }
    return is_better_than(former);
  }

  // The slit that lowers the objective most, by the running map; the tip is -1 if none does.
  Slit best_slit(const Branch_removal& part, double former_energy)
  {
    constexpr int number_of_far_ends = 3;
    constexpr double reach = 0.7;        // of what was closed
    constexpr double least_energy = 0.5; // relative: what estimates promise beyond is not believed
    const std::vector<char> is_excluded(m_mesh.number_of_vertices(), 0);
    std::vector<Slit> slits = m_slits.ends_about(m_cut.cut(), part.edges, part.tip,
                                                 reach * total_length(m_mesh, part.edges));
    for(Slit& far : m_slits.proposals(m_cut.cut(), m_cut.map().vertex_distortion(), is_excluded, number_of_far_ends))
      slits.push_back(std::move(far));
    if(m_parameters.has_weights)
      for(Slit& cheap : m_slits.cheap_ends_about(m_cut.cut(), part.tip, total_length(m_mesh, part.edges)))
        slits.push_back(std::move(cheap));
    slits.push_back({part.tip, part.edges});
    estimate_gains(m_cut.map(), slits);
    const double factor = gain_over_estimate(slits.back().gain, former_energy);
    slits.pop_back();
    const double least = ideal + least_energy * (former_energy - ideal);
    Slit best;
    double best_cost = m_objective(m_cut.cost(), m_cut.running_energy());
    for(Slit& slit : slits)
    {
      slit.gain *= factor;
      const double cost = m_objective(m_cut.cost() + slit.cost, (std::max)(least, m_cut.running_energy() - slit.gain));
      if(cost < best_cost)
      {
        best_cost = cost;
        best = std::move(slit);
      }
    }
    return best_cost < m_objective(m_cut.cost() + part.cost, former_energy) ? best : Slit();
  }

  // What opening the closed part again would gain is known.
  double gain_over_estimate(double estimate, double former_energy) const
  {
    constexpr double least = 0.8, largest = 3;
    if(!(estimate > 0))
      return 1;
    return (std::min)((std::max)((m_cut.running_energy() - former_energy) / estimate, least), largest);
  }

  // Takes the tree through the features instead. False if the former cut is better.
  bool reconnect(const Mapped_cut& former)
  {
    const Cut present = m_cut.cut();
    m_cut.connect(m_parameters.connection_while_refining());
    return m_cut.tree().status &&
           (m_cut.tree().cut == present || (m_cut.map_tree(infinity) && is_better_than(former)));
  }

  const Problem& m_problem;
  const Indexed_mesh& m_mesh;
  const Cutting_parameters& m_parameters;
  const bool m_keeps_tree;
  Working_cut& m_cut;
  Branch_removal_search m_removals;
  Slit_search m_slits;
  Objective m_objective;
  std::optional<Mapped_cut> m_best;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_END_SEARCH_H
