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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_SPECTRAL_CONFORMAL_MAP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_SPECTRAL_CONFORMAL_MAP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/exact_flips.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Spectral conformal parameterization [Mullen et al. 2008]: among all maps whose border has unit
// mass, the one of least conformal energy, Dirichlet energy minus area. With the place of a vertex as
// one complex number u_i, that energy is 2 sum of area |f_z̄|^2, and f_z̄ is linear in the u_i: a
// Hermitian eigenproblem of one unknown per vertex. One factorization, then inverse iteration.
class Spectral_conformal_map
{
  using Complex = std::complex<double>;
  using Matrix = Hermitian_solver::Matrix;

public:
  Spectral_conformal_map(const Corner_table& chart, const std::vector<Rest_shape>& shapes)
    : m_energy(chart.number_of_vertices(), chart.number_of_vertices()),
      m_masses(Eigen::VectorXd::Zero(chart.number_of_vertices())),
      m_map(Eigen::VectorXcd::Zero(chart.number_of_vertices()))
  {
    assemble_energy(chart.triangles(), shapes);
    assemble_border(chart, shapes);
  }

  // False if the factorization fails, or once `go_further()` does not want more.
  bool solve(const Solvers& linear_solvers, const Go_further& go_further)
  {
    constexpr int maximum_iterations = 50; // a limit: about ten are usual
    constexpr double tolerance = 1e-4;     // the angle between iterates; only where the map is distorted matters

    // The constants have no energy: a trace of the mass makes the matrix positive definite and
    // leaves the eigenvectors what they are.
    constexpr double relative_shift = 1e-11;
    double trace = 0;
    for(int v = 0; v < int(m_masses.size()); ++v)
      trace += diagonal(v).real();
    const double shift = relative_shift * trace / m_masses.sum();
    for(int v = 0; v < int(m_masses.size()); ++v)
      diagonal(v) += shift * m_masses[v];
    Hermitian_solver solver(linear_solvers);
    if(!go_further() || !solver.factorize(m_energy))
      return false;

    normalize();
    for(int i = 0; i < maximum_iterations; ++i)
    {
      if(!go_further())
        return false;
      Eigen::VectorXcd former = m_map; // times the masses
      for(int v = 0; v < int(former.size()); ++v)
        former[v] *= m_masses[v];
      m_map = solver.solve(former);
      normalize();
      Complex overlap = 0;
      for(int v = 0; v < int(former.size()); ++v)
        overlap += std::conj(m_map[v]) * former[v];
      if(!(1 - std::abs(overlap) > tolerance * tolerance))
        break;
    }
    return std::all_of(m_map.data(), m_map.data() + m_map.size(),
                       [](const Complex& z) { return std::isfinite(z.real()) && std::isfinite(z.imag()); });
  }

  Eigen::Vector2d operator[](int v) const
  { return Eigen::Vector2d(m_map[v].real(), m_map[v].imag()); }

private:
  void assemble_energy(const std::vector<Triangle>& triangles, const std::vector<Rest_shape>& shapes)
  {
    std::vector<Eigen::Triplet<Complex> > entries;
    entries.reserve(6 * triangles.size() + m_masses.size());
    for(int v = 0; v < int(m_masses.size()); ++v)
      entries.emplace_back(v, v, 0);
    for(std::size_t t = 0; t < triangles.size(); ++t)
    {
      const Rest_shape& s = shapes[t];
      const Complex d[3] = {{s.g0.x(), s.g0.y()}, {s.g1.x(), s.g1.y()}, {s.g2.x(), s.g2.y()}};
      for(int i = 0; i < 3; ++i)
        for(int j = 0; j < 3; ++j)
          if(triangles[t][i] >= triangles[t][j])
            entries.emplace_back(triangles[t][i], triangles[t][j], s.area * std::conj(d[i]) * d[j]);
    }
    m_energy.setFromTriplets(entries.begin(), entries.end()); // the lower half
    for(int v = 0; v < int(m_masses.size()); ++v)
      if(diagonal(v) == Complex(0))
        diagonal(v) = 1; // not in use
  }

  // The first entry of each column; all are there. Eigen's access would insert those that are not.
  Complex& diagonal(int v) { return m_energy.valuePtr()[m_energy.outerIndexPtr()[v]]; }

  // The mass of a border vertex is its share of the border; the iteration starts from a map of the
  // longest border to a circle.
  void assemble_border(const Corner_table& chart, const std::vector<Rest_shape>& shapes)
  {
    double longest = 0;
    for(const std::vector<int>& loop : chart.border_loops())
    {
      std::vector<double> positions;
      double length = 0;
      for(int h : loop)
      {
        const Rest_shape& s = shapes[h / 3];
        const Eigen::Vector2d* const gradients[3] = {&s.g2, &s.g0, &s.g1}; // of the corner across
        const double edge = 2 * s.area * gradients[h % 3]->norm();
        m_masses[chart.source(h)] += 0.5 * edge;
        m_masses[chart.target(h)] += 0.5 * edge;
        positions.push_back(length);
        length += edge;
      }
      if(length <= longest)
        continue;
      longest = length;
      m_map.setZero();
      for(std::size_t i = 0; i < loop.size(); ++i)
        m_map[chart.source(loop[i])] = std::polar(1., double(2 * EIGEN_PI) * positions[i] / length);
    }
  }

  // Takes the constants out, and makes the border's mass one.
  void normalize()
  {
    Complex mean = 0;
    for(int v = 0; v < int(m_map.size()); ++v)
      mean += m_map[v] * m_masses[v];
    mean /= m_masses.sum();
    double square = 0;
    for(int v = 0; v < int(m_map.size()); ++v)
    {
      m_map[v] -= mean;
      square += (m_map[v].real() * m_map[v].real() + m_map[v].imag() * m_map[v].imag()) * m_masses[v];
    }
    m_map /= std::sqrt(square);
  }

  Matrix m_energy;
  Eigen::VectorXd m_masses;
  Eigen::VectorXcd m_map;
};

// The spectral conformal map of a chart, scaled to the area of the surface. `number_of_flips` receives how many
// triangles are flipped: usually none or a few, which `remove_flips()` puts right, but several per cent where the map
// folds. False if there is no map of positive area, or once `go_further()` does not want more.
inline bool spectral_conformal_map(const Corner_table& chart, const std::vector<Rest_shape>& shapes,
                                   const Solvers& linear_solvers, std::vector<Eigen::Vector2d>& uv,
                                   int* number_of_flips = nullptr,
                                   const Go_further& go_further = always_go_further)
{
  Spectral_conformal_map map(chart, shapes);
  if(!map.solve(linear_solvers, go_further))
    return false;
  uv.resize(chart.number_of_vertices());
  for(int v = 0; v < chart.number_of_vertices(); ++v)
    uv[v] = map[v];
  if(!(chart_area(chart.triangles(), uv) > 0))
    return false;
  scale_to_area(chart.triangles(), surface_area(shapes), uv);
  if(number_of_flips != nullptr)
    *number_of_flips = count_flips(chart.triangles(), uv);
  return true;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_SPECTRAL_CONFORMAL_MAP_H
