// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

// Adds the named parameters of this package to those of CGAL. CGAL includes
// this list several times, each time with another meaning of
// CGAL_add_named_parameter: there must be no include guard.

#if defined(__GNUC__)
#  pragma GCC system_header
#endif
#include_next <CGAL/STL_Extension/internal/parameters_interface.h>

#ifndef CGAL_SURFACE_MESH_CUTTING_NAMED_PARAMETERS
#  define CGAL_SURFACE_MESH_CUTTING_NAMED_PARAMETERS
#endif

// List of named parameters used in the package 'Surface_mesh_cutting'
CGAL_add_named_parameter(minimum_distortion_decrease_t, minimum_distortion_decrease, minimum_distortion_decrease)
CGAL_add_named_parameter(minimum_length_decrease_t, minimum_length_decrease, minimum_length_decrease)
CGAL_add_named_parameter(minimum_area_ratio_t, minimum_area_ratio, minimum_area_ratio)
CGAL_add_named_parameter(influence_threshold_t, influence_threshold, influence_threshold)
CGAL_add_named_parameter(forbidden_radius_t, forbidden_radius, forbidden_radius)
CGAL_add_named_parameter(minimum_decrease_per_length_t, minimum_decrease_per_length, minimum_decrease_per_length)
CGAL_add_named_parameter(coarse_number_of_faces_t, coarse_number_of_faces, coarse_number_of_faces)
CGAL_add_named_parameter(maximum_average_distortion_t, maximum_average_distortion, maximum_average_distortion)
CGAL_add_named_parameter(maximum_face_distortion_t, maximum_face_distortion, maximum_face_distortion)
CGAL_add_named_parameter(face_distortion_quantile_t, face_distortion_quantile, face_distortion_quantile)
CGAL_add_named_parameter(maximum_chart_distortion_t, maximum_chart_distortion, maximum_chart_distortion)
CGAL_add_named_parameter(do_bijective_t, do_bijective, do_bijective)
CGAL_add_named_parameter(do_weld_points_t, do_weld_points, do_weld_points)
CGAL_add_named_parameter(weld_tolerance_t, weld_tolerance, weld_tolerance)
CGAL_add_named_parameter(initial_cut_t, initial_cut, initial_cut_map)
CGAL_add_named_parameter(edge_is_forbidden_t, edge_is_forbidden, edge_is_forbidden_map)
CGAL_add_named_parameter(connection_t, connection, connection)
CGAL_add_named_parameter(effort_t, effort, effort)
CGAL_add_named_parameter(use_published_method_t, use_published_method, use_published_method)
CGAL_add_named_parameter(maximum_number_of_states_t, maximum_number_of_states, maximum_number_of_states)
CGAL_add_named_parameter(conformal_solver_t, conformal_solver, conformal_solver)
CGAL_add_named_parameter(smallest_factor_t, smallest_factor, smallest_factor)
CGAL_add_named_parameter(smallest_convex_factor_t, smallest_convex_factor, smallest_convex_factor)
CGAL_add_named_parameter(number_of_rays_t, number_of_rays, number_of_rays)
CGAL_add_named_parameter(up_direction_t, up_direction, up_direction)
CGAL_add_named_parameter(use_uniform_directions_t, use_uniform_directions, use_uniform_directions)
CGAL_add_named_parameter(occlusion_radius_t, occlusion_radius, occlusion_radius)
CGAL_add_named_parameter(margin_t, margin, margin)
CGAL_add_named_parameter(texture_size_t, texture_size, texture_size)
CGAL_add_named_parameter(chart_rotation_t, chart_rotation, chart_rotation)
CGAL_add_named_parameter(texels_per_unit_t, texels_per_unit, texels_per_unit)
CGAL_add_named_parameter(number_of_pages_t, number_of_pages, number_of_pages)
CGAL_add_named_parameter(allow_flips_t, allow_flips, allow_flips)
CGAL_add_named_parameter(symmetry_t, symmetry, symmetry)
CGAL_add_named_parameter(seam_smoothness_t, seam_smoothness, seam_smoothness)

// Names that CGAL itself has only since a later version
#if CGAL_VERSION_NR < 1060100000
CGAL_add_named_parameter(edge_weight_t, edge_weight, edge_weight_map)
#endif
