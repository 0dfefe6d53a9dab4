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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_PARAMETERIZER_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_PARAMETERIZER_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Chart_parameterizer.h>
#include <CGAL/Surface_mesh_parameterization/internal/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/hierarchical_map.h>

#include <CGAL/boost/graph/internal/Graph_kernel/separate_implementation.h>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_INLINE_UNLESS_SEPARATE
Newton_solver& Chart_parameterizer::solver()
{
  if(!m_solver)
    m_solver = std::make_unique<Newton_solver>(m_chart.triangles(), m_chart.number_of_vertices(), m_linear_solvers,
                                               std::vector<char>(), m_ranks);
  return *m_solver;
}

template <typename Energy>
bool Chart_parameterizer::start(std::vector<Eigen::Vector2d>& uv, const Newton_options& options, First_map first_map)
{
  bool is_mapped = false;
  const auto map = [&] { is_mapped = first_map_found<Energy>(uv, options, first_map); };
  if(m_linear_solvers.execution == Execution::PARALLEL)
    execute_both(Execution::PARALLEL, map, [&] { solver(); });
  else // then its memory is not needed yet
    map();
  return is_mapped;
}

template <typename Energy>
bool Chart_parameterizer::first_map_found(std::vector<Eigen::Vector2d>& uv, const Newton_options& options,
                                          First_map first_map) const
{
  const auto map_by_tutte = [&] { return tutte_map(m_chart, m_points, surface_area(m_shapes), m_linear_solvers, uv); };
  if(first_map == First_map::TUTTE && map_by_tutte())
    return true;
  const Stages_outcome outcome = hierarchical_map<Energy>(m_chart, m_points, m_linear_solvers, uv, options.go_further);
  return outcome == Stages_outcome::MAPPED ||
         (outcome == Stages_outcome::FAILED && first_map != First_map::TUTTE && map_by_tutte());
}

CGAL_INLINE_UNLESS_SEPARATE
Newton_result Chart_parameterizer::conformal_map(std::vector<Eigen::Vector2d>& uv, const Newton_options& options,
                                                 First_map first_map)
{
  if(!start<MIPS_energy>(uv, options, first_map))
    return Newton_result();
  const Newton_result result = improve_conformally(uv, options);
  return first_map == First_map::TUTTE && result.energy > hopeless_energy ? conformal_map(uv, options) : result;
}

CGAL_INLINE_UNLESS_SEPARATE
Newton_result Chart_parameterizer::improve_conformally(std::vector<Eigen::Vector2d>& uv, const Newton_options& options)
{
  const Newton_result result = solver().minimize<MIPS_energy>(m_shapes, m_weights, uv, options);
  if(result.outcome != Newton_outcome::FAILED)
    scale_to_area(m_chart.triangles(), surface_area(m_shapes), uv);
  return result;
}

CGAL_INLINE_UNLESS_SEPARATE
Newton_result Chart_parameterizer::isometric_map(std::vector<Eigen::Vector2d>& uv, const Newton_options& options)
{
  if(!isometric_start(uv, options))
    return Newton_result();
  return improve_isometrically(uv, options);
}

CGAL_INLINE_UNLESS_SEPARATE
bool Chart_parameterizer::isometric_start(std::vector<Eigen::Vector2d>& uv, const Newton_options& options,
                                          First_map first_map)
{
  return start<Symmetric_Dirichlet_energy>(uv, options, first_map);
}

CGAL_INLINE_UNLESS_SEPARATE
Newton_result Chart_parameterizer::improve_isometrically(std::vector<Eigen::Vector2d>& uv, const Newton_options& options)
{
  const double scale = best_scale(m_shapes, m_chart.triangles(), uv);
  for(Eigen::Vector2d& u : uv)
    u *= scale;
  return solver().minimize<Symmetric_Dirichlet_energy>(m_shapes, m_weights, uv, options);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CHART_PARAMETERIZER_IMPL_H
