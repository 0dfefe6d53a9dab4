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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_INCREMENTAL_PARAMETERIZATION_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_INCREMENTAL_PARAMETERIZATION_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/context/work.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Kept_solver.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Local_window.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Mapping_policy.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Open_chart.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/carry_over.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/vertex_distortion.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Cut.h>

#include <CGAL/Surface_mesh_parameterization/internal/Chart_parameterizer.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Execution.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using Surface_mesh_parameterization::internal::Chart_parameterizer;
using Surface_mesh_parameterization::internal::Newton_options;
using Surface_mesh_parameterization::internal::Newton_outcome;
using CGAL::internal::Graph_kernel::Go_further;
using Surface_mesh_parameterization::internal::Newton_result;
using Surface_mesh_parameterization::internal::Newton_solver;
using Surface_mesh_parameterization::internal::Newton_state;
using Surface_mesh_parameterization::internal::Rest_shape;
using Surface_mesh_parameterization::internal::Symmetric_Dirichlet_energy;
using Surface_mesh_parameterization::internal::area_weights;
using Surface_mesh_parameterization::internal::hopeless_energy;

// The isometric map that accompanies a growing cut. Opening a slit splits vertices in place: the map
// stays flip-free and keeps its energy, so that every solve starts warm.
class Incremental_parameterization
{
public:
  // `go_further` may also end the work on a single slit; call `restore()` then.
  Incremental_parameterization(const Indexed_mesh& mesh, const std::vector<Rest_shape>& shapes, const Mapping_policy& policy,
              Go_further go_further)
    : m_mesh(mesh), m_shapes(shapes), m_policy(policy), m_weights(area_weights(shapes)),
      m_go_further(std::move(go_further)), m_window(mesh)
  {}

  // Maps another cut that leaves one disk, if possible from the map that there is. False if no flip-free map was found,
  // if its energy is above `bound`, or if the run was stopped; then the state is of no use.
  bool initialize(const Cut& cut, double bound = std::numeric_limits<double>::infinity())
  { return initialize(cut, bound, m_policy.precision); }
  // The same with another precision, see `Newton_options::decrement`.
  bool initialize(const Cut& cut, double bound, double precision)
  {
    m_solver.pointer.reset();
    const bool is_carried = open_along(cut);
    Chart_parameterizer parameterizer(m_state.chart, chart_points(m_mesh, m_state.chart), m_shapes, m_policy.linear_solvers,
                                      m_state.chart_ranks());
    Newton_options o = options();
    o.decrement = precision;
    o.stop = [bound](const Newton_state& s) { return s.is_out_of_reach(bound); };
    const bool is_mapped = (is_carried && map_from_carried(parameterizer, o)) || map_from_nothing(parameterizer, o);
    if(is_mapped)
      m_state.take_ranks(parameterizer.positions(), m_mesh.number_of_vertices());
    return is_mapped && m_state.energy <= bound && m_go_further();
  }

  const Cut& cut() const { return m_state.cut; }
  const Corner_table& chart() const { return m_state.chart; }
  const std::vector<Eigen::Vector2d>& uv() const { return m_state.uv; }
  double energy() const { return m_state.energy; }
  const Mapping_policy& policy() const { return m_policy; }

  // What there is can be kept and put back.
  const Open_chart& state() const { return m_state; }
  void restore(Open_chart state)
  {
    m_solver.pointer.reset();
    m_state = std::move(state);
  }

  // Opens the slit if this lowers the energy by more than `threshold`, and converges; otherwise the
  // state is as before. `slit` holds edges.
  bool open_if_useful(const std::vector<int>& slit, double threshold)
  {
    const bool is_open = try_slit(slit, threshold);
    if(is_open)
      converge();
    return is_open;
  }

  // The same without converging, which is left to the caller.
  bool try_slit(const std::vector<int>& slit, double threshold)
  {
    const Trial trial = begin(slit);
    return end(trial, slit, is_useful(slit, threshold) && m_go_further());
  }

  // Opens the slit if windows around it gain more than `threshold` with the rest held fixed. Nothing else is solved:
  // what several slits gain, in one place each, adds up, and `converge()` follows once for all.
  bool open_if_locally_useful(const std::vector<int>& slit, double threshold)
  {
    const Trial trial = begin(slit);
    return end(trial, slit, judge_locally(slit, threshold) == Verdict::USEFUL);
  }

  // Whether no cut seems to lead to a useful map. Then every slit gains: searches for slits need a limit.
  bool is_hopeless() const { return m_state.energy > hopeless_energy; }

  // Whether the map is hopeless after so much work on such maps that no more is worth it.
  bool is_given_up() const { return is_hopeless() && m_hopeless_solved_faces > work_of_stage; }

  // Far from the optimum, which a slit that changes much can leave the map, starting anew through
  // the hierarchy takes fewer solves than going on. A hopeless map came from there already; the paper
  // always goes on.
  void converge()
  {
    constexpr int patience = 6; // factorizations: one suffices near the optimum; hopeless maps get no more
    const bool may_start_anew = m_policy.first_map == First_map::HIERARCHY;
    Newton_options o = options();
    if(may_start_anew)
      o.maximum_iterations = patience;
    Newton_result result = solve(o);
    if(may_start_anew && result.outcome == Newton_outcome::ITERATION_LIMIT && result.energy <= hopeless_energy)
    {
      std::vector<Eigen::Vector2d> warm_uv = m_state.uv;
      Chart_parameterizer parameterizer(m_state.chart, chart_points(m_mesh, m_state.chart), m_shapes,
                                        m_policy.linear_solvers, m_state.chart_ranks());
      const Newton_result cold = parameterizer.isometric_map(m_state.uv, options());
      if(cold.energy < result.energy)
        result = cold;
      else
      {
        m_state.uv.swap(warm_uv);
        result = solve(options());
      }
    }
    take_energy(result);
    m_state.precision = m_policy.precision;
    m_solver.pointer.reset(); // the next map is another one
  }

  // Opens the slit in any case, unless the run was stopped.
  void open(const std::vector<int>& slit)
  {
    if(end(begin(slit), slit, m_go_further()))
      converge();
  }

  // About what opening the slit would gain, mostly a little less: what the window of twice its length
  // (less if that is large) gains with the rest held fixed. The state stays as it is.
  double estimate_gain(const std::vector<int>& slit)
  {
    const Trial trial = begin(slit);
    constexpr int number_of_radii = 3; // down to half the slit's length; also the solves instead of a window
    double radius = 2 * total_length(m_mesh, slit);
    bool is_small = false;
    for(int i = 0; i < number_of_radii && !is_small; ++i, radius /= 2)
      is_small = m_window.collect(slit, radius);
    double gain = 0;
    if(is_small)
      gain = solve_window(std::numeric_limits<double>::infinity(), 0);
    else // the slit is long against the chart; a few steps on the whole of it tell as much
    {
      Newton_options o = options();
      o.maximum_iterations = number_of_radii;
      gain = m_state.energy - solve(o).energy;
    }
    take_back(trial);
    return gain;
  }

  // The distortion of each surface vertex (paper, Equation (3)).
  std::vector<double> vertex_distortion() const
  {
    return internal::vertex_distortion(m_mesh, m_shapes, m_state.chart, m_state.uv);
  }

private:
  // Opens the surface along another cut. Whether its map came along.
  bool open_along(const Cut& cut)
  {
    const Open_chart former = std::move(m_state);
    m_state = Open_chart();
    m_state.cut = cut;
    m_state.chart = make_chart(m_mesh, cut);
    return m_policy.first_map == First_map::HIERARCHY && former.energy <= hopeless_energy &&
           carry_over(m_mesh, former, m_state);
  }

  // From the map in `m_state.uv`. False if that takes long or fails. Where triangles are stretched, the Hessian is far
  // stiffer than it becomes, and decrements are too small to tell anything: it is taken again near the optimum.
  bool map_from_carried(Chart_parameterizer& parameterizer, Newton_options o)
  {
    constexpr int enough_factorizations = 3;
    constexpr double near = 1e-2, nearer = 1e-3; // decrements, of the energy
    Newton_options first = options();
    first.decrement = near;
    first.maximum_iterations = o.maximum_iterations = enough_factorizations;
    // What is stopped further from its optimum would pass for a map that is worse than it can be.
    o.stop = [=, stop = o.stop](const Newton_state& s) { return s.decrement < nearer * s.energy && stop(s); };
    if(!improve(parameterizer, first).is_converged())
      return false;
    const Newton_result result = improve(parameterizer, o);
    return result.is_converged() || result.outcome == Newton_outcome::STOPPED;
  }

  bool map_from_nothing(Chart_parameterizer& parameterizer, const Newton_options& o)
  {
    const auto map_from = [&](First_map first_map)
    {
      return parameterizer.isometric_start(m_state.uv, o, first_map) &&
             improve(parameterizer, o).outcome != Newton_outcome::FAILED;
    };
    constexpr int small = 250; // vertices: of the hierarchy, the first stage would be the whole chart, and solved twice
    const First_map first_map = m_state.chart.number_of_vertices() <= small ? First_map::TUTTE : m_policy.first_map;
    return map_from(first_map) && (first_map != First_map::TUTTE || !is_hopeless() || map_from(First_map::HIERARCHY));
  }

  Newton_result improve(Chart_parameterizer& parameterizer, const Newton_options& o)
  {
    const Newton_result result = parameterizer.improve_isometrically(m_state.uv, o);
    take_energy(result);
    if(result.outcome == Newton_outcome::CONVERGED)
      m_state.precision = o.decrement;
    return result;
  }

  void take_energy(const Newton_result& result)
  {
    m_state.energy = result.energy;
    if(is_hopeless())
      m_hopeless_solved_faces += double(result.iterations) * m_mesh.number_of_faces();
  }

  // A slit that was opened and may be closed again.
  struct Trial
  {
    Corner_table::Opening opening;
    std::vector<Eigen::Vector2d> former_uv;
  };

  Trial begin(const std::vector<int>& slit)
  {
    m_solver.pointer.reset();
    std::vector<int> halfedges;
    for(int e : slit)
      halfedges.push_back(m_mesh.halfedge(e));
    Trial trial{m_state.chart.open(halfedges), m_state.uv};
    m_state.uv.resize(m_state.chart.number_of_vertices());
    for(const auto& [corner, former] : trial.opening.corners)
      m_state.uv[m_state.chart.source(corner)] = trial.former_uv[former];
    return trial;
  }

  void take_back(const Trial& trial)
  {
    m_solver.pointer.reset();
    m_state.chart.close(trial.opening);
    m_state.uv = trial.former_uv;
  }

  // Returns `is_kept`.
  bool end(const Trial& trial, const std::vector<int>& slit, bool is_kept)
  {
    if(!is_kept)
      take_back(trial);
    else
      for(int e : slit)
        m_state.cut[e] = 1;
    return is_kept;
  }

  Newton_options options()
  {
    Newton_options o;
    o.decrement = m_policy.precision;
    o.go_further = m_go_further;
    return o;
  }

  enum class Verdict { USEFUL, USELESS, UNCLEAR };

  // Decides from windows around the slit that grow until the answer is clear. What a window gains with the
  // rest held fixed is a part of the full gain, the larger the window is. How small a part was measured for 600 slits:
  // where the full gain was more than the threshold, at most six times that of the first window, four times that of the
  // second, and three times those of larger ones missed it four times in all. The first one, which decides two thirds of
  // all, is for estimates alone.
  Verdict judge_locally(const std::vector<int>& slit, double threshold)
  {
    constexpr double first_radius = 0.5, last_radius = 4; // in lengths of the slit
    constexpr double least_factor = 3;                    // between the full gain and that of a large window
    const double length = total_length(m_mesh, slit);
    double gain = 0;
    for(double radius = m_policy.uses_estimates ? first_radius : 2 * first_radius; radius <= last_radius; radius *= 2)
    {
      if(!m_window.collect(slit, radius * length))
        break;
      gain += solve_window(threshold, gain);
      if(gain > threshold || !m_go_further())
        return Verdict::USEFUL;
      const double largest_factor = least_factor * (1 + first_radius / radius);
      if(m_policy.uses_estimates && largest_factor * gain < threshold)
        return Verdict::USELESS;
    }
    return Verdict::UNCLEAR;
  }

  // What windows leave unclear, the whole chart decides.
  bool is_useful(const std::vector<int>& slit, double threshold)
  {
    const Verdict verdict = judge_locally(slit, threshold);
    return verdict == Verdict::UNCLEAR ? is_globally_useful(threshold) : verdict == Verdict::USEFUL;
  }

  bool is_globally_useful(double threshold)
  {
    const double target = m_state.energy - threshold;
    bool is_decided = false, is_useful = false;
    Newton_options o;
    o.go_further = m_go_further;
    o.stop = [&](const Newton_state& s)
    {
      is_useful = s.energy < target;
      is_decided = is_useful || (m_policy.uses_estimates && s.is_out_of_reach(target));
      return is_decided;
    };
    const Newton_result result = solve(o);
    return is_decided ? is_useful : result.energy < target;
  }

  Newton_result solve(const Newton_options& o)
  {
    if(!m_solver.pointer)
      m_solver.pointer
        = std::make_unique<Newton_solver>(m_state.chart.triangles(), m_state.chart.number_of_vertices(),
                                          m_policy.linear_solvers, std::vector<char>(), m_state.chart_ranks());
    return m_solver.pointer->minimize<Symmetric_Dirichlet_energy>(m_shapes, m_weights, m_state.uv, o);
  }

  // Solves the window with the rest held fixed; returns the gain. Ends as soon as the total gain is
  // above the threshold.
  double solve_window(double threshold, double gain_so_far)
  {
    Local_window::System window = m_window.system(m_state, m_shapes, m_weights);
    Newton_solver solver(std::move(window.triangles), int(window.vertices.size()), m_policy.linear_solvers,
                         std::move(window.is_fixed), m_state.ranks_of(window.vertices));
    const double before = solver.energy<Symmetric_Dirichlet_energy>(window.shapes, window.weights, window.uv);
    constexpr double decided = 0.01;  // of the threshold: what is left no longer matters
    constexpr double estimated = 0.1; // of the gain so far: slits differ by more
    Newton_options o;
    o.go_further = m_go_further;
    o.stop = [&](const Newton_state& s)
    {
      const double tolerance = std::isfinite(threshold) ? decided * threshold : estimated * (before - s.energy);
      return gain_so_far + before - s.energy > threshold || s.decrement < tolerance;
    };
    const Newton_result result
      = solver.minimize<Symmetric_Dirichlet_energy>(window.shapes, window.weights, window.uv, o);
    for(std::size_t i = 0; i < window.vertices.size(); ++i)
      m_state.uv[window.vertices[i]] = window.uv[i];
    return before - result.energy;
  }

  const Indexed_mesh& m_mesh;
  const std::vector<Rest_shape>& m_shapes;
  Mapping_policy m_policy;
  std::vector<double> m_weights;
  Go_further m_go_further;
  Open_chart m_state;
  Kept_solver m_solver;  // of the whole chart as it is, once there was need for it
  Local_window m_window; // in work
  double m_hopeless_solved_faces = 0;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_MAPPING_INCREMENTAL_PARAMETERIZATION_H
