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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_SCAFFOLD_MINIMIZATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_SCAFFOLD_MINIMIZATION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/bijective/Scaffold.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/exact_flips.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_solver.h>

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

struct Scaffold_options
{
  // Ends when a round gains less than this fraction of the energy, or when the next one would.
  double decrease = 1e-3;
  int maximum_rounds = 30;
  // A factorization that gains less than this fraction of the energy is the last of its round.
  double least_decrease = 0;
  // Known to be no larger than that of any injective map: nothing is done where there is less to gain than that.
  double least_energy = 0;
  // No round follows once the energy is at most this.
  double enough_energy = 0;
  // Whether the scaffold's own vertices move, too. Within a round, parts of the chart can then
  // travel farther than to the next vertex of the scaffold, at twice the cost.
  bool moves_scaffold = false;
  Go_further go_further = always_go_further;
};

// Minimizes the symmetric Dirichlet energy of an injective map of a chart over injective maps [JSP17]: the chart and
// its scaffold are one mesh, of which no triangle may flip. The scaffold has the same energy with its current shape as
// the ideal one, so that it resists a change of shape but exerts no force; it is made anew every few steps. Its total
// weight is small, and the same for all of its triangles: thus a gap that closes keeps its resistance.
class Scaffold_minimization
{
public:
  Scaffold_minimization(const Corner_table& chart, const std::vector<Rest_shape>& shapes,
                        const Solvers& linear_solvers, const Scaffold_options& options)
    : m_chart(chart), m_shapes(shapes), m_weights(area_weights(shapes)), m_linear_solvers(linear_solvers),
      m_options(options)
  {}

  // `uv` holds an injective map and receives a better one, or stays as it is. In exact arithmetic it
  // stays injective; that no triangle has flipped is checked exactly after every round.
  Newton_result operator()(std::vector<Eigen::Vector2d>& uv)
  {
    Newton_result result;
    result.energy = energy(uv);
    if(result.energy - m_options.least_energy < m_options.least_decrease * result.energy)
    {
      result.outcome = Newton_outcome::CONVERGED;
      return result;
    }
    result.outcome = Newton_outcome::ITERATION_LIMIT;
    for(int round = 0; round < m_options.maximum_rounds; ++round)
    {
      std::vector<Eigen::Vector2d> next = uv;
      const Newton_result whole = do_round(next, result);
      if(whole.outcome == Newton_outcome::FAILED)
      {
        result.outcome = Newton_outcome::STALLED;
        return result;
      }
      uv.swap(next);
      const double former = result.energy;
      result.energy = energy(uv);
      if(whole.outcome == Newton_outcome::STOPPED || result.energy <= m_options.enough_energy ||
         former - result.energy < m_options.decrease * former ||
         (whole.outcome == Newton_outcome::CONVERGED && stress(whole, result.energy) < m_options.decrease * former))
      {
        result.outcome = whole.outcome == Newton_outcome::STOPPED ? whole.outcome : Newton_outcome::CONVERGED;
        return result;
      }
    }
    return result;
  }

private:
  static constexpr double scaffold_weight = 1e-3; // that of the chart is 1

  // An estimate of what a new scaffold lets the chart gain, once the chart is at rest with the present one: the
  // energy that the latter has stored, times a safety factor.
  static double stress(const Newton_result& whole, double energy)
  {
    constexpr double safety = 10;
    return safety * (whole.energy - energy - scaffold_weight * Symmetric_Dirichlet_energy::ideal);
  }

  double energy(const std::vector<Eigen::Vector2d>& uv) const
  {
    return area_average(
      m_shapes, face_energies<Symmetric_Dirichlet_energy>(m_shapes, m_chart.triangles(), uv));
  }

  // A few Newton steps with a new scaffold; the energy of the result is that of both.
  Newton_result do_round(std::vector<Eigen::Vector2d>& uv, Newton_result& total)
  {
    constexpr int factorizations = 3; // then the scaffold has become stiff
    constexpr double precision = 0.03; // of the solve, as a fraction of what a round has to gain
    if(!m_scaffold.build(m_chart, uv))
      return Newton_result();
    const int n = m_chart.number_of_vertices();
    std::vector<Triangle> triangles = m_chart.triangles();
    triangles.insert(triangles.end(), m_scaffold.triangles().begin(), m_scaffold.triangles().end());
    std::vector<Rest_shape> shapes = m_shapes;
    std::vector<double> weights = m_weights;
    uv = m_scaffold.points();
    for(const Triangle& t : m_scaffold.triangles())
    {
      shapes.push_back(rest_shape(uv[t[0]], uv[t[1]], uv[t[2]]));
      weights.push_back(scaffold_weight / double(m_scaffold.triangles().size()));
    }
    std::vector<char> is_fixed(n, 0);
    is_fixed.resize(n + Scaffold::number_of_corners, 1);
    is_fixed.resize(uv.size(), !m_options.moves_scaffold);

    if(!m_ranks.empty())
      m_ranks.resize(uv.size(), -1);
    Newton_solver solver(triangles, int(uv.size()), m_linear_solvers, std::move(is_fixed), m_ranks);
    if(!m_options.moves_scaffold)
      m_ranks = solver.positions();
    Newton_options options;
    options.maximum_iterations = factorizations;
    options.decrement = precision * m_options.decrease;
    options.least_decrease = m_options.least_decrease;
    options.go_further = m_options.go_further;
    const Newton_result result = solver.minimize<Symmetric_Dirichlet_energy>(shapes, weights, uv, options);
    total.iterations += result.iterations;
    total.decrement = result.decrement;
    if(result.outcome == Newton_outcome::FAILED || count_flips(triangles, uv, nullptr, m_linear_solvers.execution) > 0)
      return Newton_result();
    uv.resize(n);
    return result;
  }

  const Corner_table& m_chart;
  const std::vector<Rest_shape>& m_shapes;
  const std::vector<double> m_weights;
  const Solvers& m_linear_solvers;
  const Scaffold_options& m_options;
  // An order of elimination of the vertices that the latest round could move, which suits the next round, too. That of
  // the chart without its scaffold would not: it knows nothing of what joins the two sides of a gap.
  std::vector<int> m_ranks;
  Scaffold m_scaffold;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BIJECTIVE_SCAFFOLD_MINIMIZATION_H
