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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_SOLVER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Star_relaxation.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/flip_barrier.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Go_further.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

using CGAL::internal::Graph_kernel::Go_further;
using CGAL::internal::Graph_kernel::always_go_further;

// SINGULAR: factorization failed, map valid. FAILED: map invalid.
enum class Newton_outcome { CONVERGED, STOPPED, ITERATION_LIMIT, STALLED, SINGULAR, FAILED };

// What is known after the direction of a step was found and before it is taken.
struct Newton_state
{
  int iteration;
  double energy;    // area-averaged
  double decrement; // g^T H^-1 g, about twice the gain that is left

  // Whether the energy will stay above `bound`. Far from convergence the decrement is too small, hence the factor.
  bool is_out_of_reach(double bound) const
  {
    constexpr double caution = 2;
    return energy - caution * decrement > bound;
  }
};

struct Newton_options
{
  int maximum_iterations = 200; // factorizations
  double decrement = 1e-6; // as a fraction of the energy
  double least_decrease = 0; // relative decrease per factorization below which the iteration stops
  Go_further go_further = always_go_further;
  // Whether what is known decides what the solve is for, so that the iteration may end.
  std::function<bool(const Newton_state&)> stop;
};

struct Newton_result
{
  Newton_outcome outcome = Newton_outcome::FAILED;
  int iterations = 0; // factorizations
  double energy = std::numeric_limits<double>::infinity();
  double decrement = std::numeric_limits<double>::infinity();

  // Whether the map is as good as the options asked for or as rounding allows.
  bool is_converged() const
  { return outcome == Newton_outcome::CONVERGED || outcome == Newton_outcome::STALLED; }
};

// KP-Newton [GSC18]: minimizes the area-averaged energy of a flip-free map by Newton's method with
// projected Hessians. Each step stays short of the first flip and satisfies Armijo's condition, so
// the energy never grows and no triangle ever flips. One object serves any number of solves over
// the same triangles; the symbolic factorization is kept.
class Newton_solver
{
public:
  // Vertices with `is_fixed` keep their place (empty: all are free; then the first vertex is pinned,
  // which costs nothing since the energies do not depend on translation). `ranks`: see `Newton_system`.
  Newton_solver(std::vector<Triangle> triangles, int number_of_vertices, const Solvers& linear_solvers,
                std::vector<char> is_fixed = {}, const std::vector<int>& ranks = {})
    : m_triangles(std::move(triangles)), m_linear_solvers(linear_solvers), m_execution(linear_solvers.execution),
      m_relaxation(m_execution), m_solver(linear_solvers.make())
  {
    if(std::find(is_fixed.begin(), is_fixed.end(), char(1)) == is_fixed.end() && !m_triangles.empty())
    {
      is_fixed.assign(number_of_vertices, 0);
      is_fixed[m_triangles.front()[0]] = 1;
    }
    m_system = Newton_system(m_triangles, number_of_vertices, is_fixed, m_execution, ranks,
                             [this](const Sparse_matrix& hessian)
                             {
                               if(hessian.cols() > 0)
                                 m_solver->analyze(hessian);
                             });
  }

  const std::vector<Triangle>& triangles() const { return m_triangles; }
  // See `Newton_system`.
  const std::vector<int>& positions() const { return m_system.positions(); }

  // `uv` holds a flip-free map and receives a better one. `weights` are the triangles' areas divided
  // by their sum, whatever the shapes' areas are: references may change, the measure does not.
  template <typename Energy>
  Newton_result minimize(const std::vector<Rest_shape>& shapes, const std::vector<double>& weights,
                         std::vector<Eigen::Vector2d>& uv, const Newton_options& options)
  {
    Newton_result result;
    result.energy = energy<Energy>(shapes, weights, uv);
    if(!std::isfinite(result.energy)) // the sums of `assemble()` do not see flips
      return result;
    if(m_system.number_of_unknowns() == 0)
    {
      result.outcome = Newton_outcome::CONVERGED;
      result.decrement = 0;
      return result;
    }
    // One more assembly may spare factorizations: worth it where these take most of the time.
    constexpr int large_system = 20000; // unknowns
    bool relaxes = m_system.number_of_unknowns() > large_system;
    std::optional<Newton_outcome> outcome;
    for(; !outcome; relaxes = false)
    {
      if(!find_direction<Energy>(shapes, weights, options, relaxes, uv, result))
      {
        result.energy = energy<Energy>(shapes, weights, uv);
        outcome = Newton_outcome::SINGULAR;
        break;
      }
      const double former = result.energy;
      outcome = use_factorization<Energy>(shapes, weights, options, uv, result);
      if(!outcome && former - result.energy < options.least_decrease * result.energy)
        outcome = Newton_outcome::CONVERGED;
      if(!outcome && result.iterations >= options.maximum_iterations)
        outcome = Newton_outcome::ITERATION_LIMIT;
    }
    result.outcome = *outcome;
    return result;
  }

  // The area-averaged energy; infinite if a triangle is not positive.
  template <typename Energy>
  double energy(const std::vector<Rest_shape>& shapes, const std::vector<double>& weights,
                const std::vector<Eigen::Vector2d>& uv) const
  {
    return reduce_blocks(m_execution, int(m_triangles.size()), 0., [&](int begin, int end)
    {
      double sum = 0;
      for(int f = begin; f < end; ++f)
      {
        const Triangle& t = m_triangles[f];
        sum += triangle_energy<Energy>(weights[f], shapes[f], uv[t[0]], uv[t[1]], uv[t[2]]);
      }
      return sum;
    }, std::plus<double>());
  }

private:
  struct Curvature_pair
  {
    Eigen::VectorXd step, gradient_change;
    double product = 0;
  };

  // How many further directions one factorization serves at most. With nested dissection it costs about the
  // square root of the number of unknowns times as much as a direction.
  int maximum_reuse() const
  {
    constexpr int least = 8, most = 30; // directions; L-BFGS keeps two vectors for each
    return std::clamp(int(std::sqrt(double(m_system.number_of_unknowns())) / 10), least, most);
  }

  // Assembles and solves for the Newton direction. The diagonal shift is relative to each entry: it
  // fixes the gauge (MIPS does not depend on scale and rotation) and grows only where rounding
  // makes the factorization of an ill-conditioned matrix fail. With `relaxes`, stars are relaxed first.
  template <typename Energy>
  bool find_direction(const std::vector<Rest_shape>& shapes, const std::vector<double>& weights, const Newton_options& options,
                      bool relaxes, std::vector<Eigen::Vector2d>& uv, Newton_result& result)
  {
    constexpr double gauge_shift = 1e-12, largest_shift = 1e-2, growth = 100;
    for(double shift = gauge_shift; shift <= largest_shift; shift *= growth)
    {
      result.energy = m_system.template assemble<Energy>(m_triangles, shapes, weights, uv, shift);
      if(!std::isfinite(result.energy))
        return false;
      if(relaxes && shift == gauge_shift && relax<Energy>(shapes, weights, options, uv, result))
        result.energy = m_system.template assemble<Energy>(m_triangles, shapes, weights, uv, shift);
      ++result.iterations;
      if(!m_linear_solvers.factorize(*m_solver, m_system.hessian()))
        continue;
      m_step = m_solver->solve(m_system.gradient());
      result.decrement = m_system.gradient().dot(m_step);
      if(std::isfinite(result.decrement) && result.decrement >= 0)
        return true;
    }
    return false;
  }

  // Whether stars were. Vertices are relaxed until their decrement is small against the tolerance and against the energy
  // of their star.
  template <typename Energy>
  bool relax(const std::vector<Rest_shape>& shapes, const std::vector<double>& weights, const Newton_options& options,
             std::vector<Eigen::Vector2d>& uv, const Newton_result& result)
  {
    constexpr double share_of_decrement = 0.1, share_of_star = 0.01;
    const double mean_star = 3 / double(uv.size()); // of the area, about
    const double threshold = (std::max)(share_of_decrement * options.decrement, share_of_star * mean_star) * result.energy;
    return m_relaxation.relax<Energy>(m_triangles, shapes, weights, threshold, m_system, uv) > 0;
  }

  // Steps while the factorization at hand gives good directions, of which the first is known. The outcome, if that ends
  // the iteration.
  template <typename Energy>
  std::optional<Newton_outcome> use_factorization(const std::vector<Rest_shape>& shapes, const std::vector<double>& weights,
                                                  const Newton_options& options, std::vector<Eigen::Vector2d>& uv,
                                                  Newton_result& result)
  {
    // A factorization is reused while steps achieve this share of their predicted decrease.
    constexpr double least_share = 0.1;
    constexpr double rounding = 1e-14; // of the energy: its sum over a million triangles is no more exact
    std::vector<Eigen::Vector2d> direction(uv.size(), Eigen::Vector2d::Zero()), trial(uv.size());
    m_memory.clear();
    for(int i = 0; i <= maximum_reuse(); ++i)
    {
      if(!options.go_further() ||
         (options.stop && options.stop(Newton_state{result.iterations, result.energy, result.decrement})))
        return Newton_outcome::STOPPED;
      execute_blocks(m_execution, int(uv.size()), [&](int begin, int end)
      {
        for(int v = begin; v < end; ++v)
          if(const int u = m_system.unknown(v); u >= 0)
            direction[v] = Eigen::Vector2d(-m_step[u], -m_step[u + 1]);
      });
      const bool is_converged = result.decrement <= options.decrement * result.energy;
      const double former = result.energy;
      line_search<Energy>(shapes, weights, direction, uv, trial, result);
      const double decrease = former - result.energy;
      if(is_converged)
        return Newton_outcome::CONVERGED;
      if(i == 0 && decrease <= rounding * former)
        return Newton_outcome::STALLED;
      const Eigen::VectorXd former_gradient = m_system.gradient();
      m_system.template assemble_gradient<Energy>(m_triangles, shapes, weights, uv);
      if(relax<Energy>(shapes, weights, options, uv, result))
        result.energy = energy<Energy>(shapes, weights, uv);
      if(decrease < least_share * result.decrement || !find_reused_direction(trial, uv, former_gradient, result))
        break;
    }
    return std::nullopt;
  }

  // The next direction from the factorization at hand: L-BFGS with the latest projected Hessian as
  // the initial one. A direction costs a few triangular solves, a small part of a factorization, and
  // makes up for what projection adds to the stiffness of far-off maps. `former`: the map before the step just taken, with
  // its gradient.
  bool find_reused_direction(const std::vector<Eigen::Vector2d>& former, const std::vector<Eigen::Vector2d>& uv,
                             const Eigen::VectorXd& former_gradient, Newton_result& result)
  {
    Curvature_pair pair{Eigen::VectorXd(m_step.size()), m_system.gradient() - former_gradient};
    execute_blocks(m_execution, int(uv.size()), [&](int begin, int end)
    {
      for(int v = begin; v < end; ++v)
        if(const int u = m_system.unknown(v); u >= 0)
          pair.step.segment<2>(u) = uv[v] - former[v];
    });
    pair.product = pair.step.dot(pair.gradient_change);
    if(!(pair.product > 0))
      return false;
    m_memory.push_back(std::move(pair));
    apply_inverse(m_system.gradient());
    result.decrement = m_system.gradient().dot(m_step);
    return std::isfinite(result.decrement) && result.decrement > 0;
  }

  // The two-loop recursion of L-BFGS; the result is left in m_step.
  void apply_inverse(Eigen::VectorXd q)
  {
    std::vector<double> alphas(m_memory.size());
    for(std::size_t i = m_memory.size(); i-- > 0;)
    {
      alphas[i] = m_memory[i].step.dot(q) / m_memory[i].product;
      q -= alphas[i] * m_memory[i].gradient_change;
    }
    m_step = m_solver->solve(q);
    for(std::size_t i = 0; i < m_memory.size(); ++i)
    {
      const double beta = m_memory[i].gradient_change.dot(m_step) / m_memory[i].product;
      m_step += (alphas[i] - beta) * m_memory[i].step;
    }
  }

  // Backtracking with Armijo's condition from the full Newton step, or what is flip-free of it. Where
  // the full step is accepted, longer ones are tried: while tiny triangles grow by orders of
  // magnitude, the quadratic model sees only a factor of two per step. `trial` becomes the former map; without a step, `uv`
  // stays, and `trial` means nothing.
  template <typename Energy>
  void line_search(const std::vector<Rest_shape>& shapes, const std::vector<double>& weights,
                   const std::vector<Eigen::Vector2d>& direction, std::vector<Eigen::Vector2d>& uv,
                   std::vector<Eigen::Vector2d>& trial, Newton_result& result) const
  {
    constexpr double armijo = 1e-4, backtracking = 0.5; // the usual ones
    constexpr double margin = 0.9;                      // of the way to the first flip, where the energy is infinite
    constexpr int maximum_trials = 60;                  // no digit of the step is left after these
    const auto move = [&](double t)
    {
      execute_blocks(m_execution, int(uv.size()), [&](int begin, int end)
      {
        for(int v = begin; v < end; ++v)
          trial[v] = uv[v] + t * direction[v];
      });
    };
    const auto energy_at = [&](double t)
    {
      move(t);
      return energy<Energy>(shapes, weights, trial);
    };
    const double longest = margin * step_to_first_flip(m_triangles, uv, direction, m_execution);
    const double first = (std::min)(1., longest);
    double t = first, e = energy_at(t);
    for(int i = 0; i < maximum_trials && !(e <= result.energy - armijo * t * result.decrement); ++i)
      e = energy_at(t *= backtracking);
    if(!(e <= result.energy - armijo * t * result.decrement))
      return;
    if(t == first)
      for(double longer = 2 * t; longer < longest; longer *= 2)
      {
        const double next = energy_at(longer);
        if(!(next < e))
        {
          move(t);
          break;
        }
        e = next;
        t = longer;
      }
    result.energy = e;
    uv.swap(trial);
  }

  std::vector<Triangle> m_triangles;
  const Solvers& m_linear_solvers;
  const Execution m_execution;
  Newton_system m_system;
  Star_relaxation m_relaxation;
  std::unique_ptr<Linear_solver> m_solver;
  Eigen::VectorXd m_step;
  std::vector<Curvature_pair> m_memory;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_SOLVER_H
