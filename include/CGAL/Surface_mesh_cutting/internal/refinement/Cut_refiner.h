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

#include <CGAL/Surface_mesh_cutting/Trade_off.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Branch_removal_search.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Slit_search.h>
#include <CGAL/Surface_mesh_cutting/internal/connection/connect_terminals.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A cut through feature points and the map of the surface opened along it.
struct Mapped_cut
{
  std::vector<int> features;
  Connected_cut tree;
  bool is_connected = false; // whether the tree is one through the features; it was one through earlier ones
  double cost = 0;           // of the cut of the chart
  Open_chart chart;
};

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
template <typename ConcurrencyTag>
class Cut_refiner
{
public:
  // The references are kept. What is mandatory, and the terminals, stay on the cut.
  Cut_refiner(const Problem& problem, const Context& context)
    : m_mesh(problem.mesh), m_constraints(problem.constraints), m_terminals(problem.terminals),
      m_parameters(context.parameters), m_control(context.control), m_slits(problem.mesh, problem.constraints),
      m_removals(problem.mesh, problem.constraints),
      m_map(problem.mesh, problem.shapes, mapping_policy(context.parameters), context.control)
  {}

  // Connects the features; call first. A tree that will not matter gets as little effort as one on the way to
  // the final tree.
  Indexed_status connect(std::vector<int> features, bool matters = true)
  {
    m_features = std::move(features);
    connect(matters ? m_parameters.connection : m_parameters.connection_while_refining());
    return m_tree.status;
  }

  // Maps the surface opened along the connected cut; call after connect(). False if no flip-free map was
  // found or the run was stopped.
  bool map() { return map(m_map.policy().precision); }

  // The same with another precision.
  bool map(double precision)
  {
    return map(m_tree.cut, std::numeric_limits<double>::infinity(), precision);
  }

  // Replaces the tree by another cut through the features, and its map.
  void replace_tree(Open_chart chart)
  {
    m_cost = cut_cost(m_constraints, chart.cut);
    m_map.restore(std::move(chart));
    record();
  }

  const std::vector<int>& features() const { return m_features; }
  // The tree through the features, or through former ones if the run was stopped. What is refined may differ
  // from it.
  const Connected_cut& tree() const { return m_tree; }
  bool is_connected() const { return m_is_connected; }
  const Open_chart& chart() const { return m_map.state(); }
  // All cuts that were mapped.
  const std::vector<Trade_off>& trade_offs() const { return m_trade_offs; }

  // Opens slits until the energy is at most `bound`, each the one with the best gain per cost, as
  // long as that is more than `least_gain`. The tree through all points is shorter than the cut with
  // the slits; it is taken if it keeps the bound, too. False if no slit helps any more.
  bool reduce_distortion_to(double bound, double least_gain = 0)
  {
    constexpr int maximum_number_of_rounds = 3; // of slits and a new tree each
    for(int round = 0; round < maximum_number_of_rounds && open_slits_until(bound, least_gain); ++round)
    {
      Mapped_cut former = state();
      if(!reconnect(Refinement_limits()))
        break;
      if(m_map.energy() <= bound)
        break;
      // A few slits repair what the other tree lost; if that is longer in the end, the former one
      // stays.
      if(!open_slits_until(bound, least_gain) || m_cost >= former.cost)
      {
        restore(std::move(former));
        break;
      }
    }
    return m_map.energy() <= bound;
  }

  // Drops or trims branches, those first that seem to cost least energy for their cost. Then exchanges: slits
  // with the best gain per cost are opened until more of the branches can be dropped than was opened. All as
  // long as the limits allow and the budget of solves lasts. What is left is straightened by the tree through the
  // remaining features.
  void shorten(const Refinement_limits& limits)
  {
    m_solves_left = limits.number_of_solves;
    std::vector<char> is_kept(m_mesh.number_of_vertices(), 0);
    for(int v : m_terminals)
      is_kept[v] = 1;
    drop_branches(limits, m_solves_left, is_kept);
    while(m_solves_left > 0 && goes_on() && exchange(limits, is_kept))
      continue;
    if(!m_is_connected && !m_control.is_stopped())
      reconnect(limits);
  }

private:
  bool goes_on() { return !m_map.is_given_up() && m_control.go_further(); }

  void connect(const CGAL::internal::Steiner_tree::Options& options)
  {
    m_tree = connect_terminals<ConcurrencyTag>(m_mesh, m_constraints, m_features, options, m_control);
    m_is_connected = true;
    m_cost = cut_cost(m_constraints, m_tree.cut);
  }

  void record() { m_trade_offs.push_back({cut_length(m_mesh, m_map.cut()), m_cost, m_map.energy()}); }

  Mapped_cut state() const { return {m_features, m_tree, m_is_connected, m_cost, m_map.state()}; }

  void restore(Mapped_cut state)
  {
    m_features = std::move(state.features);
    m_tree = std::move(state.tree);
    m_is_connected = state.is_connected;
    m_cost = state.cost;
    m_map.restore(std::move(state.chart));
  }

  // False if that did not lower the energy.
  bool open(const Slit& slit)
  {
    const double before = m_map.energy();
    m_map.open(slit.edges);
    if(!(m_map.energy() < before))
      return false;
    m_features.push_back(slit.tip);
    m_is_connected = false;
    m_cost += slit.cost;
    record();
    return true;
  }

  // A bound that so many slits do not reach is out of reach: bounds that are reached take less than half as
  // many. Each slit takes a solve of the whole; on small surfaces, all take about half a minute.
  bool open_slits_until(double bound, double least_gain)
  {
    constexpr int enough_slits = 200, enough_solved_faces = 2000000;
    const int maximum_number_of_slits
      = (std::max)(enough_slits, enough_solved_faces / m_mesh.number_of_faces());
    const std::vector<char> is_excluded(m_mesh.number_of_vertices(), 0);
    for(int i = 0; m_map.energy() > bound && m_control.go_further(); ++i)
    {
      if(i > maximum_number_of_slits || m_map.is_given_up())
        return false;
      const Slit slit = m_slits.best(m_map, is_excluded);
      if(slit.tip < 0 || slit.gain_per_cost() < least_gain)
        return false;
      if(!open(slit))
        return false;
    }
    return !m_control.is_stopped();
  }

  // Maps the surface opened along the cut. False also if the energy is above `bound`, as soon as that is
  // foreseeable.
  bool map(const Cut& cut, double bound) { return map(cut, bound, m_map.policy().precision); }
  bool map(const Cut& cut, double bound, double precision)
  {
    if(!m_map.initialize(cut, bound, precision))
      return false;
    record();
    return true;
  }

  // The most energy that a cut may have in exchange for so much cost.
  static double largest_energy(const Refinement_limits& limits, double energy, double saved_cost)
  {
    return (std::min)(limits.energy, energy + limits.energy_per_cost * saved_cost);
  }

  bool is_tree() const { return m_is_connected && m_map.cut() == m_tree.cut; }

  // Takes the tree through the features instead of the present cut if it is shorter and keeps to the limits. False
  // if the cut is not that tree then.
  bool reconnect(const Refinement_limits& limits)
  {
    Mapped_cut former = state();
    connect(m_parameters.connection_while_refining());
    if(m_tree.status)
    {
      const double saved = former.cost - m_cost;
      if(m_tree.cut == former.chart.cut ||
         (saved > 0 && map(m_tree.cut, largest_energy(limits, former.chart.energy, saved))))
        return true;
      former.tree = std::move(m_tree);
      former.is_connected = true;
    }
    restore(std::move(former));
    return false;
  }

  // Until so many attempts have failed.
  void drop_branches(const Refinement_limits& limits, int maximum_number_of_failures, const std::vector<char>& is_kept)
  {
    constexpr double worthwhile = 0.1; // of epsilon_len: removing less is not worth a solve
    const double least = worthwhile * m_parameters.connection.minimum_length_decrease;
    const auto allowed_energy = [&](double cost)
    { return cost < least ? 0 : largest_energy(limits, m_map.energy(), cost) - m_map.energy(); };
    int number_of_failures = 0;
    while(m_solves_left > 0 && number_of_failures < maximum_number_of_failures && goes_on())
    {
      const Branch_removal removal = m_removals.best(m_map, m_features, is_kept, allowed_energy);
      if(removal.tip < 0)
        break;
      --m_solves_left;
      number_of_failures += !close(removal, limits);
    }
  }

  bool close(const Branch_removal& removal, const Refinement_limits& limits)
  {
    Mapped_cut former = state();
    const bool was_tree = is_tree();
    m_features.erase(std::remove(m_features.begin(), m_features.end(), removal.tip), m_features.end());
    if(removal.new_tip >= 0)
      m_features.push_back(removal.new_tip);
    m_is_connected = false;
    Cut cut = m_map.cut();
    for(int e : removal.edges)
      cut[e] = 0;
    m_cost = cut_cost(m_constraints, cut);
    bool is_within = map(cut, largest_energy(limits, former.chart.energy, removal.cost));
    double cost = m_map.energy() - former.chart.energy;
    if(is_within && was_tree && !reconnect(limits) && limits.keeps_tree)
    {
      is_within = false;
      cost = std::numeric_limits<double>::infinity();
    }
    m_removals.remember(removal, cost);
    if(!is_within)
      restore(std::move(former));
    return is_within;
  }

  // Opens slits until more of the cut can be closed than was opened. False if no slit is left to try.
  bool exchange(const Refinement_limits& limits, std::vector<char>& is_kept)
  {
    constexpr int maximum_number_of_slits = 3; // that only pay together
    constexpr int number_of_attempts = 4;      // that may fail after each slit, each a solve
    Mapped_cut former = state();
    const bool needs_tree = limits.keeps_tree && is_tree();
    bool has_slit = false;
    for(int i = 0; i < maximum_number_of_slits && m_solves_left > 0; ++i)
    {
      const Slit slit = m_slits.best(m_map, is_kept);
      if(slit.tip < 0)
        break;
      has_slit = true;
      is_kept[slit.tip] = 1;
      --m_solves_left;
      if(!open(slit))
        break;
      drop_branches(limits, number_of_attempts, is_kept);
      if(m_cost < former.cost && m_map.energy() <= limits.energy && (!needs_tree || reconnect(limits)))
        return true;
    }
    restore(std::move(former));
    return has_slit;
  }

  const Indexed_mesh& m_mesh;
  const Edge_constraints& m_constraints;
  const std::vector<int>& m_terminals;
  const Cutting_parameters& m_parameters;
  Run_control& m_control;
  Slit_search m_slits;
  Branch_removal_search m_removals;
  Incremental_parameterization m_map;
  std::vector<int> m_features;
  Connected_cut m_tree;
  bool m_is_connected = false;
  double m_cost = 0;
  int m_solves_left = 0;
  std::vector<Trade_off> m_trade_offs;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_CUT_REFINER_H
