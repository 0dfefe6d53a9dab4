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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_READ_PARAMETERS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_READ_PARAMETERS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/base.h>

#include <CGAL/Surface_mesh_cutting/Conformal_solver.h>
#include <CGAL/Surface_mesh_cutting/Connection.h>
#include <CGAL/Surface_mesh_cutting/Effort.h>
#include <CGAL/Surface_mesh_cutting/internal/context/Cutting_parameters.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_status.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>

#include <cmath>
#include <limits>
#include <string>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

using Steiner_method = CGAL::internal::Steiner_tree::Method;

// The paper's greedy points alone, or improved by exchanging them.
inline Steiner_method steiner_method(Connection connection, bool use_published_method)
{
  switch(connection)
  {
  case Connection::METRIC_CLOSURE:          return Steiner_method::metric_closure;
  case Connection::SHORTEST_PATH_HEURISTIC: return Steiner_method::shortest_path_heuristic;
  case Connection::GREEDY:                  return use_published_method ? Steiner_method::greedy_auxiliary_points
                                                               : Steiner_method::local_search;
  default:                                  return Steiner_method::exact;
  }
}

template <typename NamedParameters>
Cutting_parameters read_cutting_parameters(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;

  Cutting_parameters p;
  const auto read = [](const auto& given, auto& value)
  { value = choose_parameter(given, value); };
  read(get_parameter(np, internal_np::minimum_distortion_decrease), p.minimum_distortion_decrease);
  read(get_parameter(np, internal_np::minimum_length_decrease), p.minimum_length_decrease);
  read(get_parameter(np, internal_np::minimum_area_ratio), p.minimum_area_ratio);
  read(get_parameter(np, internal_np::maximum_average_distortion), p.maximum_average_distortion);
  read(get_parameter(np, internal_np::maximum_face_distortion), p.maximum_face_distortion);
  read(get_parameter(np, internal_np::face_distortion_quantile), p.face_distortion_quantile);
  read(get_parameter(np, internal_np::maximum_chart_distortion), p.maximum_chart_distortion);
  read(get_parameter(np, internal_np::influence_threshold), p.influence_threshold);
  read(get_parameter(np, internal_np::forbidden_radius), p.forbidden_radius);
  read(get_parameter(np, internal_np::use_published_method), p.use_published_method);
  read(get_parameter(np, internal_np::do_bijective), p.do_bijective);
  read(get_parameter(np, internal_np::symmetry), p.symmetry);
  read(get_parameter(np, internal_np::seam_smoothness), p.seam_smoothness);
  read(get_parameter(np, internal_np::random_seed), p.random_seed);
  // The paper's maps cost ten times as much as spectral ones and lead to cuts of the same quality.
  p.conformal_solver = p.use_published_method ? Conformal_solver::KP_NEWTON : Conformal_solver::SPECTRAL;
  read(get_parameter(np, internal_np::conformal_solver), p.conformal_solver);
  read(get_parameter(np, internal_np::maximum_number_of_states), p.connection.maximum_number_of_states);

  // The paper connects greedily.
  Connection connection = p.use_published_method ? Connection::GREEDY : Connection::BEST;
  read(get_parameter(np, internal_np::connection), connection);
  p.connection.method = steiner_method(connection, p.use_published_method);
  p.needs_optimal_tree = connection == Connection::EXACT;
  if(p.needs_optimal_tree)
    p.number_of_states_while_refining = p.connection.maximum_number_of_states;
  read(get_parameter(np, internal_np::coarse_number_of_faces), p.given_coarse_number_of_faces);
  read(get_parameter(np, internal_np::effort), p.effort);
  if(p.use_published_method)
    p.decrease_per_cost = 0;
  read(get_parameter(np, internal_np::minimum_decrease_per_length), p.decrease_per_cost);
  return p;
}

inline Indexed_status check_parameters(const Cutting_parameters& p)
{
  const auto refuse = [](const char* name, const char* range)
  { return Indexed_status(Status_code::WRONG_PARAMETER, std::string(name) + " must be " + range); };
  constexpr double ideal = Surface_mesh_parameterization::internal::Symmetric_Dirichlet_energy::ideal;
  const auto is_non_negative = [](double x) { return std::isfinite(x) && x >= 0; };
  if(!is_non_negative(p.minimum_distortion_decrease))
    return refuse("minimum_distortion_decrease", "finite and not negative");
  if(!is_non_negative(p.minimum_length_decrease))
    return refuse("minimum_length_decrease", "finite and not negative");
  const char* const above_ideal = "greater than 4, the energy of an isometric map";
  if(!(p.maximum_average_distortion > ideal))
    return refuse("maximum_average_distortion", above_ideal);
  if(!(p.maximum_face_distortion > ideal))
    return refuse("maximum_face_distortion", above_ideal);
  if(!(p.maximum_chart_distortion > ideal))
    return refuse("maximum_chart_distortion", above_ideal);
  if(!(p.face_distortion_quantile > 0 && p.face_distortion_quantile <= 1))
    return refuse("face_distortion_quantile", "greater than 0 and at most 1");
  if(!is_non_negative(p.decrease_per_cost))
    return refuse("minimum_decrease_per_length", "finite and not negative");
  if(!(p.seam_smoothness.value_or(0) >= 0 && p.seam_smoothness.value_or(0) <= 100))
    return refuse("seam_smoothness", "between 0 and 100");
  if(p.given_coarse_number_of_faces.value_or(0) < 0)
    return refuse("coarse_number_of_faces", "not negative");
  if(!(p.minimum_area_ratio >= 0 && p.minimum_area_ratio <= 1))
    return refuse("minimum_area_ratio", "between 0 and 1");
  if(!is_non_negative(p.influence_threshold))
    return refuse("influence_threshold", "finite and not negative");
  if(!is_non_negative(p.forbidden_radius))
    return refuse("forbidden_radius", "finite and not negative");
  return Indexed_status();
}


} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_RUN_READ_PARAMETERS_H
