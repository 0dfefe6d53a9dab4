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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_COMPONENT_CUTTER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_COMPONENT_CUTTER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/Coarse_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/Component_result.h>
#include <CGAL/Surface_mesh_cutting/internal/Cut_refiner.h>
#include <CGAL/Surface_mesh_cutting/internal/Feature_detector.h>
#include <CGAL/Surface_mesh_cutting/internal/final_map.h>
#include <CGAL/Surface_mesh_cutting/internal/Flat_component.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// The whole method for one connected surface (paper, Section 3): handles, features, connection and,
// on request, refinement and UVs. The features of a large surface are found on a coarser version
// of it, at a cost that no longer grows with the surface, and connected on the surface itself.
template <typename ConcurrencyTag>
class Component_cutter
{
  using Refiner = Cut_refiner<ConcurrencyTag>;

  static constexpr double ideal = Symmetric_Dirichlet_energy::ideal;

  // The surface at one resolution.
  struct Resolution
  {
    const Flat_mesh& mesh;
    const std::vector<Rest_shape> shapes;
    Edge_constraints constraints;
    const std::vector<int> terminals;

    Resolution(const Flat_mesh& m, Edge_constraints c, std::vector<int> t, double lowest_face)
      : mesh(m), shapes(Surface_mesh_parameterization::internal::rest_shapes(m.triangles(), m.points(), lowest_face)),
        constraints(std::move(c)), terminals(std::move(t))
    {}
  };

public:
  // Nothing is mandatory, and some cut satisfies the constraints (`keep_one_island()`).
  Component_cutter(const Flat_component& component, const Edge_constraints& constraints,
                   const std::vector<int>& terminals, const Initial_cut& initial,
                   const Cutting_parameters& parameters, Run_control& control, Phase_clock& clock)
    : m_is_sphere(component.topology.genus() == 0 && component.topology.border_loops == 0),
      m_parameters(parameters), m_control(control), m_clock(clock),
      m_fine(component.mesh, constraints, terminals, Surface_mesh_parameterization::internal::minimal_height), m_initial(initial)
  {}

  Component_result detect()
  {
    Component_result result;
    result.status = cut_handles_of(m_fine);
    if(result.status)
      result.features = find_features(0, result).features;
    return result;
  }

  // Runs from as many starts as the parameters say. The best is the shortest of those whose energy
  // is within epsilon_iso of the lowest, if possible among those that keep the bound.
  Component_result run(bool needs_uv)
  {
    Component_result best;
    best.status = cut_handles_of(m_fine);
    if(!best.status)
      return best;
    const bool needs_map = needs_uv || m_parameters.number_of_starts > 1;
    std::vector<Component_result> results;
    for(int i = 0; i < m_parameters.number_of_starts && m_control.go_further(); ++i)
    {
      Component_result result = run_from(i, needs_map);
      if(!result.has_cut && results.empty())
        return result;
      if(result.has_cut)
        results.push_back(std::move(result));
    }
    if(results.empty())
    {
      best.status = failure(m_control);
      return best;
    }
    return best_of(results);
  }

private:
  bool has_bound() const { return m_parameters.maximum_distortion < std::numeric_limits<double>::infinity(); }

  Component_result best_of(std::vector<Component_result>& results) const
  {
    double lowest = std::numeric_limits<double>::infinity();
    for(const Component_result& r : results)
      lowest = (std::min)(lowest, r.energy);
    const double limit = has_bound() ? (std::max)(m_parameters.maximum_distortion, lowest)
                                     : lowest + m_parameters.minimum_distortion_decrease;
    Component_result* best = nullptr;
    for(Component_result& r : results)
      if(r.energy <= limit && (best == nullptr || r.length < best->length))
        best = &r;
    return std::move(*best);
  }

  Flat_status cut_handles_of(Resolution& resolution)
  {
    if(m_is_sphere)
      return Flat_status();
    const Phase_clock::Measurement measurement(m_clock, Phase::CANDIDATES);
    Handle_loops handles = cut_handles(resolution.mesh, m_initial.is_given() && &resolution == &m_fine
                                                          ? m_initial.guide(resolution.constraints)
                                                          : resolution.constraints,
                                       [this] { return m_control.go_further(); });
    resolution.constraints.mandatory = std::move(handles.cut);
    return handles.status;
  }

  Component_result run_from(int start, bool needs_map)
  {
    Component_result result;
    Detected_features detected = find_features(start, result);
    if(!result.status)
      return result;
    Refiner refiner = make_refiner(m_fine);
    if(!connect(refiner, std::move(detected.features), result) || !(needs_map || refines(m_fine)))
      return result;
    if(!map(refiner, result))
      return result;
    keep_filtered_cut(refiner, std::move(detected.chart));
    refine_and_parameterize(refiner, result);
    result.add(refiner.trade_offs());
    result.keep_undominated_trade_offs();
    return result;
  }

  // Where connecting the features loses too much, the filter's own cut is better. It does not exist on the
  // surface itself if the features were found on a coarser version.
  void keep_filtered_cut(Refiner& refiner, Open_chart filtered) const
  {
    if(refiner.chart().energy > m_energy_to_regain && !m_initial.is_given() && !is_coarsened())
      refiner.replace_tree(std::move(filtered));
  }

  Refiner make_refiner(const Resolution& resolution)
  {
    return Refiner(resolution.mesh, resolution.shapes, resolution.constraints, resolution.terminals,
                   m_parameters, m_control);
  }

  // A mesh only little larger than the target would not become much simpler. A given cut lies on the
  // surface itself.
  bool is_coarsened() const
  {
    return m_parameters.coarse_number_of_faces > 0 && !m_initial.is_given() &&
           4 * m_fine.mesh.number_of_faces() > 5 * m_parameters.coarse_number_of_faces;
  }

  bool refines(const Resolution& resolution) const
  {
    return has_bound() || m_initial.is_given() ||
           (m_parameters.number_of_shortening_solves > 0 && !(is_coarsened() && &resolution == &m_fine));
  }

  Detected_features find_features(int start, Component_result& result)
  {
    return is_coarsened() ? find_features_on_coarse_mesh(start, result)
                          : find_features_of(m_fine, m_parameters, start, result);
  }

  Detected_features find_features_of(const Resolution& resolution, const Cutting_parameters& parameters, int start,
                                     Component_result& result)
  {
    Detected_features detected
      = Feature_detector<ConcurrencyTag>(resolution.mesh, resolution.shapes, m_is_sphere,
                                         resolution.constraints, resolution.terminals, m_initial,
                                         parameters, m_control, m_clock).run(start);
    result.status = detected.status;
    result.candidates = detected.number_of_candidates;
    result.add(detected.trade_offs);
    if(!detected.trade_offs.empty() && (m_initial.is_given() || !parameters.is_faithful))
      m_energy_to_regain = m_initial.is_given()
                           ? detected.trade_offs.front().E_iso + m_parameters.minimum_distortion_decrease
                           : 2 * detected.trade_offs.back().E_iso;
    return detected;
  }

  // Ignores constraints; unreachable features are removed when lifted. Also refines here, where that is
  // cheap.
  Detected_features find_features_on_coarse_mesh(int start, Component_result& result)
  {
    const Coarse_mesh coarse = [&]
    {
      const Phase_clock::Measurement measurement(m_clock, Phase::CANDIDATES);
      return Coarse_mesh(m_fine.mesh, m_parameters.coarse_number_of_faces / 2);
    }();
    Resolution resolution(coarse.mesh, unconstrained(coarse.mesh), {},
                          Surface_mesh_parameterization::internal::minimal_coarse_height);
    result.status = cut_handles_of(resolution);
    if(!result.status)
      return {};
    Detected_features detected = find_features_of(resolution, parameters_on_coarse_mesh(), start, result);
    if(result.status && refines(resolution))
    {
      const Phase_clock::Measurement measurement(m_clock, Phase::REFINE);
      Refiner refiner = make_refiner(resolution);
      if(refiner.connect(detected.features) && refiner.map())
      {
        constexpr bool keeps_tree = true; // only the features are handed on
        refine(refiner, m_parameters.number_of_shortening_solves, m_parameters.maximum_distortion, keeps_tree);
        detected.features = refiner.features();
      }
      result.add(refiner.trade_offs());
      if(m_control.is_stopped())
        result.status = failure(m_control);
    }
    detected.features = lifted(coarse, detected.features);
    detected.chart = Open_chart();
    return detected;
  }

  // A coarse map does not resolve all that a slit gains around its end. Asked for the same gain, it keeps too few
  // features: measured at full resolution, the energy is as low as that of features found there with this factor.
  Cutting_parameters parameters_on_coarse_mesh() const
  {
    constexpr double resolved_gain = 0.85;
    Cutting_parameters result = m_parameters;
    result.minimum_distortion_decrease *= resolved_gain;
    result.decrease_per_length *= resolved_gain;
    return result;
  }

  std::vector<int> lifted(const Coarse_mesh& coarse, const std::vector<int>& features) const
  {
    const std::vector<char> is_reachable = reachable_vertices(m_fine.mesh, m_fine.constraints);
    std::vector<int> result = m_fine.terminals;
    for(int v : features)
      if(is_reachable[coarse.vertices[v]])
        result.push_back(coarse.vertices[v]);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  bool connect(Refiner& refiner, std::vector<int> features, Component_result& result)
  {
    const Phase_clock::Measurement measurement(m_clock, Phase::CONNECT);
    m_control.report(Phase::CONNECT, 0);
    result.status = refiner.connect(std::move(features));
    if(m_control.is_stopped())
      result.status = failure(m_control);
    if(!result.status)
      return false;
    take_cut(refiner, refiner.tree().cut, result);
    m_control.report(Phase::CONNECT, 1);
    return true;
  }

  void take_cut(const Refiner& refiner, const Cut& cut, Component_result& result) const
  {
    const Connected_cut& tree = refiner.tree();
    result.has_cut = true;
    result.features = refiner.features();
    std::sort(result.features.begin(), result.features.end());
    result.cut = cut;
    result.length = cut_length(m_fine.mesh, cut);
    result.lower_bound = cut_length(m_fine.mesh, m_fine.constraints.mandatory);
    if(refiner.is_connected())
      result.lower_bound += tree.lower_bound;
    result.is_optimal = refiner.is_connected() && tree.is_optimal && cut == tree.cut;
    result.auxiliary = tree.number_of_auxiliary_points;
  }

  bool map(Refiner& refiner, Component_result& result)
  {
    const Phase_clock::Measurement measurement(m_clock, Phase::PARAMETERIZE);
    m_control.report(Phase::PARAMETERIZE, 0);
    // At full resolution a second solve costs more than the precision that refinement does not need.
    if(refines(m_fine) ? refiner.map() : refiner.map(Newton_options().decrement))
      return true;
    result.status = failure(m_control);
    result.has_cut = false;
    return false;
  }

  // A bijective map may miss a bound that the running map keeps; then the cut has to be longer.
  void refine_and_parameterize(Refiner& refiner, Component_result& result)
  {
    const int solves = is_coarsened() ? m_parameters.number_of_corrective_solves
                                      : m_parameters.number_of_shortening_solves;
    refine_and_parameterize(refiner, m_parameters.maximum_distortion, solves, result);
    if(has_bound() && m_parameters.do_bijective && result.energy > m_parameters.maximum_distortion)
      tighten(refiner, result);
    if(result.status && result.energy > m_parameters.maximum_distortion)
      result.status = bound_missed();
  }

  void refine_and_parameterize(Refiner& refiner, double bound, int number_of_solves, Component_result& result)
  {
    if(refines(m_fine) || refiner.chart().energy > m_energy_to_regain)
    {
      const Phase_clock::Measurement measurement(m_clock, Phase::REFINE);
      m_control.report(Phase::REFINE, 0);
      refine(refiner, number_of_solves, bound);
      m_control.report(Phase::REFINE, 1);
    }
    take_cut(refiner, refiner.chart().cut, result);
    parameterize(refiner, result);
  }

  // Looks for the shortest cut whose bijective map keeps the bound: bisection over what is asked of
  // the running map, between what failed and what did not.
  void tighten(const Refiner& start, Component_result& best)
  {
    constexpr int maximum_number_of_rounds = 6, solves = 10;
    // As long as no round keeps the bound: about twenty seconds, after which none has been seen to keep it.
    constexpr double maximum_number_of_solved_faces = 5e6;
    double number_of_solved_faces = 0;
    const double bound = m_parameters.maximum_distortion, precision = 0.02 * (bound - ideal);
    // Down by what is missing, and not by less than a tenth nor by more than half of what is left.
    const auto lowered = [&](double former, double missing)
    { return (std::max)(former - (std::max)(missing, 0.1 * (bound - ideal)), (former + ideal) / 2); };
    double failed = bound, kept = ideal, target = lowered(bound, best.energy - bound);
    for(int round = 0; round < maximum_number_of_rounds && failed - kept > precision && best.status; ++round)
    {
      if(kept == ideal && number_of_solved_faces > maximum_number_of_solved_faces)
        return;
      Refiner refiner = start;
      Component_result result = best;
      refine_and_parameterize(refiner, target, solves, result);
      number_of_solved_faces += double(refiner.trade_offs().size()) * m_fine.mesh.number_of_faces();
      result.add(refiner.trade_offs());
      const bool is_kept = result.has_map && result.energy <= bound;
      (is_kept ? kept : failed) = target;
      target = kept > ideal ? (kept + failed) / 2 : lowered(target, result.energy - bound);
      if(is_kept ? best.energy > bound || result.length < best.length
                 : result.has_map && result.energy < best.energy && best.energy > bound)
        best = std::move(result);
      else
        best.trade_offs = std::move(result.trade_offs);
    }
  }

  // Lowers the energy to the bound if there is one, then shortens. Without a bound, what the tree
  // through the features loses against the filter's cut, or a given one, is gained back where it pays.
  void refine(Refiner& refiner, int number_of_solves, double bound, bool keeps_tree = false)
  {
    Refinement_limits limits;
    limits.keeps_tree = keeps_tree;
    limits.number_of_solves = number_of_solves;
    if(has_bound())
    {
      refiner.lower_to(bound);
      limits.energy = (std::max)(bound, refiner.chart().energy);
    }
    else
    {
      refiner.lower_to(m_energy_to_regain, m_parameters.decrease_per_length);
      limits.energy = refiner.chart().energy + m_parameters.minimum_distortion_decrease;
      limits.energy_per_length = m_parameters.decrease_per_length;
    }
    refiner.shorten(limits);
  }

  void parameterize(const Refiner& refiner, Component_result& result)
  {
    const Phase_clock::Measurement measurement(m_clock, Phase::PARAMETERIZE);
    result.chart = refiner.chart().chart;
    const Newton_result newton
      = final_map(m_fine.mesh, m_fine.shapes, refiner.chart(), m_parameters, m_control, result.uv);
    result.energy = newton.energy;
    result.has_map = newton.outcome != Newton_outcome::FAILED;
    if(!result.has_map || m_control.is_stopped())
      result.status = failure(m_control);
    m_control.report(Phase::PARAMETERIZE, 1);
  }

  const bool m_is_sphere;
  const Cutting_parameters& m_parameters;
  Run_control& m_control;
  Phase_clock& m_clock;
  Resolution m_fine;
  const Initial_cut m_initial;
  // Repair is attempted above about the energy of a given cut, or above twice the filter's energy, which
  // occurs on needle triangles.
  double m_energy_to_regain = std::numeric_limits<double>::infinity();
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_COMPONENT_CUTTER_H
