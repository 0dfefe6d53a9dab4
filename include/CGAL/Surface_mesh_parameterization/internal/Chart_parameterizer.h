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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_PARAMETERIZER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_PARAMETERIZER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_solver.h>

#include <Eigen/Core>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The start of a map from nothing. Should it fail, the other one is tried.
enum class First_map
{
  HIERARCHY,
  TUTTE // of the whole chart: three times as many iterations, and rounding spoils it where long parts hang on
        // a short border
};

// An area-averaged energy, MIPS or symmetric Dirichlet, above that of all useful maps: either the surface is
// mostly degenerate, or the map started from an embedding that collapsed.
constexpr double hopeless_energy = 100;

// Flip-free maps of one chart: from nothing, or better ones from a given one. Keeps what does not
// change between solves: shapes, weights and the symbolic factorization, which takes so long on large charts that
// another thread does it while the hierarchy is built.
class Chart_parameterizer
{
public:
  // `points` holds the position of each chart vertex on the surface, `shapes` the triangles laid flat. `ranks`: see
  // `Newton_system`.
  Chart_parameterizer(const Corner_table& chart, std::vector<Eigen::Vector3d> points,
                      const std::vector<Rest_shape>& shapes, const Solvers& linear_solvers,
                      std::vector<int> ranks = {})
    : m_chart(chart), m_points(std::move(points)), m_shapes(shapes), m_weights(area_weights(shapes)),
      m_linear_solvers(linear_solvers), m_ranks(std::move(ranks))
  {}

  // As conformal as possible, free border: KP-Newton on the MIPS energy. The result has the surface's area.
  Newton_result conformal_map(std::vector<Eigen::Vector2d>& uv, const Newton_options& options,
                              First_map first_map = First_map::HIERARCHY);

  Newton_result improve_conformally(std::vector<Eigen::Vector2d>& uv, const Newton_options& options);

  // As isometric as possible, free border: KP-Newton on the symmetric Dirichlet energy from the same starts.
  Newton_result isometric_map(std::vector<Eigen::Vector2d>& uv, const Newton_options& options);

  // The start of `isometric_map()`. False if no flip-free map was found or the run was stopped.
  bool isometric_start(std::vector<Eigen::Vector2d>& uv, const Newton_options& options,
                       First_map first_map = First_map::HIERARCHY);

  // From the flip-free map `uv`, which is first brought to its best scale.
  Newton_result improve_isometrically(std::vector<Eigen::Vector2d>& uv, const Newton_options& options);

  // The place of each vertex in the order of elimination.
  const std::vector<int>& positions() { return solver().positions(); }

private:
  Newton_solver& solver();

  template <typename Energy>
  bool start(std::vector<Eigen::Vector2d>& uv, const Newton_options& options, First_map first_map);

  template <typename Energy>
  bool first_map_found(std::vector<Eigen::Vector2d>& uv, const Newton_options& options, First_map first_map) const;

  const Corner_table& m_chart;
  std::vector<Eigen::Vector3d> m_points;
  const std::vector<Rest_shape>& m_shapes;
  std::vector<double> m_weights;
  const Solvers& m_linear_solvers;
  const std::vector<int> m_ranks;
  std::unique_ptr<Newton_solver> m_solver;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_parameterization/internal/Chart_parameterizer_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_PARAMETERIZER_H
