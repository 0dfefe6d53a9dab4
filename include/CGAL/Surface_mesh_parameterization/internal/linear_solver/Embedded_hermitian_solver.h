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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_EMBEDDED_HERMITIAN_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_EMBEDDED_HERMITIAN_SOLVER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Reordering_solver.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// Hermitian systems for a solver of real ones: with each unknown as its real and its imaginary part,
// A + iB becomes the symmetric matrix of the blocks (a, -b; b, a), positive definite as well.
class Embedded_hermitian_solver : public Hermitian_solver
{
public:
  explicit Embedded_hermitian_solver(std::unique_ptr<Linear_solver> solver) : m_solver(std::move(solver)) {}

  bool factorize(const Matrix& lower) override
  {
    std::vector<Eigen::Triplet<double> > entries;
    entries.reserve(4 * std::size_t(lower.nonZeros()));
    for(int column = 0; column < lower.outerSize(); ++column)
      for(Matrix::InnerIterator it(lower, column); it; ++it)
      {
        const int i = 2 * int(it.row()), j = 2 * column;
        entries.emplace_back(i, j, it.value().real());
        entries.emplace_back(i + 1, j + 1, it.value().real());
        entries.emplace_back(i + 1, j, it.value().imag());
        if(i != j) // otherwise it belongs to the upper triangle
          entries.emplace_back(i, j + 1, -it.value().imag());
      }
    Sparse_matrix real(2 * lower.rows(), 2 * lower.cols());
    real.setFromTriplets(entries.begin(), entries.end());
    return m_solver.factorize(real);
  }

  Eigen::VectorXcd solve(const Eigen::VectorXcd& right) override
  {
    Eigen::VectorXd parts(2 * right.size());
    for(Eigen::Index i = 0; i < right.size(); ++i)
      parts.segment<2>(2 * i) << right[i].real(), right[i].imag();
    parts = m_solver.solve(parts);
    Eigen::VectorXcd result(right.size());
    for(Eigen::Index i = 0; i < right.size(); ++i)
      result[i] = std::complex<double>(parts[2 * i], parts[2 * i + 1]);
    return result;
  }

private:
  Reordering_solver m_solver;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_EMBEDDED_HERMITIAN_SOLVER_H
