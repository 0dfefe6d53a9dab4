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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_WORKING_CUT_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_WORKING_CUT_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Trade_off.h>
#include <CGAL/Surface_mesh_cutting/internal/connection/connect_terminals.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Incremental_parameterization.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/final_map.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/vertex_distortion.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Injective_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Slit_search.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/distortion_tree.h>

#include <algorithm>
#include <limits>
#include <optional>
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
  std::optional<Injective_map> injective; // if that is what counts

  double energy() const { return injective ? injective->energy : chart.energy; }
};

// A mapped cut in work: its pieces are opened and closed, and its features connected anew. Each state is a valid cut
// with a flip-free map, and can be kept and restored.
class Working_cut
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

public:
  // The references are kept.
  Working_cut(const Problem& problem, const Context& context)
    : m_problem(problem), m_context(context),
      m_map(problem.mesh, problem.shapes, mapping_policy(context.parameters), context.control)
  {}

  const std::vector<int>& features() const { return m_features; }
  // The tree through the features, or through former ones if the run was stopped. The cut may differ from it.
  const Connected_cut& tree() const { return m_tree; }
  bool is_connected() const { return m_is_connected; }
  const Open_chart& chart() const { return m_map.state(); }
  const Cut& cut() const { return m_map.cut(); }
  Incremental_parameterization& map() { return m_map; }
  double cost() const { return m_cost; }
  // Of the map that counts: the running one, or that without overlaps.
  double energy() const { return m_is_injective ? injective().energy : m_map.energy(); }
  double running_energy() const { return m_map.energy(); }
  // All cuts that were mapped.
  const std::vector<Trade_off>& trade_offs() const { return m_trade_offs; }

  bool goes_on() { return !m_map.is_given_up() && m_context.control.go_further(); }
  bool is_stopped() const { return m_context.control.is_stopped(); }

  // Connects these features; the tree is not mapped yet.
  void connect(std::vector<int> features, const CGAL::internal::Steiner_tree::Options& options)
  {
    m_features = std::move(features);
    connect(options);
  }

  void connect(const CGAL::internal::Steiner_tree::Options& options)
  {
    m_tree = connect_terminals(m_problem.mesh, m_problem.constraints, m_features, options, m_context.execution, m_context.control,
                                               cut());
    m_is_connected = true;
    m_cost = cut_cost(m_problem.constraints, m_tree.cut);
  }

  bool is_tree() const { return m_is_connected && m_map.cut() == m_tree.cut; }

  // Maps the surface opened along the tree. False if no flip-free map was found, if the run was stopped, or if the
  // energy is above `bound`, as soon as that is foreseeable.
  bool map_tree(double bound) { return map_tree(bound, m_map.policy().precision); }
  bool map_tree(double bound, double precision) { return map(m_tree.cut, bound, precision); }

  // Maps the surface opened along a tree through the features that leads where the map is distorted, see
  // `distortion_tree()`. False as for map_tree(), or if that is the present cut.
  bool reroute(double share)
  {
    const Connected_cut other
      = distortion_tree(m_problem, m_features, vertex_distortion(), energy(), share,
                                        m_context.parameters.connection_while_refining(), m_context.execution, m_context.control);
    if(!other.status || other.cut == cut())
      return false;
    m_is_connected = false;
    m_cost = cut_cost(m_problem.constraints, other.cut);
    return map(other.cut, infinity, m_map.policy().precision);
  }

  // Lets the tree do without it; the cut stays as it is.
  void drop_feature(int v)
  {
    m_features.erase(std::remove(m_features.begin(), m_features.end(), v), m_features.end());
    m_is_connected = false;
  }

  // Takes another cut through the features and its map.
  void replace(Open_chart chart)
  {
    m_injective.reset();
    m_cost = cut_cost(m_problem.constraints, chart.cut);
    m_map.restore(std::move(chart));
    record();
  }

  // Takes a cut that need not be a tree, and maps it. False as for map_tree().
  bool start(std::vector<int> ends, const Cut& cut)
  {
    m_features = std::move(ends);
    m_is_connected = false;
    m_cost = cut_cost(m_problem.constraints, cut);
    return map(cut, infinity, m_map.policy().precision);
  }

  // Takes a cut and its map without overlaps, which counts from here on. False as for map_tree().
  bool start_injectively(const Injective_cut& cut)
  {
    m_is_injective = true;
    if(!start(cut.ends, cut.cut))
      return false;
    m_injective = cut.map;
    for(int c = 0; c < 3 * m_problem.mesh.number_of_faces(); ++c) // the chart may be numbered otherwise
      m_injective->uv[chart().chart.source(c)] = cut.map.uv[cut.chart.source(c)];
    return true;
  }

  Mapped_cut state() const
  {
    Mapped_cut result{m_features, m_tree, m_is_connected, m_cost, m_map.state(), std::nullopt};
    if(m_is_injective)
      result.injective = injective();
    return result;
  }

  void restore(Mapped_cut state)
  {
    m_features = std::move(state.features);
    m_tree = std::move(state.tree);
    m_is_connected = state.is_connected;
    m_cost = state.cost;
    m_injective = std::move(state.injective);
    m_map.restore(std::move(state.chart));
  }

  // False if that did not lower the energy.
  bool open(const Slit& slit)
  {
    const double before = m_map.energy();
    m_map.open(slit.edges);
    m_injective.reset();
    if(!(m_map.energy() < before))
      return false;
    m_features.push_back(slit.tip);
    m_is_connected = false;
    m_cost += slit.cost;
    record();
    return true;
  }

  // Closes the edges of a branch, which ends at `new_tip` then (-1: vanishes). False as for map_tree().
  bool close(const std::vector<int>& edges, int tip, int new_tip, double bound = infinity)
  {
    drop_feature(tip);
    if(new_tip >= 0)
      m_features.push_back(new_tip);
    Cut cut = m_map.cut();
    for(int e : edges)
      cut[e] = 0;
    m_cost = cut_cost(m_problem.constraints, cut);
    return map(cut, bound, m_map.policy().precision);
  }

private:
  bool map(const Cut& cut, double bound, double precision)
  {
    m_injective.reset();
    if(!m_map.initialize(cut, bound, precision))
      return false;
    record();
    return true;
  }

  // Of each surface vertex, by the map that counts.
  std::vector<double> vertex_distortion() const
  {
    return m_is_injective ? internal::vertex_distortion(m_problem.mesh, m_problem.shapes, chart().chart, injective().uv)
                          : m_map.vertex_distortion();
  }

  // Known once there was need for it: it takes longer than the running map.
  const Injective_map& injective() const
  {
    if(!m_injective)
    {
      m_injective.emplace();
      const Newton_result newton = final_map(m_problem, m_map.state(), m_context, m_injective->uv);
      m_injective->energy = newton.outcome == Newton_outcome::FAILED ? infinity : newton.energy;
    }
    return *m_injective;
  }

  // Of maps that may overlap.
  void record() { m_trade_offs.push_back({cut_length(m_problem.mesh, m_map.cut()), m_cost, m_map.energy()}); }

  const Problem& m_problem;
  const Context m_context;
  Incremental_parameterization m_map;
  bool m_is_injective = false;
  mutable std::optional<Injective_map> m_injective; // of the present cut
  std::vector<int> m_features;
  Connected_cut m_tree;
  bool m_is_connected = false;
  double m_cost = 0;
  std::vector<Trade_off> m_trade_offs;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_WORKING_CUT_H
