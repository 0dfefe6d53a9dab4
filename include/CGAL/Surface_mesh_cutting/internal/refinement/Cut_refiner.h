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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CUT_REFINER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CUT_REFINER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/connection/Initial_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/context/work.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Branch_removal_search.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/End_search.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Objective.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Slit_search.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Working_cut.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The objective of refinement, and how much work it may take.
struct Refinement_goal
{
  Objective objective;
  int number_of_solves = 0; // at most, for shortening; some more move ends
  // Whether a tree through the features has to remain one: where only they are handed on, a cut that is bent otherwise
  // would be lost.
  bool keeps_tree = false;
  int rounds_of_moved_ends = 0; // at most
};

// Refines a cut: connects features, opens slits, closes branches, and moves ends, as long as that lowers the objective.
class Cut_refiner
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr int share = 3; // one in so many solves shortens before ends move, and one after

public:
  // The references are kept. What is mandatory, and the terminals, stay on the cut.
  Cut_refiner(const Problem& problem, const Context& context)
    : m_problem(problem), m_mesh(problem.mesh), m_parameters(context.parameters),
      m_slits(problem.mesh, problem.constraints),
      m_removals(problem.mesh, problem.constraints), m_cut(problem, context)
  {}

  // Connects the features; call first. A tree that will not matter gets as little effort as one on the way to
  // the final tree.
  Indexed_status connect(std::vector<int> features, bool matters = true)
  {
    m_cut.connect(std::move(features), matters ? m_parameters.connection : m_parameters.connection_while_refining());
    return m_cut.tree().status;
  }

  // Takes a cut to a disk instead, on which the terminals are, and maps it. False as for map().
  bool start(const Cut& cut)
  {
    std::vector<int> features = ends_and_forks(m_mesh, cut);
    CGAL::internal::Graph_kernel::add_unique(m_problem.terminals, features);
    return m_cut.start(std::move(features), cut);
  }

  // Maps the surface opened along the connected cut; call after connect(). False if no flip-free map was
  // found or the run was stopped.
  bool map() { return m_cut.map_tree(infinity); }

  // The same with another precision.
  bool map(double precision) { return m_cut.map_tree(infinity, precision); }

  // Replaces the tree by another cut through the features, and its map.
  void replace_tree(Open_chart chart) { m_cut.replace(std::move(chart)); }

  const Working_cut& cut() const { return m_cut; }

  // Opens slits and shortens with a part of the solves: what remains is worth it only for the most promising cut. False if
  // the bound is missed.
  bool prepare(const Refinement_goal& goal)
  {
    if(!open_slits(goal.objective))
      return false;
    shorten(goal, goal.number_of_solves / share);
    return true;
  }

  // Does all else that the goal allows; call after prepare().
  void refine(const Refinement_goal& goal)
  {
    constexpr int least_solves = 8; // after ends moved, which leaves some room below the bound
    int solves = goal.number_of_solves;
    if(goal.rounds_of_moved_ends > 0 && goal.objective.keeps_bound(m_cut.energy()))
    {
      move_ends(goal);
      solves = (std::min)(solves, (std::max)(least_solves, solves / share));
    }
    shorten(goal, solves);
  }

  // Opens slits until the bound is kept or, without one, as long as they pay, each the one with the best gain per cost. The
  // tree through all points is shorter than the cut with the slits; it is taken if it is better. False if no slit helps any
  // more, or if as many as can be expected to help are not enough.
  bool open_slits(const Objective& objective, int maximum_number_of_slits = (std::numeric_limits<int>::max)())
  {
    constexpr int maximum_number_of_rounds = 3; // of slits and a new tree each
    for(int round = 0; round < maximum_number_of_rounds && open_best_slits(objective, maximum_number_of_slits); ++round)
    {
      Mapped_cut former = m_cut.state();
      if(m_cut.is_tree() || !reconnect(objective, true) || !objective.has_bound() ||
         objective.keeps_bound(m_cut.energy()))
        break;
      // A few slits repair what the other tree lost; if that is longer in the end, the former one stays.
      if(!open_best_slits(objective, maximum_number_of_slits) || m_cut.cost() >= former.cost)
      {
        m_cut.restore(std::move(former));
        break;
      }
    }
    return objective.keeps_bound(m_cut.energy());
  }

  // Drops or trims branches, those first that seem to cost least energy for their cost. Then exchanges: slits
  // with the best gain per cost are opened until more of the branches, if there are any, can be dropped than was opened. All
  // as long as the objective does not get worse and the budget of solves lasts. What is left is straightened by the tree
  // through the remaining features.
  void shorten(const Refinement_goal& goal, int number_of_solves)
  {
    m_solves_left = number_of_solves;
    std::vector<char> is_kept = m_problem.terminal_marks();
    drop_branches(goal, m_solves_left, is_kept);
    while(m_solves_left > 0 && m_cut.goes_on() && m_removals.exist(m_cut.cut(), is_kept) && exchange(goal, is_kept))
      continue;
    if(!m_cut.is_connected() && !m_cut.is_stopped())
      reconnect(goal.objective);
  }

private:
  // A bound that so many slits do not reach is out of reach: bounds that are reached take less than half as many, but
  // for surfaces with many handles, which are distorted everywhere. Each slit takes a solve of the whole, and windows
  // that take as long as some more.
  bool open_best_slits(const Objective& objective, int maximum_number_of_slits)
  {
    constexpr int enough_slits = 200, enough_slits_between_handles = 1000, solves = 4;
    const int all_slits = objective.is_far(m_cut.cost(), m_cut.energy())
                            ? affordable_steps(m_mesh.number_of_faces(), solves)
                            : (std::max)(m_problem.has_many_handles ? enough_slits_between_handles : enough_slits,
                                         affordable_steps(m_mesh.number_of_faces()));
    const std::vector<char> is_excluded(m_mesh.number_of_vertices(), 0);
    for(int i = 0; !(objective.has_bound() && objective.keeps_bound(m_cut.energy())); ++i)
    {
      if(i > (std::min)(all_slits, maximum_number_of_slits) || !m_cut.goes_on())
        return false;
      const Slit slit = m_slits.best(m_cut.map(), is_excluded);
      if(slit.tip < 0 || slit.gain_per_cost() <= objective.least_gain_per_cost())
        return !objective.has_bound();
      if(!(objective.has_bound() ? m_cut.open(slit) : open_if_better(slit, objective)))
        return !objective.has_bound();
    }
    return !m_cut.is_stopped();
  }

  bool open_if_better(const Slit& slit, const Objective& objective)
  {
    Mapped_cut former = m_cut.state();
    if(m_cut.open(slit) && objective(m_cut.cost(), m_cut.energy()) < objective(former.cost, former.energy()))
      return true;
    m_cut.restore(std::move(former));
    return false;
  }

  // Moves ends of a cut that keeps the bound, by large steps and by small ones. The cut keeps the bound afterwards, too,
  // and costs no more than before; without a bound, its sum is no larger.
  void move_ends(const Refinement_goal& goal)
  {
    constexpr double steps[] = {0.15, 0.05}; // of the length of the cut
    constexpr double tolerance = 0.01;       // of the energy, between two rounds
    const Objective& objective = goal.objective;
    const auto rank = [&](const Mapped_cut& cut) { return objective.rank(cut.cost, cut.energy()); };
    const auto present_rank = [&] { return objective.rank(m_cut.cost(), m_cut.energy()); };
    Mapped_cut best = m_cut.state();
    End_search search(m_problem, m_parameters, objective, goal.keeps_tree, m_cut);
    for(int round = 0; round < goal.rounds_of_moved_ends; ++round)
    {
      search.move_ends(steps[round % 2]);
      const bool is_far = m_cut.energy() > objective.bound() + tolerance;
      if(is_far)
        open_slits(objective);
      if(search.best() && rank(*search.best()) < rank(best))
        best = *search.best();
      if(present_rank() < rank(best))
        best = m_cut.state();
      else if(is_far)
        m_cut.restore(best);
    }
    if(!open_slits(objective) || rank(best) < present_rank())
      m_cut.restore(std::move(best));
  }

  // Takes the tree through the features instead of the present cut if it is shorter and no worse, but that it may miss a bound
  // on request. False if the cut is not that tree then.
  bool reconnect(const Objective& objective, bool may_miss_bound = false)
  {
    Mapped_cut former = m_cut.state();
    m_cut.connect(m_parameters.connection_while_refining());
    if(m_cut.tree().status)
    {
      const double saved = former.cost - m_cut.cost();
      const double largest = objective.has_bound() && may_miss_bound ? infinity
                                                                     : objective.largest_energy(former.energy(), saved);
      if(m_cut.tree().cut == former.chart.cut || (saved > 0 && m_cut.map_tree(largest)))
        return true;
      former.tree = m_cut.tree();
      former.is_connected = true;
    }
    m_cut.restore(std::move(former));
    return false;
  }

  // Until so many attempts have failed.
  void drop_branches(const Refinement_goal& goal, int maximum_number_of_failures, const std::vector<char>& is_kept)
  {
    const double least = m_parameters.least_removal();
    const auto allowed_energy = [&](double cost)
    { return cost < least ? 0 : goal.objective.largest_energy(m_cut.energy(), cost) - m_cut.energy(); };
    int number_of_failures = 0;
    while(m_solves_left > 0 && number_of_failures < maximum_number_of_failures && m_cut.goes_on())
    {
      const Branch_removal removal = m_removals.best(m_cut.map(), m_cut.features(), is_kept, allowed_energy);
      if(removal.tip < 0)
        break;
      --m_solves_left;
      number_of_failures += !close(removal, goal);
    }
  }

  bool close(const Branch_removal& removal, const Refinement_goal& goal)
  {
    Mapped_cut former = m_cut.state();
    const bool was_tree = m_cut.is_tree();
    bool is_within = m_cut.close(removal.edges, removal.tip, removal.new_tip,
                                 goal.objective.largest_energy(former.chart.energy, removal.cost));
    double cost = m_cut.energy() - former.chart.energy;
    if(is_within && was_tree && !reconnect(goal.objective) && goal.keeps_tree)
    {
      is_within = false;
      cost = infinity;
    }
    m_removals.remember(removal, cost);
    if(!is_within)
      m_cut.restore(std::move(former));
    return is_within;
  }

  // Opens slits until more of the cut can be closed than was opened. False if no slit is left to try.
  bool exchange(const Refinement_goal& goal, std::vector<char>& is_kept)
  {
    constexpr int maximum_number_of_slits = 3; // that only pay together
    constexpr int number_of_attempts = 4;      // that may fail after each slit, each a solve
    Mapped_cut former = m_cut.state();
    const bool needs_tree = goal.keeps_tree && m_cut.is_tree();
    bool has_slit = false;
    for(int i = 0; i < maximum_number_of_slits && m_solves_left > 0; ++i)
    {
      const Slit slit = m_slits.best(m_cut.map(), is_kept);
      if(slit.tip < 0)
        break;
      has_slit = true;
      is_kept[slit.tip] = 1;
      --m_solves_left;
      if(!m_cut.open(slit))
        break;
      drop_branches(goal, number_of_attempts, is_kept);
      if(is_better_than(former, goal.objective) && (!needs_tree || reconnect(goal.objective)))
        return true;
    }
    m_cut.restore(std::move(former));
    return has_slit;
  }

  // At a bound, a longer cut is not better, although it may have less distortion.
  bool is_better_than(const Mapped_cut& former, const Objective& objective) const
  {
    return (!objective.has_bound() || m_cut.cost() < former.cost) &&
           m_cut.energy() <= objective.largest_energy(former.chart.energy, former.cost - m_cut.cost());
  }

  const Problem& m_problem;
  const Indexed_mesh& m_mesh;
  const Cutting_parameters& m_parameters;
  Slit_search m_slits;
  Branch_removal_search m_removals;
  Working_cut m_cut;
  int m_solves_left = 0;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CUT_REFINER_H
