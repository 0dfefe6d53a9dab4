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

#include <CGAL/boost/graph/internal/Steiner_tree/Options.h>

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
  int number_of_starts = 1;            // of a search for features; one: there is no search
  int number_of_combinations = 0;      // of what starts find, at most
  Effort effort = Effort::DEFAULT;     // the best one also runs the smaller ones, and returns the best result
  bool moves_ends = false;             // where features are found, of a cut at a bound
  bool opens_slits_first = false;      // where a map without overlaps misses a bound, before the running map goes below
  bool ends_early_in_room = false;     // whether maps without overlaps take no factorization that gains little
  std::optional<int> given_coarse_number_of_faces; // by the caller
  int coarse_number_of_faces = 0;      // on which features are found; 0: on those of the mesh
  // A coarse map does not resolve all that a slit gains around its end. Asked for the same gain, it keeps too few
  // features: measured at full resolution, the energy is as low as that of features found there with this factor.
  double resolved_gain = 0.85;
  bool is_coarser_where_small = false; // see `adapted_to_size()`
  int number_of_shortening_solves = 0; // at most, where features are found
  int number_of_corrective_solves = 0; // at most, on the mesh if that is finer
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
  bool adds_start = true; // whether that of the seed comes to those of the first seeds, where there are several at a bound
  // For the sparse systems of all maps; not needed where nothing is mapped.
  std::shared_ptr<const Surface_mesh_parameterization::internal::Solvers> linear_solvers;

  // On a small surface, features of a still coarser version lead to cuts of about the same quality, and finding them takes
  // most of the time; on a large one, it does not. Maps of a small one take so little time that trees which are hard to
  // prove optimal would take most of it.
  Cutting_parameters adapted_to_size(int number_of_faces) const
  {
    constexpr int largest_number_of_faces = 25000;
    constexpr std::size_t states_per_face = 100;
    Cutting_parameters result = *this;
    if(!needs_optimal_tree)
      result.number_of_states_while_refining
        = (std::min)(number_of_states_while_refining, states_per_face * std::size_t(number_of_faces));
    if(is_coarser_where_small && number_of_faces <= largest_number_of_faces)
    {
      result.coarse_number_of_faces = 3000;
      result.resolved_gain = 0.78;
    }
    return result;
  }

  // Costs are in units of what a unit of length costs on average over the surface: exchange rates remain.
  void adapt_to_weights()
  {
    has_weights = true;
    adapt_effort_to_weights();
  }

  void adapt_effort_to_weights()
  {
    constexpr int least_number_of_solves = 16;
    if(!has_weights)
      return;
    moves_ends = false; // they move to cheap places
    if(number_of_shortening_solves > 0)
      number_of_shortening_solves = (std::max)(number_of_shortening_solves, least_number_of_solves);
  }

  bool has_bound() const { return maximum_average_distortion < std::numeric_limits<double>::infinity(); }

  // Of a map with that energy, over the bound; infinite if it is not a number.
  double excess(double energy) const
  {
    if(!has_bound() || energy <= maximum_average_distortion)
      return 0;
    return energy > maximum_average_distortion ? energy - maximum_average_distortion : std::numeric_limits<double>::infinity();
  }

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
