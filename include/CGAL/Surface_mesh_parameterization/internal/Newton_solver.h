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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SOLVER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_parameterization/internal/Newton_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/flip_barrier.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

enum class Newton_outcome { CONVERGED, STOPPED, ITERATION_LIMIT, STALLED, FAILED };

// What is known after the direction of a step was found and before it is taken.
struct Newton_state
{
  int iteration;
  double energy;    // area-averaged
  double decrement; // g^T H^-1 g, about twice the gain that is left
};

struct Newton_options
{
  int maximum_iterations = 200;
  double decrement = 1e-6;
  // Ends the iteration when it returns true.
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
template <typename LinearSolver = Simplicial_solver>
class Newton_solver
{
public:
  // Vertices with `is_fixed` keep their place (empty: all are free; then the first vertex is pinned,
  // which costs nothing since the energies do not depend on translation).
  Newton_solver(std::vector<Triangle> triangles, int number_of_vertices,
                std::vector<char> is_fixed = {}, LinearSolver solver = LinearSolver())
    : m_triangles(std::move(triangles)), m_solver(std::move(solver))
  {
    if(std::find(is_fixed.begin(), is_fixed.end(), char(1)) == is_fixed.end() && !m_triangles.empty())
    {
      is_fixed.assign(number_of_vertices, 0);
      is_fixed[m_triangles.front()[0]] = 1;
    }
    m_system = Newton_system(m_triangles, number_of_vertices, is_fixed);
    if(m_system.number_of_unknowns() > 0)
      m_solver.analyze(m_system.hessian());
  }

  const std::vector<Triangle>& triangles() const { return m_triangles; }

  // `uv` holds a flip-free map and receives a better one. `weights` are the triangles' areas divided
  // by their sum, whatever the shapes' areas are: references may change, the measure does not.
  template <typename Energy>
  Newton_result minimize(const std::vector<Rest_shape>& shapes, const std::vector<double>& weights,
                         std::vector<Eigen::Vector2d>& uv, const Newton_options& options)
  {
    Newton_result result;
    std::vector<Eigen::Vector2d> direction(uv.size(), Eigen::Vector2d::Zero()), trial(uv.size());
    if(m_system.number_of_unknowns() == 0)
    {
      result.outcome = Newton_outcome::CONVERGED;
      result.energy = energy<Energy>(shapes, weights, uv);
      result.decrement = 0;
      return result;
    }
    while(true)
    {
      result.energy = m_system.template assemble<Energy>(m_triangles, shapes, weights, uv, gauge_shift);
      if(!std::isfinite(result.energy) || !m_solver.factorize(m_system.hessian()))
        return result;
      ++result.iterations;
      const Eigen::VectorXd step = m_solver.solve(m_system.gradient());
      result.decrement = m_system.gradient().dot(step);
      if(!std::isfinite(result.decrement))
        return result;
      if(options.stop && options.stop(Newton_state{result.iterations, result.energy, result.decrement}))
      {
        result.outcome = Newton_outcome::STOPPED;
        return result;
      }
      for(std::size_t v = 0; v < uv.size(); ++v)
        if(m_system.unknown(int(v)) >= 0)
          direction[v] = -step.segment<2>(m_system.unknown(int(v)));
      const bool is_converged = result.decrement <= options.decrement;
      const double former = result.energy;
      const bool has_moved = line_search<Energy>(shapes, weights, direction, uv, trial, result);
      if(is_converged || !has_moved || former - result.energy <= 1e-14 * former)
      {
        result.outcome = is_converged ? Newton_outcome::CONVERGED : Newton_outcome::STALLED;
        return result;
      }
      if(result.iterations >= options.maximum_iterations)
      {
        result.outcome = Newton_outcome::ITERATION_LIMIT;
        return result;
      }
    }
  }

  // The area-averaged energy; infinite if a triangle is not positive.
  template <typename Energy>
  double energy(const std::vector<Rest_shape>& shapes, const std::vector<double>& weights,
                const std::vector<Eigen::Vector2d>& uv) const
  {
    double sum = 0;
    for(std::size_t f = 0; f < m_triangles.size(); ++f)
    {
      const Triangle& t = m_triangles[f];
      const Wirtinger_derivatives w = wirtinger_derivatives(shapes[f], uv[t[0]], uv[t[1]], uv[t[2]]);
      const double x = w.x(), y = w.y();
      if(!(x > y))
        return std::numeric_limits<double>::infinity();
      sum += weights[f] * Energy::value(x, y);
    }
    return sum;
  }

private:
  // Relative to each diagonal entry. MIPS does not depend on scale and rotation.
  static constexpr double gauge_shift = 1e-12;

  // Backtracking with Armijo's condition from the largest flip-free step, at most one Newton step.
  template <typename Energy>
  bool line_search(const std::vector<Rest_shape>& shapes, const std::vector<double>& weights,
                   const std::vector<Eigen::Vector2d>& direction, std::vector<Eigen::Vector2d>& uv,
                   std::vector<Eigen::Vector2d>& trial, Newton_result& result) const
  {
    constexpr double armijo = 1e-4, backtracking = 0.5, margin = 0.9;
    constexpr int maximum_trials = 60;
    double t = (std::min)(1., margin * step_to_first_flip(m_triangles, uv, direction));
    for(int i = 0; i < maximum_trials; ++i, t *= backtracking)
    {
      for(std::size_t v = 0; v < uv.size(); ++v)
        trial[v] = uv[v] + t * direction[v];
      const double e = energy<Energy>(shapes, weights, trial);
      if(e <= result.energy - armijo * t * result.decrement)
      {
        uv.swap(trial);
        result.energy = e;
        return true;
      }
    }
    return false;
  }

  std::vector<Triangle> m_triangles;
  Newton_system m_system;
  LinearSolver m_solver;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_SOLVER_H
