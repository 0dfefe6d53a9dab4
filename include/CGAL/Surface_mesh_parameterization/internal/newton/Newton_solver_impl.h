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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_SOLVER_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_SOLVER_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_solver.h>

#include <CGAL/boost/graph/internal/Graph_kernel/separate_implementation.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_INLINE_UNLESS_SEPARATE
Newton_solver::Newton_solver(std::vector<Triangle> triangles, int number_of_vertices, const Solvers& linear_solvers,
                             std::vector<char> is_fixed, const std::vector<int>& ranks)
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

template <typename Energy>
Newton_result Newton_solver::minimize(const std::vector<Rest_shape>& shapes, const std::vector<double>& weights,
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
  const Weighted_triangles sum{m_triangles, shapes, weights};
  // One more assembly may spare factorizations: worth it where these take most of the time.
  constexpr int large_system = 20000; // unknowns
  bool relaxes = m_system.number_of_unknowns() > large_system;
  std::optional<Newton_outcome> outcome;
  for(; !outcome; relaxes = false)
  {
    if(!find_direction<Energy>(sum, relaxes, uv, result))
    {
      result.energy = energy<Energy>(shapes, weights, uv);
      outcome = Newton_outcome::SINGULAR;
      break;
    }
    const double former = result.energy;
    outcome = use_factorization<Energy>(sum, options, uv, result);
    if(!outcome && former - result.energy < options.least_decrease * result.energy)
      outcome = Newton_outcome::CONVERGED;
    if(!outcome && result.iterations >= options.maximum_iterations)
      outcome = Newton_outcome::ITERATION_LIMIT;
  }
  result.outcome = *outcome;
  return result;
}

template <typename Energy>
double Newton_solver::energy(const std::vector<Rest_shape>& shapes, const std::vector<double>& weights,
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

template <typename Energy>
bool Newton_solver::find_direction(const Weighted_triangles& sum, bool relaxes, std::vector<Eigen::Vector2d>& uv,
                                   Newton_result& result)
{
  for(double shift : {1e-12, 1e-8, 1e-4})
  {
    const auto assemble
      = [&] { return m_system.template assemble<Energy>(sum.triangles, sum.shapes, sum.weights, uv, shift); };
    result.energy = assemble();
    if(!std::isfinite(result.energy))
      return false;
    if(std::exchange(relaxes, false) && relax<Energy>(sum, uv, result))
      result.energy = assemble();
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

template <typename Energy>
bool Newton_solver::relax(const Weighted_triangles& sum, std::vector<Eigen::Vector2d>& uv, const Newton_result& result)
{
  constexpr double share_of_star = 0.01;
  const double mean_star = 3 / double(uv.size()); // of the area, about
  return m_relaxation.relax<Energy>(sum, share_of_star * mean_star * result.energy, m_system, uv) > 0;
}

template <typename Energy>
std::optional<Newton_outcome>
Newton_solver::use_factorization(const Weighted_triangles& sum, const Newton_options& options,
                                 std::vector<Eigen::Vector2d>& uv, Newton_result& result)
{
  // A factorization is reused while steps achieve this share of their predicted decrease. L-BFGS keeps two vectors for
  // each direction.
  constexpr double least_share = 0.1;
  constexpr int maximum_reuse = 30;
  constexpr double rounding = 1e-14; // of the energy: its sum over a million triangles is no more exact
  std::vector<Eigen::Vector2d> direction(uv.size(), Eigen::Vector2d::Zero()), trial(uv.size());
  m_memory.clear();
  for(int i = 0; i <= maximum_reuse; ++i)
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
    line_search<Energy>(sum, direction, uv, trial, result);
    const double decrease = former - result.energy;
    if(is_converged)
      return Newton_outcome::CONVERGED;
    if(i == 0 && decrease <= rounding * former)
      return Newton_outcome::STALLED;
    const Eigen::VectorXd former_gradient = m_system.gradient();
    m_system.template assemble_gradient<Energy>(sum.triangles, sum.shapes, sum.weights, uv);
    if(relax<Energy>(sum, uv, result))
      result.energy = energy<Energy>(sum.shapes, sum.weights, uv);
    if(decrease < least_share * result.decrement || !find_reused_direction(trial, uv, former_gradient, result))
      break;
  }
  return std::nullopt;
}

CGAL_INLINE_UNLESS_SEPARATE
bool Newton_solver::find_reused_direction(const std::vector<Eigen::Vector2d>& former, const std::vector<Eigen::Vector2d>& uv,
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

CGAL_INLINE_UNLESS_SEPARATE
void Newton_solver::apply_inverse(Eigen::VectorXd q)
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

template <typename Energy>
void Newton_solver::line_search(const Weighted_triangles& sum, const std::vector<Eigen::Vector2d>& direction,
                                std::vector<Eigen::Vector2d>& uv, std::vector<Eigen::Vector2d>& trial,
                                Newton_result& result) const
{
  constexpr double armijo = 1e-4; // the usual one
  constexpr double margin = 0.9;  // of the way to the first flip, where the energy is infinite
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
    return energy<Energy>(sum.shapes, sum.weights, trial);
  };
  const double longest = margin * step_to_first_flip(m_triangles, uv, direction, m_execution);
  const double first = (std::min)(1., longest);
  double t = first, e = energy_at(t);
  for(int i = 0; i < maximum_halvings && !(e <= result.energy - armijo * t * result.decrement); ++i)
    e = energy_at(t /= 2);
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

#ifdef CGAL_SEPARATE_IMPLEMENTATION // other units see the declarations alone
template Newton_result
Newton_solver::minimize<MIPS_energy>(const std::vector<Rest_shape>&, const std::vector<double>&,
                                     std::vector<Eigen::Vector2d>&, const Newton_options&);
template Newton_result
Newton_solver::minimize<Symmetric_Dirichlet_energy>(const std::vector<Rest_shape>&, const std::vector<double>&,
                                                    std::vector<Eigen::Vector2d>&, const Newton_options&);
template double
Newton_solver::energy<MIPS_energy>(const std::vector<Rest_shape>&, const std::vector<double>&,
                                   const std::vector<Eigen::Vector2d>&) const;
template double
Newton_solver::energy<Symmetric_Dirichlet_energy>(const std::vector<Rest_shape>&, const std::vector<double>&,
                                                  const std::vector<Eigen::Vector2d>&) const;
#endif

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_SOLVER_IMPL_H
