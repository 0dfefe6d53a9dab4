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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_SIMPLICIAL_FACTORIZATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_SIMPLICIAL_FACTORIZATION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/boost/graph/internal/Graph_kernel/Go_further.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

using CGAL::internal::Graph_kernel::Go_further;
using CGAL::internal::Graph_kernel::always_go_further;

// The factors L D L^H of a Hermitian matrix, by the up-looking method [Davis 2005]: row by row of L, each a
// triangular solve along the elimination tree. Eigen's `SimplicialLDLT` does the same operations, but does not
// let go: on large surfaces, one factorization takes seconds.
template <typename Scalar>
class Simplicial_factorization
{
public:
  using Matrix = Eigen::SparseMatrix<Scalar>;
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

  // The elimination tree, and the sizes of the columns of L. Of `upper`, as everywhere, only the upper triangle
  // counts.
  void analyze(const Matrix& upper)
  {
    const int n = int(upper.cols());
    m_parent.assign(n, -1);
    m_starts.assign(n + 1, 0);
    std::vector<int> row_of_visit(n, -1);
    for(int row = 0; row < n; ++row)
    {
      row_of_visit[row] = row;
      for(typename Matrix::InnerIterator it(upper, row); it; ++it)
        for(int column = int(it.index()); column < row && row_of_visit[column] != row; column = m_parent[column])
        {
          if(m_parent[column] < 0)
            m_parent[column] = row;
          ++m_starts[column + 1];
          row_of_visit[column] = row;
        }
    }
    for(int column = 0; column < n; ++column)
      m_starts[column + 1] += m_starts[column];
    m_rows.resize(m_starts[n]);
    m_values.resize(m_starts[n]);
  }

  // For the pattern that was analyzed. False if a pivot is not positive, or once `go_further()` does not want more.
  bool factorize(const Matrix& upper, const Go_further& go_further)
  {
    constexpr std::size_t operations_between_questions = 20000000; // some hundredths of a second
    std::size_t number_of_operations = 0;
    const int n = int(upper.cols());
    m_pivots.resize(n);
    std::vector<int> ends(m_starts.begin(), m_starts.end() - 1); // of the columns, filled so far
    std::vector<int> row_of_visit(n, -1), pattern(n);
    std::vector<Scalar> values(n, Scalar(0)); // of the row
    for(int row = 0; row < n; ++row)
    {
      const int first = find_pattern(upper, row, row_of_visit, pattern, values);
      double pivot = Eigen::numext::real(std::exchange(values[row], Scalar(0)));
      for(int i = first; i < n; ++i)
      {
        const int column = pattern[i], end = ends[column]++;
        const Scalar value = std::exchange(values[column], Scalar(0));
        const Scalar entry = value / Eigen::numext::real(m_pivots[column]);
        for(int p = m_starts[column]; p < end; ++p)
          values[m_rows[p]] -= Eigen::numext::conj(m_values[p]) * value;
        pivot -= Eigen::numext::real(entry * Eigen::numext::conj(value));
        m_rows[end] = row;
        m_values[end] = entry;
        number_of_operations += std::size_t(end - m_starts[column]);
      }
      m_pivots[row] = pivot;
      if(!(pivot > 0))
        return false;
      if(number_of_operations > operations_between_questions)
      {
        if(!go_further())
          return false;
        number_of_operations = 0;
      }
    }
    return true;
  }

  // Replaces a right side by the solution.
  void solve(Vector& x) const
  {
    const int n = int(x.size());
    for(int column = 0; column < n; ++column)
      if(x[column] != Scalar(0))
        for(int p = m_starts[column]; p < m_starts[column + 1]; ++p)
          x[m_rows[p]] -= x[column] * m_values[p];
    x = m_pivots.asDiagonal().inverse() * x;
    for(int column = n - 1; column >= 0; --column)
    {
      Scalar value = x[column];
      for(int p = m_starts[column]; p < m_starts[column + 1]; ++p)
        value -= Eigen::numext::conj(m_values[p]) * x[m_rows[p]];
      x[column] = value;
    }
  }

private:
  // Scatters a column of the matrix into `values`. The columns of L with an entry in this row are those on the
  // paths from its entries towards the root of the elimination tree: `pattern` lists them, each after those below it
  // in the tree, from the index that is returned to the end.
  int find_pattern(const Matrix& upper, int row, std::vector<int>& row_of_visit, std::vector<int>& pattern,
                   std::vector<Scalar>& values) const
  {
    int first = int(pattern.size());
    row_of_visit[row] = row;
    for(typename Matrix::InnerIterator it(upper, row); it; ++it)
    {
      int column = int(it.index());
      if(column > row)
        continue;
      values[column] += Eigen::numext::conj(it.value());
      int length = 0;
      for(; row_of_visit[column] != row; column = m_parent[column])
      {
        pattern[length++] = column;
        row_of_visit[column] = row;
      }
      while(length > 0)
        pattern[--first] = pattern[--length];
    }
    return first;
  }

  std::vector<int> m_parent; // in the elimination tree; -1 at roots
  std::vector<int> m_starts; // of the columns of L below the diagonal, which is 1
  std::vector<int> m_rows;
  std::vector<Scalar> m_values;
  Vector m_pivots;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_SIMPLICIAL_FACTORIZATION_H
