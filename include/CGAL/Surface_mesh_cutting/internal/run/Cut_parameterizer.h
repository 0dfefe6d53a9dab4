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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_CUT_PARAMETERIZER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_CUT_PARAMETERIZER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/mapping/final_map.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Chart_division.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Chart_joining.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/End_search.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Injective_refiner.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Injective_trimmer.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Working_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/result/Component_result.h>
#include <CGAL/Surface_mesh_cutting/internal/run/coarse_slits.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Makes the map to return from a mapped cut. Where it must not overlap and the plane has too little room, slits let
// parts turn aside, or seams divide several charts.
class Cut_parameterizer
{
public:
  static constexpr double tolerance = 0.0195; // of the energy, without a bound: less is not worth a longer cut

  // The references are kept.
  Cut_parameterizer(const Problem& problem, const Context& context) : m_problem(problem), m_context(context) {}

  // Takes the running cut and maps it, without overlaps on request. A map without overlaps that becomes hopeless is given up.
  void operator()(const Working_cut& cut, Component_result& result) const
  {
    take_cut(cut, cut.chart().cut, result);
    if(!divide_at_once(cut, result))
      map(cut.chart(), may_divide() ? hopeless : infinity, result);
  }

  // Maps the running cut whatever the energy.
  void map_in_any_case(const Open_chart& running, Component_result& result) const { map(running, infinity, result); }

  // What is known of `edges`, a cut made from a working one.
  void take_cut(const Working_cut& cut, const Cut& edges, Component_result& result) const
  {
    const Connected_cut& tree = cut.tree();
    result.has_cut = true;
    result.features = cut.features();
    std::sort(result.features.begin(), result.features.end());
    result.cut = edges;
    result.length = cut_length(m_problem.mesh, edges);
    result.cost = cut_cost(m_problem.constraints, edges);
    result.lower_bound = mandatory_length();
    if(cut.is_connected() && !m_problem.is_opened) // of whose opening no length is proven
      result.lower_bound += tree.lower_bound;
    result.is_tree_proven = !m_problem.is_opened && tree.is_optimal;
    result.is_optimal = result.is_tree_proven && cut.is_connected() && edges == tree.cut;
    result.number_of_auxiliary_points = tree.number_of_auxiliary_points;
  }

  // Opens slits until the energy of the map without overlaps is at most `goal`, if that is possible: where the plane
  // has no room for all of the chart's parts, they let some turn aside.
  void relieve(const Open_chart& overlapping, double goal, Component_result& result) const
  {
    if(!result.has_map || result.energy <= goal)
      return;
    const std::size_t former_ends = result.features.size();
    Injective_cut injective = injective_cut(result);
    Injective_refiner refiner(m_problem, m_context, overlapping);
    if(has_coarse_slits(m_problem, m_context.parameters))
      refiner.open_to(coarse_slits(m_problem, m_context, overlapping.chart, result.energy - goal), goal, injective);
    refiner.lower_to(goal, injective, Objective(m_context.parameters).least_gain_per_cost());
    result.is_optimal = result.is_optimal && injective.ends.size() == former_ends;
    take(std::move(injective), result);
  }

  // Closes what the cut does not need by the map without overlaps.
  void trim(const Objective& objective, Component_result& result) const
  {
    Injective_cut injective = injective_cut(result);
    Injective_trimmer(m_problem, m_context).trim(objective, injective);
    take_other_ends(std::move(injective), result);
  }

  // Moves ends and ways of a cut, by the energy of its map without overlaps: where parts are in each other's way, cuts that
  // hardly differ need more room or less, and slits for room start where the cut happened to be near. Opens slits again while
  // the energy is above `goal`. False if the former cut stays, which is no worse then.
  bool move_ends_and_ways(const Objective& objective, double goal, Component_result& result) const
  {
    constexpr double step = 0.1; // of the length of the cut
    Working_cut cut(m_problem, m_context);
    End_search search(m_problem, m_context.parameters, objective, false, cut);
    if(!search.can_move() || !cut.start_injectively(injective_cut(result)))
      return false;
    search.reroute();
    search.move_ends(step);
    search.reroute();
    Component_result moved = result;
    take_other_ends(injective_cut(cut.state()), moved);
    relieve(cut.chart(), goal, moved);
    if(search.best() && objective.rank(search.best()->cost, search.best()->energy()) < moved.rank(objective))
      take_other_ends(injective_cut(*search.best()), moved);
    if(!(moved.rank(objective) < result.rank(objective)))
      return false;
    result = std::move(moved);
    return true;
  }

  // Replaces the map by one without overlaps of several charts: parts of the given one, as many as it takes for an energy of
  // at most `goal` if that is possible. Without a bound, no seam costs more than what it gains is worth. False if edges that
  // must not be cut leave no way, if the given map does not converge, or if the run is stopped.
  bool divide(const Open_chart& overlapping, double goal, Component_result& result) const
  {
    Open_chart chart = overlapping;
    const Newton_result newton = converged_map(m_problem, overlapping, m_context, chart.uv);
    if(newton.outcome == Newton_outcome::FAILED)
      return false;
    const Chart_division division(m_problem, m_context, chart);
    if(!division.is_complete())
      return false;
    Chart_joining joining(m_problem, m_context, chart, division, hopeless);
    joining.join(goal, m_context.parameters.has_bound() ? infinity : m_context.parameters.decrease_per_cost);
    if(!m_context.control.is_stopped())
      result.status.finding = Finding(); // even if there was no map in one piece
    result.has_map = true;
    result.is_optimal = false;
    result.chart = make_chart(m_problem.mesh, joining.cut());
    take_cut_and_map(joining.cut(), {joining.uv(result.chart), joining.energy()}, result);
    return true;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double hopeless = 1000; // a map that is more distorted is far from what slits lead to

  void map(const Open_chart& running, double hopeless_energy, Component_result& result) const
  {
    result.chart = running.chart;
    const Newton_result newton = final_map(m_problem, running, m_context, result.uv, hopeless_energy);
    result.energy = newton.energy;
    result.has_map = newton.outcome != Newton_outcome::FAILED;
  }

  // Of what is cut in any case; of what opens a surface, no length is proven.
  double mandatory_length() const
  {
    return m_problem.is_opened ? 0 : cut_length(m_problem.mesh, m_problem.constraints.mandatory);
  }

  static Injective_cut injective_cut(const Component_result& result)
  {
    return {result.cut, result.chart, {result.uv, result.energy}, result.features};
  }

  static Injective_cut injective_cut(const Mapped_cut& cut)
  {
    return {cut.chart.cut, cut.chart.chart, *cut.injective, cut.features};
  }

  // Some of the ends that the tree was proven shortest for may be gone.
  void take_other_ends(Injective_cut injective, Component_result& result) const
  {
    result.lower_bound = mandatory_length();
    result.is_optimal = false;
    take(std::move(injective), result);
  }

  void take(Injective_cut injective, Component_result& result) const
  {
    take_cut_and_map(std::move(injective.cut), std::move(injective.map), result);
    result.features = std::move(injective.ends);
    std::sort(result.features.begin(), result.features.end());
    result.chart = std::move(injective.chart);
  }

  void take_cut_and_map(Cut cut, Injective_map map, Component_result& result) const
  {
    result.cut = std::move(cut);
    result.length = cut_length(m_problem.mesh, result.cut);
    result.cost = cut_cost(m_problem.constraints, result.cut);
    result.uv = std::move(map.uv);
    result.energy = map.energy;
  }

  bool may_divide() const { return m_context.parameters.do_bijective && !m_context.parameters.use_published_method; }

  // Where a map lies in so many layers, nobody needs to try one in one piece: at best, it would be distorted beyond use.
  bool divide_at_once(const Working_cut& cut, Component_result& result) const
  {
    constexpr double layers = 2; // on average over the box around it
    if(!may_divide())
      return false;
    const Open_chart& running = cut.chart();
    Surface_mesh_parameterization::internal::Bounding_box<2> box;
    for(const Eigen::Vector2d& p : running.uv)
      box.add(p);
    const Eigen::Vector2d size = box.size();
    if(Surface_mesh_parameterization::internal::chart_area(running.chart.triangles(), running.uv)
       < layers * size.x() * size.y())
      return false;
    const Cutting_parameters& parameters = m_context.parameters;
    return divide(running, parameters.has_bound() ? parameters.maximum_average_distortion : running.energy + tolerance, result);
  }

  const Problem& m_problem;
  const Context m_context;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_CUT_PARAMETERIZER_H
