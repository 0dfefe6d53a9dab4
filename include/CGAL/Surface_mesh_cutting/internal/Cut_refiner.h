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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_CUT_REFINER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_CUT_REFINER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Trade_off.h>
#include <CGAL/Surface_mesh_cutting/internal/Cutting_parameters.h>
#include <CGAL/Surface_mesh_cutting/internal/Leaf_branches.h>
#include <CGAL/Surface_mesh_cutting/internal/Slit_search.h>
#include <CGAL/Surface_mesh_cutting/internal/connect_in_chart.h>

#include <algorithm>
#include <limits>
#include <set>
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
  double length = 0;         // of the cut of the chart
  Open_chart chart;
};

// What a refined cut has to keep to.
struct Refinement_limits
{
  double energy = std::numeric_limits<double>::infinity(); // area-averaged, at most
  // What a piece of the cut may cost at most, in energy per length, for its removal to pay.
  double energy_per_length = std::numeric_limits<double>::infinity();
  int number_of_solves = 0; // at most, for shortening
};

// Improves a connected cut under the measure of its own map: slits are opened until the distortion
// is as low as asked for, and pieces that contribute little for their length are dropped. Every
// state is a valid cut with a flip-free map.
template <typename LinearSolver, typename ConcurrencyTag>
class Cut_refiner
{
public:
  // `constraints` and `terminals`, which stay on the cut, as in `Component_cutter`; `control` and the
  // other references are kept.
  Cut_refiner(const Flat_mesh& mesh, const std::vector<Rest_shape>& shapes, const Edge_constraints& constraints,
              const std::vector<int>& terminals, const Cutting_parameters& parameters, Run_control& control)
    : m_mesh(mesh), m_shapes(shapes), m_constraints(constraints), m_terminals(terminals),
      m_parameters(parameters), m_control(control), m_search(mesh, constraints), m_map(mesh, shapes, control)
  {}

  // Connects the features; the first of the calls.
  Flat_status connect(std::vector<int> features)
  {
    m_features = std::move(features);
    connect(m_parameters.connection);
    return m_tree.status;
  }

  // Maps the surface opened along the connected cut; the second of the calls. False if no flip-free
  // map was found or the run was stopped.
  bool map() { return map(m_tree.cut, std::numeric_limits<double>::infinity()); }

  // Goes on with another cut through the features, and its map, instead of the tree.
  void replace_tree(Open_chart chart)
  {
    m_length = cut_length(m_mesh, chart.cut);
    m_map.restore(std::move(chart));
    record();
  }

  const std::vector<int>& features() const { return m_features; }
  // The tree through the features, or through former ones if the run was stopped. What is refined may differ
  // from it.
  const Connected_cut& tree() const { return m_tree; }
  bool is_connected() const { return m_is_connected; }
  const Open_chart& chart() const { return m_map.state(); }
  double length() const { return m_length; } // of the chart's cut
  // All cuts that were mapped.
  const std::vector<Trade_off>& trade_offs() const { return m_trade_offs; }

  // Opens slits until the energy is at most `bound`, each the one with the best gain per length, as
  // long as that is more than `least_gain`. The tree through all points is shorter than the cut with
  // the slits; it is taken if it keeps the bound, too. False if no slit helps any more.
  bool lower_to(double bound, double least_gain = 0)
  {
    constexpr int maximum_number_of_rounds = 3;
    for(int round = 0; round < maximum_number_of_rounds && open_slits_until(bound, least_gain); ++round)
    {
      Mapped_cut former = state();
      if(!reconnect(Refinement_limits()))
        break;
      if(m_map.energy() <= bound)
        break;
      // A few slits repair what the other tree lost; if that is longer in the end, the former one
      // stays.
      if(!open_slits_until(bound, least_gain) || m_length >= former.length)
      {
        restore(std::move(former));
        break;
      }
    }
    return m_map.energy() <= bound;
  }

  // Drops or trims branches, those first that gape least for their length. Then exchanges: the slit
  // with the best gain per length is opened, and what that makes superfluous is dropped. All as long
  // as the limits allow and the budget of solves lasts. What is left is straightened by the tree through the
  // remaining features.
  void shorten(const Refinement_limits& limits)
  {
    constexpr int number_of_attempts = 4;
    m_solves_left = limits.number_of_solves;
    do
      drop_branches(limits, m_solves_left);
    while(!m_is_connected && m_solves_left > 0 && reconnect(limits));
    std::vector<char> is_excluded(m_mesh.number_of_vertices(), 0);
    while(m_solves_left > 0 && m_control.go_further())
    {
      Mapped_cut former = state();
      const Slit slit = m_search.best(m_map, is_excluded);
      if(slit.tip < 0)
        break;
      is_excluded[slit.tip] = 1;
      --m_solves_left;
      open(slit);
      drop_branches(limits, number_of_attempts, slit.tip);
      if(!(m_length < former.length) || m_map.energy() > limits.energy)
        restore(std::move(former));
    }
    if(!m_is_connected && !m_control.is_stopped())
      reconnect(limits);
  }

private:
  // A feature point drawn back along its branch, or dropped.
  struct Move
  {
    int tip = -1, new_tip = -1;
    std::vector<int> edges;     // that are closed again
    double length = 0, gap = 0; // of these

    // Opening relieves energy by about the square of the gap.
    double cost_per_length() const { return gap * gap / length; }
  };

  void connect(const CGAL::internal::Steiner_tree::Options& options)
  {
    m_tree = connect_in_chart<ConcurrencyTag>(m_mesh, m_constraints, m_features, options,
                                              [this] { return m_control.go_further(); });
    m_is_connected = true;
    m_length = cut_length(m_mesh, m_tree.cut);
  }

  void record() { m_trade_offs.push_back({m_length, m_map.energy()}); }

  Mapped_cut state() const { return {m_features, m_tree, m_is_connected, m_length, m_map.state()}; }

  void restore(Mapped_cut state)
  {
    m_features = std::move(state.features);
    m_tree = std::move(state.tree);
    m_is_connected = state.is_connected;
    m_length = state.length;
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
    m_length += slit.length;
    record();
    return true;
  }

  bool open_slits_until(double bound, double least_gain)
  {
    const std::vector<char> is_excluded(m_mesh.number_of_vertices(), 0);
    while(m_map.energy() > bound && m_control.go_further())
    {
      const Slit slit = m_search.best(m_map, is_excluded);
      if(slit.tip < 0 || slit.gain_per_length() < least_gain)
        return false;
      if(!open(slit))
        return false;
    }
    return !m_control.is_stopped();
  }

  // Maps the surface opened along the cut. False also if the energy is above `bound`, as soon as that is
  // foreseeable.
  bool map(const Cut& cut, double bound)
  {
    if(!m_map.initialize(cut, bound))
      return false;
    record();
    return true;
  }

  // The most energy that a cut may have in exchange for so much length.
  double largest_energy(const Refinement_limits& limits, double energy, double saved_length) const
  {
    return (std::min)(limits.energy, energy + limits.energy_per_length * saved_length);
  }

  // Takes the tree through the features instead of the present cut if it is shorter and keeps to the limits.
  bool reconnect(const Refinement_limits& limits)
  {
    Mapped_cut former = state();
    CGAL::internal::Steiner_tree::Options connection = m_parameters.connection;
    connection.maximum_number_of_states
      = (std::min)(connection.maximum_number_of_states, m_parameters.number_of_states_while_refining);
    connect(connection);
    const double saved = former.length - m_length;
    if(m_tree.status && saved > 0 && map(m_tree.cut, largest_energy(limits, former.chart.energy, saved)))
      return true;
    if(m_tree.status)
    {
      former.tree = std::move(m_tree);
      former.is_connected = true;
    }
    restore(std::move(former));
    return false;
  }

  // Until so many attempts have failed. The branch to `kept_tip`, if any, stays.
  void drop_branches(const Refinement_limits& limits, int maximum_number_of_failures, int kept_tip = -1)
  {
    std::set<std::pair<int, int> > rejected; // former and new tip
    while(m_solves_left > 0 && int(rejected.size()) < maximum_number_of_failures && m_control.go_further())
    {
      const Move move = best_move(rejected, kept_tip);
      if(move.tip < 0)
        break;
      --m_solves_left;
      if(!take(move, limits))
        rejected.emplace(move.tip, move.new_tip);
    }
  }

  Move best_move(const std::set<std::pair<int, int> >& rejected, int kept_tip) const
  {
    std::vector<char> is_end(m_mesh.number_of_vertices(), 0), is_kept = is_end;
    for(int v : m_features)
      is_end[v] = 1;
    for(int v : m_terminals)
      is_kept[v] = 1;
    const std::vector<double> gaps = m_map.gaps();
    const std::size_t open_edges = number_of_open_edges();
    Move best;
    for(const Leaf_branch& branch : leaf_branches(m_mesh, m_map.cut(), is_end))
    {
      if(is_kept[branch.vertices.front()] || branch.vertices.front() == kept_tip)
        continue;
      for(std::size_t size = number_of_free_edges(branch); size > 0; size /= 2)
      {
        const Move move = make_move(branch, size, gaps);
        const bool leaves_a_disk = open_edges >= size + 2; // it takes two open edges on a closed surface
        if(leaves_a_disk && !rejected.count({move.tip, move.new_tip}))
        {
          if(best.tip < 0 || move.cost_per_length() < best.cost_per_length())
            best = move;
          break; // the shorter ones after this one
        }
      }
    }
    return best;
  }

  // Mandatory edges, and what is between them and the rest of the cut, stay.
  std::size_t number_of_free_edges(const Leaf_branch& branch) const
  {
    return std::find_if(branch.edges.begin(), branch.edges.end(), [this](int e) { return m_constraints.mandatory[e]; }) -
           branch.edges.begin();
  }

  // Closes the outer `size` edges of a branch.
  Move make_move(const Leaf_branch& branch, std::size_t size, const std::vector<double>& gaps) const
  {
    Move move;
    move.tip = branch.vertices.front();
    if(size < branch.edges.size())
      move.new_tip = branch.vertices[size];
    move.edges.assign(branch.edges.begin(), branch.edges.begin() + size);
    for(std::size_t i = 0; i < size; ++i)
    {
      move.length += m_mesh.length(branch.edges[i]);
      move.gap = (std::max)(move.gap, gaps[branch.vertices[i]]);
    }
    return move;
  }

  std::size_t number_of_open_edges() const
  {
    std::size_t count = 0;
    for(int e = 0; e < m_mesh.number_of_edges(); ++e)
      count += m_map.cut()[e] || m_mesh.is_border_edge(e);
    return count;
  }

  bool take(const Move& move, const Refinement_limits& limits)
  {
    Mapped_cut former = state();
    m_features.erase(std::remove(m_features.begin(), m_features.end(), move.tip), m_features.end());
    if(move.new_tip >= 0)
      m_features.push_back(move.new_tip);
    m_is_connected = false;
    Cut cut = m_map.cut();
    for(int e : move.edges)
      cut[e] = 0;
    m_length = cut_length(m_mesh, cut);
    if(map(cut, largest_energy(limits, former.chart.energy, former.length - m_length)))
      return true;
    restore(std::move(former));
    return false;
  }

  const Flat_mesh& m_mesh;
  const std::vector<Rest_shape>& m_shapes;
  const Edge_constraints& m_constraints;
  const std::vector<int>& m_terminals;
  const Cutting_parameters& m_parameters;
  Run_control& m_control;
  Slit_search<LinearSolver> m_search;
  Running_map<LinearSolver> m_map;
  std::vector<int> m_features;
  Connected_cut m_tree;
  bool m_is_connected = false;
  double m_length = 0;
  int m_solves_left = 0;
  std::vector<Trade_off> m_trade_offs;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_CUT_REFINER_H
