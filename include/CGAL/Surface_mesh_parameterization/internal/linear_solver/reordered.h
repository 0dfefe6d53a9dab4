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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_REORDERED_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_REORDERED_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Vectors and permutations for an order of unknowns: order[i] is the unknown at place i. Products with Eigen's
// permutations would be more expressions for all programs to compile.

using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

// Takes unknowns to their places.
inline Permutation permutation_to(const std::vector<int>& order)
{
  Permutation permutation(int(order.size()));
  for(int i = 0; i < int(order.size()); ++i)
    permutation.indices()[order[i]] = i;
  return permutation;
}

template <typename Vector>
Vector reordered(const Vector& values, const std::vector<int>& order)
{
  Vector result(values.size());
  for(Eigen::Index i = 0; i < values.size(); ++i)
    result[i] = values[order[i]];
  return result;
}

template <typename Vector>
Vector in_former_order(const Vector& values, const std::vector<int>& order)
{
  Vector result(values.size());
  for(Eigen::Index i = 0; i < values.size(); ++i)
    result[order[i]] = values[i];
  return result;
}

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_REORDERED_H
