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

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/stars.h>
#include <CGAL/Surface_mesh_parameterization/internal/vectors.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The smallest positive root of a + b t + c t^2 with a > 0, infinity if there is none.
inline double smallest_positive_root(double a, double b, double c)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double discriminant = b * b - 4 * a * c;
  if(!(discriminant >= 0))
    return infinity;
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  const double r = a / q, s = q / c;
  return (std::min)(r > 0 ? r : infinity, s > 0 ? s : infinity);
}

// How far all vertices can move along `direction` until a triangle degenerates [SS15, Section 3.3].
inline double step_to_first_flip(const std::vector<Triangle>& triangles, const std::vector<Eigen::Vector2d>& uv,
                                 const std::vector<Eigen::Vector2d>& direction,
                                 Execution execution = Execution::SEQUENTIAL)
{
  const auto smaller = [](double s, double t) { return (std::min)(s, t); };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return reduce_blocks(execution, int(triangles.size()), infinity, [&](int begin, int end)
  {
    double step = infinity;
    for(int f = begin; f < end; ++f)
    {
      const Triangle& t = triangles[f];
      const Eigen::Vector2d a = uv[t[1]] - uv[t[0]], b = uv[t[2]] - uv[t[0]];
      const Eigen::Vector2d da = direction[t[1]] - direction[t[0]], db = direction[t[2]] - direction[t[0]];
      step = smaller(step, smallest_positive_root(determinant(a, b), determinant(a, db) + determinant(da, b),
                                                 determinant(da, db)));
    }
    return step;
  }, smaller);
}

// SINGULAR: factorization failed, map valid. FAILED: map invalid.
enum class Newton_outcome { CONVERGED, STOPPED, ITERATION_LIMIT, STALLED, SINGULAR, FAILED };

// The state after the direction of a step was found and before it is taken.
struct Newton_state
{
  int iteration;
  double energy;    // area-averaged
  double decrement; // g^T H^-1 g, about twice the gain that is left

  // Whether the energy will stay above `bound`. Far from convergence the decrement is too small: it counts as the gain.
  bool is_out_of_reach(double bound) const { return energy - decrement > bound; }
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

// KP-Newton [GSC18]: minimizes the area-averaged energy of a flip-free map by Newton's method with projected Hessians.
// Each step stays short of the first flip and satisfies Armijo's condition, so the energy never grows and no triangle
// ever flips. One object serves any number of solves over the same triangles; the symbolic factorization is kept.
class Newton_solver
{
public:
  // Vertices with `is_fixed` keep their place (empty: all are free; then the first vertex is pinned,
  // which costs nothing since the energies do not depend on translation). `ranks`: see `Newton_system`.
  Newton_solver(std::vector<Triangle> triangles, int number_of_vertices, const Solvers& linear_solvers,
                std::vector<char> is_fixed = {}, const std::vector<int>& ranks = {});

  const std::vector<Triangle>& triangles() const { return m_triangles; }
  // See `Newton_system`.
  const std::vector<int>& positions() const { return m_system.positions(); }

  // `uv` holds a flip-free map and receives a better one. `weights` are the triangles' areas divided
  // by their sum, whatever the shapes' areas are: references may change, the measure does not.
  template <typename Energy>
  Newton_result minimize(const std::vector<Rest_shape>& shapes, const std::vector<double>& weights,
                         std::vector<Eigen::Vector2d>& uv, const Newton_options& options);

  // The area-averaged energy; infinite if a triangle is not positive.
  template <typename Energy>
  double energy(const std::vector<Rest_shape>& shapes, const std::vector<double>& weights,
                const std::vector<Eigen::Vector2d>& uv) const;

private:
  struct Curvature_pair
  {
    Eigen::VectorXd step, gradient_change;
    double product = 0;
  };

  // Assembles and solves for the Newton direction. The diagonal shift is relative to each entry: it
  // fixes the gauge (MIPS does not depend on scale and rotation) and grows only where rounding
  // makes the factorization of an ill-conditioned matrix fail. With `relaxes`, stars are relaxed first.
  template <typename Energy>
  bool find_direction(const Weighted_triangles& sum, bool relaxes, std::vector<Eigen::Vector2d>& uv,
                      Newton_result& result);

  // Relaxes stars until the decrement of each vertex is small against the energy of its star. Whether there was any.
  template <typename Energy>
  bool relax(const Weighted_triangles& sum, std::vector<Eigen::Vector2d>& uv, const Newton_result& result);

  // Steps while the factorization at hand gives good directions, of which the first is known. The outcome, if that ends
  // the iteration.
  template <typename Energy>
  std::optional<Newton_outcome> use_factorization(const Weighted_triangles& sum, const Newton_options& options,
                                                  std::vector<Eigen::Vector2d>& uv, Newton_result& result);

  // The next direction from the factorization at hand: L-BFGS with the latest projected Hessian as the initial one. A
  // direction costs a few triangular solves, a small part of a factorization, and makes up for what projection adds to
  // the stiffness of far-off maps. `former`: the map before the step just taken, with its gradient.
  bool find_reused_direction(const std::vector<Eigen::Vector2d>& former, const std::vector<Eigen::Vector2d>& uv,
                             const Eigen::VectorXd& former_gradient, Newton_result& result);

  // The two-loop recursion of L-BFGS; the result is left in m_step.
  void apply_inverse(Eigen::VectorXd q);

  // Backtracking with Armijo's condition from the full Newton step, or what is flip-free of it. Where the full step is
  // accepted, longer ones are tried: while tiny triangles grow by orders of magnitude, the quadratic model sees only a
  // factor of two per step. `trial` becomes the former map; without a step, `uv` stays, and `trial` means nothing.
  template <typename Energy>
  void line_search(const Weighted_triangles& sum, const std::vector<Eigen::Vector2d>& direction,
                   std::vector<Eigen::Vector2d>& uv, std::vector<Eigen::Vector2d>& trial, Newton_result& result) const;

  std::vector<Triangle> m_triangles;
  const Solvers& m_linear_solvers;
  const Execution m_execution;
  Newton_system m_system;
  Star_relaxation m_relaxation;
  std::unique_ptr<Linear_solver> m_solver;
  Eigen::VectorXd m_step;
  std::vector<Curvature_pair> m_memory;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_solver_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_SOLVER_H
