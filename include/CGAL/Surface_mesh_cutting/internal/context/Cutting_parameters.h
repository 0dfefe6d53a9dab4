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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_CUTTING_PARAMETERS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_CUTTING_PARAMETERS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/Conformal_solver.h>
#include <CGAL/Surface_mesh_cutting/Effort.h>
#include <CGAL/Surface_mesh_cutting/Symmetry.h>

#include <CGAL/boost/graph/internal/Steiner_tree/solve.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {
struct Solvers;
} // namespace internal
} // namespace Surface_mesh_parameterization

namespace Surface_mesh_cutting {
namespace internal {

// The parameters of the method (paper, Table 1) and what controls its effort. Lengths are in units
// of the component's average edge length unless said.
struct Cutting_parameters
{
  double minimum_distortion_decrease = 0.01; // epsilon_iso, of the area-averaged energy
  double minimum_length_decrease = 0.01;     // epsilon_len, times the bounding box diagonal
  double decrease_per_cost = 0.15;           // of the energy, for a slit to be worth its length in
                                             // bounding box diagonals
  double maximum_average_distortion = std::numeric_limits<double>::infinity(); // area-averaged, of the UVs
  double maximum_face_distortion = std::numeric_limits<double>::infinity();  // of so large a share of the area:
  double face_distortion_quantile = 1;
  double maximum_chart_distortion = std::numeric_limits<double>::infinity(); // area-averaged, of each chart
  bool has_weights = false;                  // whether edges cost other than their length
  double minimum_area_ratio = 0.1;           // alpha
  double influence_threshold = 20;           // beta
  double forbidden_radius = 10;              // d_n
  double candidate_radius = 5;               // of the disk around a candidate (Section 3.1.2)
  Conformal_solver conformal_solver = Conformal_solver::SPECTRAL;
  // Whether to do what the paper says and nothing else, see the table in the manual.
  bool use_published_method = false;
  // Whether the final map of a component has to be injective, too.
  bool do_bijective = false;
  std::optional<double> seam_smoothness; // percent by which ways may get longer to turn less
  Symmetry symmetry = Symmetry::NONE; // that the cut has as well, if the surface has it
  Effort effort = Effort::DEFAULT;     // the best one also runs the smaller ones
  std::optional<int> given_coarse_number_of_faces; // by the caller
  // How the feature points are connected; its decrease is epsilon_len as a length.
  CGAL::internal::Steiner_tree::Options connection;
  // More, on surfaces with handles, are not connected by a tree that is proven shortest: it would take too long.
  static constexpr std::size_t many_terminals = 40;
  // Whether it is a failure if the tree through the final points is not proven to be shortest.
  bool needs_optimal_tree = false;
  // At most, for each of the trees that are tried while a cut is refined. A hundred points can use up any
  // budget; most trees are proven optimal within this one.
  std::size_t number_of_states_while_refining = 500000;
  unsigned int random_seed = 0;
  // For the sparse systems of all maps; not needed where nothing is mapped.
  std::shared_ptr<const Surface_mesh_parameterization::internal::Solvers> linear_solvers;

  // Maps of a small surface take so little time that trees which are hard to prove optimal would take most of it.
  void adapt_to_size(int number_of_faces)
  {
    constexpr std::size_t states_per_face = 100;
    if(!needs_optimal_tree)
      number_of_states_while_refining
        = (std::min)(number_of_states_while_refining, states_per_face * std::size_t(number_of_faces));
  }

  bool has_bound() const { return maximum_average_distortion < std::numeric_limits<double>::infinity(); }

  // Whether single faces or charts have bounds of their own.
  bool has_local_bounds() const
  {
    return (std::min)(maximum_face_distortion, maximum_chart_distortion) < std::numeric_limits<double>::infinity();
  }

  // Whether more remedies are tried where a map without overlaps has too little room.
  bool widens_search() const { return effort != Effort::FAST && !use_published_method; }

  // By default, none where time or the published method counts.
  double smoothness() const
  {
    constexpr double usual = 1;
    return seam_smoothness.value_or(effort == Effort::FAST || use_published_method || needs_optimal_tree ? 0 : usual);
  }

  // Whether maps without overlaps take no factorization that gains little.
  bool ends_early_in_room() const { return !has_bound() && effort == Effort::FAST && !use_published_method; }

  // Cost: to remove less of a cut is not worth another map.
  double least_removal() const
  {
    constexpr double worthwhile = 0.1; // of epsilon_len
    return worthwhile * connection.minimum_length_decrease;
  }

  // Of the search for a long path: the paper starts at a random vertex.
  int number_of_sweeps() const { return use_published_method ? 1 : 2; }

  CGAL::internal::Steiner_tree::Options connection_while_refining() const
  {
    CGAL::internal::Steiner_tree::Options result = connection;
    result.maximum_number_of_states = (std::min)(result.maximum_number_of_states, number_of_states_while_refining);
    return result;
  }
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_CONTEXT_CUTTING_PARAMETERS_H
