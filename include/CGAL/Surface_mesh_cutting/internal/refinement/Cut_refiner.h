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
#include <CGAL/Surface_mesh_cutting/internal/refinement/Branch_removal_search.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/End_search.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Slit_search.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Working_cut.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sort_unique.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The limits of a refined cut.
struct Refinement_limits
{
  double energy = std::numeric_limits<double>::infinity(); // area-averaged, at most
  // What a piece of the cut may cost at most, in energy per cost, for its removal to pay.
  double energy_per_cost = std::numeric_limits<double>::infinity();
  int number_of_solves = 0; // at most, for shortening
  // Whether a tree through the features has to remain one: where only they are handed on, a cut that
  // is bent otherwise would be lost.
  bool keeps_tree = false;
};

// Improves a connected cut under the measure of its own map: slits are opened until the distortion
// is as low as asked for, and pieces that contribute little for their length are dropped. Every
// state is a valid cut with a flip-free map.
class Cut_refiner
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

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

  // Opens slits until the energy is at most `bound`, each the one with the best gain per cost, as
  // long as that is more than `least_gain`. The tree through all points is shorter than the cut with
  // the slits; it is taken if it keeps the bound, too. False if no slit helps any more, or if
  // about `maximum_number_of_slits` in a row are not enough.
  bool reduce_distortion_to(double bound, double least_gain = 0,
                            int maximum_number_of_slits = (std::numeric_limits<int>::max)())
  {
    constexpr int maximum_number_of_rounds = 3; // of slits and a new tree each
    for(int round = 0; round < maximum_number_of_rounds && open_slits_until(bound, least_gain, maximum_number_of_slits);
        ++round)
    {
      Mapped_cut former = m_cut.state();
      if(!reconnect(Refinement_limits()))
        break;
      if(m_cut.energy() <= bound)
        break;
      // A few slits repair what the other tree lost; if that is longer in the end, the former one
      // stays.
      if(!open_slits_until(bound, least_gain, maximum_number_of_slits) || m_cut.cost() >= former.cost)
      {
        m_cut.restore(std::move(former));
        break;
      }
    }
    return m_cut.energy() <= bound;
  }

  // Opens slits far cheaper than what they gain, however little that is: it allows for the loss of expensive pieces.
  void open_cheap_slits(double energy_per_cost)
  {
    constexpr int maximum_number_of_slits = 40;
    constexpr double excess = 1.2;      // of the gain, over what pays
    constexpr double least_gain = 0.05; // of epsilon_iso; for less, there are slits everywhere
    const std::vector<char> is_excluded(m_mesh.number_of_vertices(), 0);
    for(int i = 0; i < maximum_number_of_slits && m_cut.goes_on(); ++i)
    {
      const Slit slit = m_slits.best(m_cut.map(), is_excluded);
      if(slit.tip < 0 || slit.gain < least_gain * m_parameters.minimum_distortion_decrease ||
         slit.gain_per_cost() < excess * energy_per_cost || !m_cut.open(slit))
        return;
    }
  }

  // Moves the ends of branches, the most expensive first, to where they gain most beyond their cost; some vanish.
  // Each takes up to two solves.
  void move_ends(const Refinement_limits& limits, int number_of_branches)
  {
    std::vector<char> is_done = m_problem.terminal_marks();
    for(int i = 0; i < number_of_branches && m_cut.goes_on(); ++i)
    {
      const Branch_removal branch = m_removals.most_expensive(m_cut.cut(), is_done);
      if(branch.tip < 0)
        return;
      is_done[branch.tip] = 1;
      Mapped_cut former = m_cut.state();
      int end = -1;
      if(!move_end(branch, limits, end))
        m_cut.restore(std::move(former));
      else if(end >= 0)
        is_done[end] = 1;
    }
  }

  // Moves ends of a cut that keeps the bound, by large steps and by small ones. The cut keeps the bound afterwards, too,
  // and costs no more than before.
  void move_ends_at_bound(bool keeps_tree, int maximum_number_of_rounds)
  {
    constexpr double steps[] = {0.15, 0.05, 0.1}; // of the length of the cut
    constexpr double tolerance = 0.01;            // of the energy, between two rounds
    constexpr int patience = 2;                   // rounds without a gain
    const double bound = m_parameters.maximum_average_distortion;
    Mapped_cut best = m_cut.state();
    End_search search(m_problem, m_parameters, keeps_tree, m_cut);
    search.drop_inner_features();
    int number_of_failures = 0, number_of_rounds = 0;
    for(double step : steps)
    {
      if(number_of_failures == patience || number_of_rounds++ == maximum_number_of_rounds)
        break;
      search.move_ends(step);
      const bool is_far = m_cut.energy() > bound + tolerance;
      if(is_far)
        reduce_distortion_to(bound);
      ++number_of_failures;
      if(search.best() && search.best()->cost < best.cost)
      {
        best = *search.best();
        number_of_failures = 0;
      }
      if(m_cut.energy() <= bound && m_cut.cost() < best.cost)
      {
        best = m_cut.state();
        number_of_failures = 0;
      }
      else if(is_far)
        m_cut.restore(best);
    }
    if(!reduce_distortion_to(bound) || m_cut.cost() > best.cost)
      m_cut.restore(std::move(best));
  }

  // Drops or trims branches, those first that seem to cost least energy for their cost. Then exchanges: slits
  // with the best gain per cost are opened until more of the branches, if there are any, can be dropped than was opened. All
  // as long as the limits allow and the budget of solves lasts. What is left is straightened by the tree through the
  // remaining features.
  void shorten(const Refinement_limits& limits)
  {
    m_solves_left = limits.number_of_solves;
    std::vector<char> is_kept = m_problem.terminal_marks();
    drop_branches(limits, m_solves_left, is_kept);
    while(m_solves_left > 0 && m_cut.goes_on() && m_removals.exist(m_cut.cut(), is_kept) && exchange(limits, is_kept))
      continue;
    if(!m_cut.is_connected() && !m_cut.is_stopped())
      reconnect(limits);
  }

private:
  // A bound that so many slits do not reach is out of reach: bounds that are reached take less than half as many, but
  // for surfaces with many handles, which are distorted everywhere. Each slit takes a solve of the whole; on small
  // surfaces, all take about half a minute.
  bool open_slits_until(double bound, double least_gain, int maximum_number_of_slits)
  {
    constexpr int enough_slits = 200, enough_slits_between_handles = 1000, enough_solved_faces = 2000000;
    const int all_slits = (std::max)(m_problem.has_many_handles ? enough_slits_between_handles : enough_slits,
                                     enough_solved_faces / m_mesh.number_of_faces());
    const std::vector<char> is_excluded(m_mesh.number_of_vertices(), 0);
    for(int i = 0; m_cut.energy() > bound; ++i)
    {
      if(i > (std::min)(all_slits, maximum_number_of_slits) || !m_cut.goes_on())
        return false;
      const Slit slit = m_slits.best(m_cut.map(), is_excluded);
      if(slit.tip < 0 || slit.gain_per_cost() < least_gain)
        return false;
      if(!m_cut.open(slit))
        return false;
    }
    return !m_cut.is_stopped();
  }

  // The most energy that a cut may have in exchange for so much cost.
  static double largest_energy(const Refinement_limits& limits, double energy, double saved_cost)
  {
    return (std::min)(limits.energy, energy + limits.energy_per_cost * saved_cost);
  }

  // Takes the tree through the features instead of the present cut if it is shorter and keeps to the limits. False
  // if the cut is not that tree then.
  bool reconnect(const Refinement_limits& limits)
  {
    Mapped_cut former = m_cut.state();
    m_cut.connect(m_parameters.connection_while_refining());
    if(m_cut.tree().status)
    {
      const double saved = former.cost - m_cut.cost();
      if(m_cut.tree().cut == former.chart.cut ||
         (saved > 0 && m_cut.map_tree(largest_energy(limits, former.chart.energy, saved))))
        return true;
      former.tree = m_cut.tree();
      former.is_connected = true;
    }
    m_cut.restore(std::move(former));
    return false;
  }

  // Until so many attempts have failed.
  void drop_branches(const Refinement_limits& limits, int maximum_number_of_failures, const std::vector<char>& is_kept)
  {
    const double least = m_parameters.least_removal();
    const auto allowed_energy = [&](double cost)
    { return cost < least ? 0 : largest_energy(limits, m_cut.energy(), cost) - m_cut.energy(); };
    int number_of_failures = 0;
    while(m_solves_left > 0 && number_of_failures < maximum_number_of_failures && m_cut.goes_on())
    {
      const Branch_removal removal = m_removals.best(m_cut.map(), m_cut.features(), is_kept, allowed_energy);
      if(removal.tip < 0)
        break;
      --m_solves_left;
      number_of_failures += !close(removal, limits);
    }
  }

  bool close(const Branch_removal& removal, const Refinement_limits& limits)
  {
    Mapped_cut former = m_cut.state();
    const bool was_tree = m_cut.is_tree();
    bool is_within = m_cut.close(removal.edges, removal.tip, removal.new_tip,
                                 largest_energy(limits, former.chart.energy, removal.cost));
    double cost = m_cut.energy() - former.chart.energy;
    if(is_within && was_tree && !reconnect(limits) && limits.keeps_tree)
    {
      is_within = false;
      cost = infinity;
    }
    m_removals.remember(removal, cost);
    if(!is_within)
      m_cut.restore(std::move(former));
    return is_within;
  }

  // Closes the branch and opens the best slit to an end near its tip instead. False if that does not pay.
  bool move_end(const Branch_removal& branch, const Refinement_limits& limits, int& end)
  {
    const auto objective = [&] { return m_cut.energy() + limits.energy_per_cost * m_cut.cost(); };
    const double former = objective();
    if(!m_cut.close(branch.edges, branch.tip, branch.new_tip))
      return false;
    const Slit slit = m_slits.best_end(m_cut.map(), branch.tip, total_length(m_mesh, branch.edges),
                                       limits.energy_per_cost);
    end = slit.tip;
    if(end >= 0)
      m_cut.open(slit);
    return objective() < former && m_cut.energy() <= limits.energy;
  }

  // Opens slits until more of the cut can be closed than was opened. False if no slit is left to try.
  bool exchange(const Refinement_limits& limits, std::vector<char>& is_kept)
  {
    constexpr int maximum_number_of_slits = 3; // that only pay together
    constexpr int number_of_attempts = 4;      // that may fail after each slit, each a solve
    Mapped_cut former = m_cut.state();
    const bool needs_tree = limits.keeps_tree && m_cut.is_tree();
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
      drop_branches(limits, number_of_attempts, is_kept);
      if(m_cut.cost() < former.cost &&
         m_cut.energy() <= largest_energy(limits, former.chart.energy, former.cost - m_cut.cost()) &&
         (!needs_tree || reconnect(limits)))
        return true;
    }
    m_cut.restore(std::move(former));
    return has_slit;
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
