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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_INJECTIVE_REFINER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_INJECTIVE_REFINER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/Context.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Problem.h>
#include <CGAL/Surface_mesh_cutting/internal/context/work.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Incremental_parameterization.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Open_chart.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/vertex_distortion.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Injective_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Objective.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Slit_search.h>

#include <CGAL/Surface_mesh_parameterization/internal/bijective/Scaffold_minimization.h>
#include <CGAL/Surface_mesh_parameterization/internal/bijective/bijective_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>

#include <CGAL/boost/graph/internal/Graph_kernel/sorting.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Opens slits in maps without overlaps. Where parts of a chart are in each other's way, the map is more distorted than
// one that may overlap: a slit lets them turn aside. Windows around a slit do not show that, since what turns is
// outside; every slit that is tried is opened, and the chart solved with its scaffold. Yet windows show which slits are
// cheap for what they gain in any case.
class Injective_refiner
{
public:
  // `overlapping`: the best map of the cut that may overlap. Where the other is worse, slits help most. The references
  // to the problem and to what the context holds are kept.
  Injective_refiner(const Problem& problem, const Context& context, const Open_chart& overlapping)
    : m_problem(problem), m_context(context), m_slits(problem.mesh, problem.constraints),
      m_reference(vertex_distortion(problem.mesh, problem.shapes, overlapping.chart, overlapping.uv)),
      m_is_excluded(problem.mesh.number_of_vertices(), 0)
  {}

  // Until the energy is at most `goal`; false if no slit is found that helps, or if it takes too long. Several slits that
  // gain more for their cost than one that is enough may cost more together.
  bool lower_to(double goal, Injective_cut& cut, double least_gain_per_cost = 0)
  {
    m_enough.reset();
    m_least_gain_per_cost = least_gain_per_cost;
    while(cut.map.energy > goal && costs_less_than_enough(cost(cut)) && has_time() && open_best(goal, cut))
      continue;
    if(m_enough && (cut.map.energy > goal || !costs_less_than_enough(cost(cut))))
      cut = std::move(*m_enough);
    return cut.map.energy <= goal;
  }

  // Opens slits to `tips` together, each from the cut and those before it. If they lead less than half the way to
  // `goal`, `cut` stays as it is: slits are better chosen one by one then.
  void open_to(const std::vector<int>& tips, double goal, Injective_cut& cut)
  {
    constexpr double least_share = 0.5;
    Cut with_slits = cut.cut;
    std::vector<int> edges, ends = cut.ends;
    for(int tip : tips)
    {
      const Slit slit = m_slits.slit_to(tip, with_slits);
      for(int e : slit.edges)
        with_slits[e] = 1;
      edges.insert(edges.end(), slit.edges.begin(), slit.edges.end());
      if(slit.tip >= 0)
        ends.push_back(slit.tip);
    }
    if(edges.empty())
      return;
    Injective_cut all = opened(cut, edges, std::move(ends), goal);
    if(all.map.energy - goal <= least_share * (cut.map.energy - goal))
      cut = std::move(all);
  }

private:
  bool has_time() const
  {
    return m_number_of_solved_faces <= work_of_stage && m_context.control.go_further();
  }

  double cost(const Injective_cut& cut) const { return cut_cost(m_problem.constraints, cut.cut); }

  bool costs_less_than_enough(double cost) const { return !m_enough || cost < this->cost(*m_enough); }

  struct Trial
  {
    Slit slit; // what lies below the goal is no gain
    Injective_cut cut;
  };

  // The slit that gains most for its cost, of those that seem best; far from the goal, all that gain independently of
  // each other. False if none gains.
  bool open_best(double goal, Injective_cut& cut)
  {
    constexpr int maximum_number_of_attempts = 3;
    constexpr double far = 4; // of what the best slit gains
    std::vector<Trial> trials;
    for(int i = 0; i < maximum_number_of_attempts && trials.empty(); ++i)
      trials = useful_trials(goal, cut);
    if(trials.empty())
      return false;
    if(trials.size() == 1 || cut.map.energy - goal < far * trials.front().slit.gain || !open_all(trials, goal, cut))
      cut = std::move(trials.front().cut);
    return true;
  }

  // Slits are paths of one forest of shortest paths, so that together they leave a disk, too. False if they gain
  // much less than the sum of their gains.
  bool open_all(const std::vector<Trial>& trials, double goal, Injective_cut& cut)
  {
    constexpr double share = 0.8;      // of that sum
    constexpr double least_gain = 0.5; // per cost, relative to the best: with others opened, better ones are found
    const double least_gain_per_cost
      = m_context.parameters.widens_search() ? least_gain * trials.front().slit.gain_per_cost() : 0;
    std::vector<int> edges, ends = cut.ends;
    double gain = 0;
    for(const Trial& t : trials)
    {
      if(t.slit.gain_per_cost() < least_gain_per_cost)
        continue;
      edges.insert(edges.end(), t.slit.edges.begin(), t.slit.edges.end());
      ends.push_back(t.slit.tip);
      gain += t.slit.gain;
    }
    CGAL::internal::Graph_kernel::sort_unique(edges);
    Injective_cut all = opened(cut, edges, std::move(ends), goal);
    if(cut.map.energy - all.map.energy < share * gain)
      return false;
    cut = std::move(all);
    return true;
  }

  // Those that gain, the best first. None costs more than one that reaches the goal.
  std::vector<Trial> useful_trials(double goal, const Injective_cut& cut)
  {
    constexpr double least_gain = 2e-4; // less is within the precision of the trials
    const double former_cost = cost(cut);
    std::vector<Trial> trials;
    for(Slit& slit : proposals(goal, cut))
    {
      if(!has_time() || !costs_less_than_enough(former_cost + slit.cost))
        break;
      std::vector<int> ends = cut.ends;
      ends.push_back(slit.tip);
      Injective_cut trial = opened(cut, slit.edges, std::move(ends), goal);
      slit.gain = cut.map.energy - (std::max)(trial.map.energy, goal);
      const bool pays = slit.gain > m_least_gain_per_cost * slit.cost, is_enough = pays && trial.map.energy <= goal;
      if(is_enough)
        m_enough = trial;
      if(is_enough || (pays && slit.gain > least_gain))
        trials.push_back({std::move(slit), std::move(trial)});
      else
        m_is_excluded[slit.tip] = 1;
      if(is_enough)
        break;
    }
    CGAL::internal::Graph_kernel::sort_by_key(trials, [](const Trial& trial) { return -trial.slit.gain_per_cost(); });
    return trials;
  }

  // To where the map is worse than the overlapping one, to where it is bad, and where windows gain most for the cost;
  // the cheapest first.
  std::vector<Slit> proposals(double goal, const Injective_cut& cut)
  {
    constexpr std::size_t number_of_each = 2;
    const std::vector<double> distortion = vertex_distortion(m_problem.mesh, m_problem.shapes, cut.chart, cut.map.uv);
    std::vector<double> excess = distortion;
    for(std::size_t v = 0; v < excess.size(); ++v)
      excess[v] += Symmetric_Dirichlet_energy::ideal - m_reference[v];
    std::vector<Slit> slits = m_slits.proposals(cut.cut, excess, m_is_excluded, number_of_each);
    add(m_slits.proposals(cut.cut, distortion, m_is_excluded, number_of_each), slits);
    if(m_context.parameters.widens_search())
      add(best_by_windows(goal, cut, distortion), slits);
    CGAL::internal::Graph_kernel::sort_by_key(slits, [](const Slit& slit) { return slit.cost; });
    return slits;
  }

  static void add(std::vector<Slit> others, std::vector<Slit>& slits)
  {
    for(Slit& slit : others)
      if(std::none_of(slits.begin(), slits.end(), [&](const Slit& other) { return other.tip == slit.tip; }))
        slits.push_back(std::move(slit));
  }

  // To where the distortion is large; near the goal, short ones from the ends of the cut as well: a whole slit costs several
  // times what is missing there.
  std::vector<Slit> best_by_windows(double goal, const Injective_cut& cut, const std::vector<double>& distortion)
  {
    constexpr std::size_t number_of_windows = 12, number_of_slits = 4, number_of_short_slits = 3;
    constexpr double near = 0.1; // above the goal, relative to what that leaves above the ideal
    Incremental_parameterization map = map_of(cut);
    const double missing = cut.map.energy - goal;
    std::vector<Slit> slits = best_of(m_slits.proposals(cut.cut, distortion, m_is_excluded, number_of_windows),
                                      number_of_slits, std::numeric_limits<double>::infinity(), map);
    if(missing < near * (goal - Symmetric_Dirichlet_energy::ideal))
    {
      const double missing_cost = Objective(goal, 0)(cost(cut), cut.map.energy) - cost(cut);
      add(best_of(m_slits.prolongations(cut.cut, m_is_excluded, missing_cost), number_of_short_slits, missing, map), slits);
    }
    return slits;
  }

  // That gain most for their cost, where more than `enough` does not count.
  static std::vector<Slit> best_of(std::vector<Slit> slits, std::size_t number, double enough,
                                   Incremental_parameterization& map)
  {
    estimate_gains(map, slits);
    for(Slit& slit : slits)
      slit.gain = (std::min)(slit.gain, enough);
    CGAL::internal::Graph_kernel::sort_by_key(slits, [](const Slit& slit) { return -slit.gain_per_cost(); });
    slits.resize((std::min)(slits.size(), number));
    return slits;
  }

  Incremental_parameterization map_of(const Injective_cut& cut) const
  {
    Incremental_parameterization map(m_problem.mesh, m_problem.shapes, mapping_policy(m_context.parameters),
                                     m_context.control);
    Open_chart chart;
    chart.cut = cut.cut;
    chart.chart = cut.chart;
    chart.uv = cut.map.uv;
    chart.energy = cut.map.energy;
    map.restore(std::move(chart));
    return map;
  }

  Injective_cut opened(const Injective_cut& cut, const std::vector<int>& edges, std::vector<int> ends, double goal)
  {
    using namespace Surface_mesh_parameterization::internal;
    Injective_cut result = cut;
    result.ends = std::move(ends);
    result.open(m_problem.mesh, edges);
    Scaffold_options options;
    options.decrease = 4e-4; // the slit is narrow at first, and what it gains comes late
    options.maximum_rounds = 6;
    options.go_further = m_context.control;
    if(m_context.parameters.ends_early_in_room())
      options.enough_energy = goal;
    const Newton_result newton = Scaffold_minimization(result.chart, m_problem.shapes,
                                                       *m_context.parameters.linear_solvers, options)(result.map.uv);
    m_number_of_solved_faces += double(newton.iterations) * m_problem.mesh.number_of_faces();
    result.map.energy = is_bijective(result.chart, result.map.uv) ? newton.energy : std::numeric_limits<double>::infinity();
    return result;
  }

  const Problem& m_problem;
  const Context m_context;
  Slit_search m_slits;
  const std::vector<double> m_reference; // per vertex of the surface
  std::vector<char> m_is_excluded;       // per vertex of the surface
  double m_least_gain_per_cost = 0;
  double m_number_of_solved_faces = 0;
  std::optional<Injective_cut> m_enough; // the cheapest that was found to reach the goal
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_REFINEMENT_INJECTIVE_REFINER_H
