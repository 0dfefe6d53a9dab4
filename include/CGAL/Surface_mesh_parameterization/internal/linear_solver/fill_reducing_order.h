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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_FILL_REDUCING_ORDER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_FILL_REDUCING_ORDER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>

#include <Eigen/Core>
#include <Eigen/OrderingMethods>

#include <vector>

#ifdef CGAL_METIS_ENABLED
#include <metis.h>

#include <mutex>
#endif

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Approximate minimum degree: order[i] is eliminated as the i-th. Only the lower triangle of the symmetric matrix is
// read: to a whole one, Eigen would add the transposed.
inline std::vector<int> minimum_degree_order(const Sparse_matrix& lower)
{
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int> order;
  order(lower.selfadjointView<Eigen::Lower>(), permutation);
  return std::vector<int>(permutation.indices().data(),
                          permutation.indices().data() + permutation.size());
}

#ifdef CGAL_METIS_ENABLED
// Nested dissection by METIS; empty should it fail. METIS seeds the generator of the C library, hence
// one call at a time, each with the same result.
inline std::vector<int> nested_dissection_order(const Sparse_matrix& adjacency)
{
  idx_t n = idx_t(adjacency.cols());
  std::vector<idx_t> starts(1, 0), neighbours, order(n), positions(n);
  for(int c = 0; c < n; ++c)
  {
    for(Sparse_matrix::InnerIterator it(adjacency, c); it; ++it)
      if(it.row() != c)
        neighbours.push_back(idx_t(it.row()));
    starts.push_back(idx_t(neighbours.size()));
  }
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  if(METIS_NodeND(&n, starts.data(), neighbours.data(), nullptr, nullptr, order.data(),
                  positions.data()) != METIS_OK)
    return std::vector<int>();
  return std::vector<int>(order.begin(), order.end());
}
#endif

// An order of the vertices of a graph that keeps Cholesky factors sparse: order[i] is eliminated as
// the i-th. `adjacency` has all diagonal entries: Eigen takes a row without its own for a dense row.
// Where METIS is there, large charts are dissected: with half a million vertices, that saves two
// thirds of the work of every factorization; below, it takes longer than what the few factorizations save.
inline std::vector<int> fill_reducing_order(const Sparse_matrix& adjacency)
{
#ifdef CGAL_METIS_ENABLED
  constexpr int large = 200000;
  if(adjacency.cols() >= large)
  {
    std::vector<int> order = nested_dissection_order(adjacency);
    if(!order.empty())
      return order;
  }
#endif
  return minimum_degree_order(adjacency);
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_FILL_REDUCING_ORDER_H
