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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_SUPERNODAL_FACTORIZATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_SUPERNODAL_FACTORIZATION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Supernodes.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Tree_schedule.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/dense_cholesky.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// The factors L L^T of a symmetric matrix by the multifrontal method [Duff, Reid 1983]: each supernode adds up its
// part of the matrix and what its children subtract from it and from the rows above, eliminates its columns as a dense
// matrix, and hands the rest to its parent. Independent subtrees are factorized at the same time; sums have the order
// of the children, so that results do not depend on the number of threads.
class Supernodal_factorization
{
public:
  explicit Supernodal_factorization(Execution execution = Execution::SEQUENTIAL) : m_execution(execution) {}

  // Of `upper`, as everywhere, only the upper triangle counts.
  void analyze(const Sparse_matrix& upper)
  {
    m_supernodes = Supernodes(upper);
    const int n = m_supernodes.size();
    std::vector<int> parents(n);
    std::vector<double> work(n);
    m_first_child.assign(n, -1);
    m_next_sibling.assign(n, -1);
    m_starts.assign(n + 1, 0);
    m_starts_below.assign(n + 1, 0);
    for(int s = n - 1; s >= 0; --s) // lists in ascending order
    {
      parents[s] = m_supernodes.parent(s);
      work[s] = m_supernodes.work(s);
      if(parents[s] >= 0)
      {
        m_next_sibling[s] = m_first_child[parents[s]];
        m_first_child[parents[s]] = s;
      }
    }
    for(int s = 0; s < n; ++s)
    {
      m_starts_below[s + 1] = m_starts_below[s] + std::size_t(m_supernodes.number_of_rows_below(s));
      m_starts[s + 1] = m_starts[s] + std::size_t(m_supernodes.height(s)) * m_supernodes.width(s);
    }
    m_schedule = Tree_schedule(parents, work);
    m_values.reset();
    m_rests.clear();
    m_rests.resize(n);
  }

  // For the pattern that was analyzed. False if a pivot is not positive, or once `go_further()` does not want more.
  bool factorize(const Sparse_matrix& upper, const Go_further& go_further)
  {
    if(!m_values)
      m_values.reset(new double[m_starts.back()]);
    Work_meter meter(go_further);
    m_schedule.ascend(m_execution, [&](int s)
    {
      if(meter.is_given_up() || !eliminate(upper.valuePtr(), s, meter))
        meter.give_up();
    });
    if(!meter.is_given_up())
      return true;
    for(std::unique_ptr<double[]>& rest : m_rests)
      rest.reset();
    return false;
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const
  {
    const int n = m_supernodes.number_of_columns();
    Eigen::VectorXd x(n), result(n);
    for(int i = 0; i < n; ++i)
      x[m_supernodes.place(i)] = right[i];
    Eigen::VectorXd below(m_starts_below.back()); // of x, at the rows below each supernode
    m_schedule.ascend(m_execution, [&](int s) { solve_forward(s, x, below); });
    m_schedule.descend(m_execution, [&](int s) { solve_backward(s, x, below); });
    for(int i = 0; i < n; ++i)
      result[i] = x[m_supernodes.place(i)];
    return result;
  }

private:
  // The columns of a supernode: its own rows, then those below.
  Dense_block columns(int s) const
  {
    const int height = m_supernodes.height(s);
    return Dense_block(m_values.get() + m_starts[s], height, m_supernodes.width(s), Eigen::OuterStride<>(height));
  }

  // What a supernode subtracts from the rows below it, negative.
  Dense_block rest(int s) const
  {
    const int size = m_supernodes.number_of_rows_below(s);
    return Dense_block(m_rests[s].get(), size, size, Eigen::OuterStride<>(size));
  }

  bool eliminate(const double* values, int s, Work_meter& meter)
  {
    const int width = m_supernodes.width(s), below = m_supernodes.number_of_rows_below(s);
    Dense_block own = columns(s);
    own.setZero();
    m_supernodes.for_each_entry(s, [&](int row, int column, int entry) { own(row, column) += values[entry]; });
    if(below > 0)
      m_rests[s].reset(new double[std::size_t(below) * below]()); // zeros
    for(int child = m_first_child[s]; child >= 0; child = m_next_sibling[child])
    {
      add_rest(child, own, s);
      m_rests[child].reset();
    }
    if(!factorize_columns(m_execution, own, meter))
      return false;
    if(below > 0)
    {
      Dense_block remaining = rest(s);
      subtract_product(m_execution, part(own, width, 0, below, width), remaining);
    }
    return true;
  }

  void add_rest(int child, Dense_block& own, int s)
  {
    const Dense_block added = rest(child);
    const int size = int(added.rows()), width = int(own.cols());
    const int* const rows = m_supernodes.rows_in_parent(child);
    const int below = m_supernodes.number_of_rows_below(s);
    for(int j = 0; j < size; ++j)
    {
      const double* const source = added.data() + std::size_t(j) * size;
      double* const target = rows[j] < width ? &own.coeffRef(0, rows[j])
                                             : m_rests[s].get() + std::size_t(rows[j] - width) * below - width;
      for(int i = j; i < size; ++i)
        target[rows[i]] += source[i];
    }
  }

  // The part of a vector over the rows below all supernodes that belongs to one.
  Eigen::VectorBlock<Eigen::VectorXd> rows_below(Eigen::VectorXd& below, int s) const
  {
    return below.segment(m_starts_below[s], m_supernodes.number_of_rows_below(s));
  }

  // Children hand on what they subtract from the right side, as with the matrix.
  void solve_forward(int s, Eigen::VectorXd& x, Eigen::VectorXd& below) const
  {
    const Dense_block own = columns(s);
    const int width = int(own.cols());
    auto solution = x.segment(m_supernodes.first_column(s), width);
    auto rest = rows_below(below, s);
    rest.setZero();
    for(int child = m_first_child[s]; child >= 0; child = m_next_sibling[child])
    {
      const int* const rows = m_supernodes.rows_in_parent(child);
      const auto added = rows_below(below, child);
      for(int i = 0; i < int(added.size()); ++i)
        (rows[i] < width ? solution[rows[i]] : rest[rows[i] - width]) += added[i];
    }
    for(int j = 0; j < width; ++j)
    {
      const double value = solution[j] /= own(j, j);
      solution.tail(width - j - 1) -= value * own.col(j).segment(j + 1, width - j - 1);
    }
    rest.noalias() -= own.bottomRows(rest.size()) * solution;
  }

  void solve_backward(int s, Eigen::VectorXd& x, Eigen::VectorXd& below) const
  {
    const Dense_block own = columns(s);
    const int width = int(own.cols()), parent = m_supernodes.parent(s);
    auto rest = rows_below(below, s);
    if(parent >= 0)
    {
      const int* const rows = m_supernodes.rows_in_parent(s);
      const int parent_width = m_supernodes.width(parent);
      const auto above = x.segment(m_supernodes.first_column(parent), parent_width);
      const auto rest_above = rows_below(below, parent);
      for(int i = 0; i < int(rest.size()); ++i)
        rest[i] = rows[i] < parent_width ? above[rows[i]] : rest_above[rows[i] - parent_width];
    }
    auto solution = x.segment(m_supernodes.first_column(s), width);
    solution.noalias() -= own.bottomRows(rest.size()).transpose() * rest;
    for(int j = width - 1; j >= 0; --j)
      solution[j] = (solution[j] - own.col(j).segment(j + 1, width - j - 1).dot(solution.tail(width - j - 1))) / own(j, j);
  }

  Execution m_execution;
  Supernodes m_supernodes;
  Tree_schedule m_schedule;
  std::vector<int> m_first_child, m_next_sibling;
  std::vector<std::size_t> m_starts, m_starts_below; // of the columns of each supernode, and of the rows below them
  std::unique_ptr<double[]> m_values;
  std::vector<std::unique_ptr<double[]> > m_rests;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_SUPERNODAL_FACTORIZATION_H
