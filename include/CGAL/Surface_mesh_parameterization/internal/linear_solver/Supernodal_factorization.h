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

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Supernodes.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Tree_schedule.h>

#include <Eigen/Core>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A part of a matrix in memory.
using Dense_block = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<> >;

inline Dense_block part(Dense_block& block, int row, int column, int rows, int columns)
{
  return Dense_block(&block.coeffRef(row, column), rows, columns, block.outerStride());
}

// Asks from time to time whether to go on; several threads may work.
class Work_meter
{
public:
  explicit Work_meter(const Go_further& go_further) : m_go_further(go_further) {}

  // False once the work is not wanted any more.
  bool add(double operations)
  {
    constexpr std::size_t operations_between_questions = 40000000; // some hundredths of a second
    const std::size_t added = std::size_t(operations), before = m_operations.fetch_add(added);
    if(before / operations_between_questions != (before + added) / operations_between_questions && !m_go_further())
      give_up();
    return !is_given_up();
  }
  void give_up() { m_is_given_up = true; }
  bool is_given_up() const { return m_is_given_up; }

private:
  const Go_further& m_go_further;
  std::atomic<std::size_t> m_operations{0};
  std::atomic<bool> m_is_given_up{false};
};

// Subtracts a b^T from the lower trapezoid c, where b are the upper rows of a, which has few columns: Eigen's
// product packs its operands, which pays only for large blocks.
inline void subtract_thin_product(const Dense_block& a, Dense_block& c)
{
  const int depth = int(a.cols()), rows = int(c.rows());
  for(int j = 0; j < c.cols(); ++j)
  {
    const int count = rows - j;
    auto column = c.col(j).tail(count);
    int k = 0;
    for(; k + 4 <= depth; k += 4)
      column.noalias() -= a(j, k) * a.col(k).tail(count) + a(j, k + 1) * a.col(k + 1).tail(count)
                          + a(j, k + 2) * a.col(k + 2).tail(count) + a(j, k + 3) * a.col(k + 3).tail(count);
    for(; k < depth; ++k)
      column.noalias() -= a(j, k) * a.col(k).tail(count);
  }
}

constexpr int tile_width = 96;

// Sets what `subtract_product()` looks at: the lower triangle of a square matrix of this size, which is all of its
// storage, and the rest of the tiles on the diagonal.
inline void set_lower_triangle_to_zero(double* values, int size)
{
  const std::size_t stride = std::size_t(size);
  std::fill_n(values, stride * (std::min)(size, tile_width), 0.);
  for(int j = tile_width; j < size; ++j)
  {
    const int top = j / tile_width * tile_width;
    std::fill_n(values + j * stride + top, size - top, 0.);
  }
}

// The same as `subtract_thin_product()` for any number of columns. Tiles do not depend on the number of threads.
inline void subtract_product(Execution execution, const Dense_block& a, Dense_block& c)
{
  constexpr int thin = 12, tile_height = 480;
  const int rows = int(c.rows()), columns = int(c.cols()), depth = int(a.cols());
  if(depth <= thin || rows <= 2 * thin)
  {
    subtract_thin_product(a, c);
    return;
  }
  const int tiles_across = (columns + tile_width - 1) / tile_width, tiles_down = (rows + tile_height - 1) / tile_height;
  const bool is_large = double(rows) * columns * depth > 4e6; // about a millisecond
  execute(is_large ? execution : Execution::SEQUENTIAL, tiles_across * tiles_down, [&](int tile)
  {
    const int j = tile % tiles_across * tile_width, width = (std::min)(tile_width, columns - j);
    const int top = tile / tiles_across * tile_height, i = (std::max)(top, j);
    const int height = (std::min)(rows, top + tile_height) - i;
    if(height > 0)
      c.block(i, j, height, width).noalias() -= a.middleRows(i, height) * a.middleRows(j, width).transpose();
  });
}

// The part of a column from the diagonal on, divided by the root of the pivot. False if that is not positive.
inline bool divide_column(Dense_block& matrix, int j)
{
  const double pivot = matrix(j, j);
  if(!(pivot > 0))
    return false;
  matrix.col(j).tail(matrix.rows() - j) /= std::sqrt(pivot);
  return true;
}

// The first columns of the Cholesky factor of a symmetric matrix, in place of its own; the part above the diagonal
// is not read. By halves, so that nearly all operations are products. False if a pivot is not positive.
inline bool factorize_columns(Execution execution, Dense_block matrix, Work_meter& meter)
{
  constexpr int narrow = 16;
  const int rows = int(matrix.rows()), columns = int(matrix.cols());
  if(columns > narrow)
  {
    const int half = (columns / 2 + narrow - 1) / narrow * narrow;
    if(!factorize_columns(execution, part(matrix, 0, 0, rows, half), meter))
      return false;
    Dense_block rest = part(matrix, half, half, rows - half, columns - half);
    subtract_product(execution, part(matrix, half, 0, rows - half, half), rest);
    return factorize_columns(execution, rest, meter);
  }
  for(int j = 0; j < columns; j += 2) // by pairs: the others are passed over half as often
  {
    if(!divide_column(matrix, j))
      return false;
    if(j + 1 == columns)
      break;
    const int rest = rows - j - 1;
    matrix.col(j + 1).tail(rest) -= matrix(j + 1, j) * matrix.col(j).tail(rest);
    if(!divide_column(matrix, j + 1))
      return false;
    for(int k = j + 2; k < columns; ++k)
      matrix.col(k).tail(rows - k)
        -= matrix(k, j) * matrix.col(j).tail(rows - k) + matrix(k, j + 1) * matrix.col(j + 1).tail(rows - k);
  }
  return meter.add(double(rows) * rows * columns);
}

// The factors L L^T of a symmetric matrix by the multifrontal method [Duff, Reid 1983]: each supernode adds up its
// part of the matrix and what its children subtract from it and from the rows above, eliminates its columns as a dense
// matrix, and hands the rest to its parent. Independent subtrees are factorized at the same time; sums have the order
// of the children, so that results do not depend on the number of threads.
class Supernodal_factorization
{
public:
  explicit Supernodal_factorization(Execution execution = Execution::SEQUENTIAL) : m_execution(execution) {}

  // Only the upper triangle counts.
  void analyze(const Sparse_matrix& upper)
  {
    m_supernodes = Supernodes(upper);
    const int n = m_supernodes.size();
    std::vector<int> parents(n);
    std::vector<double> work(n);
    m_first_child.assign(n, -1);
    m_next_sibling.assign(n, -1);
    m_starts.assign(n + 1, 0);
    m_starts_of_rows.assign(n + 1, 0);
    std::vector<int> rows_of_columns(m_supernodes.number_of_columns());
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
      m_starts_of_rows[s + 1] = m_starts_of_rows[s] + m_supernodes.height(s);
      for(int j = 0; j < m_supernodes.width(s); ++j)
        rows_of_columns[m_supernodes.first_column(s) + j] = m_starts_of_rows[s] + j;
      m_starts[s + 1] = m_starts[s] + std::size_t(m_supernodes.height(s)) * m_supernodes.width(s);
    }
    m_rows.resize(rows_of_columns.size());
    for(int i = 0; i < int(m_rows.size()); ++i)
      m_rows[i] = rows_of_columns[m_supernodes.place(i)];
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
    Eigen::VectorXd fronts(m_starts_of_rows.back()), result(n); // parts of vectors, at the rows of each supernode
    const auto for_each_unknown = [&](const auto& f)
    {
      execute_blocks(m_execution, n, [&](int begin, int end)
      {
        for(int i = begin; i < end; ++i)
          f(i);
      });
    };
    for_each_unknown([&](int i) { fronts[m_rows[i]] = right[i]; });
    m_schedule.ascend(m_execution, [&](int s) { solve_forward(s, fronts); });
    m_schedule.descend(m_execution, [&](int s) { solve_backward(s, fronts); });
    for_each_unknown([&](int i) { result[i] = fronts[m_rows[i]]; });
    return result;
  }

private:
  // The columns of a supernode: its own rows, then those below.
  Dense_block columns(int s) const
  {
    const int height = m_supernodes.height(s);
    return Dense_block(m_values.get() + m_starts[s], height, m_supernodes.width(s), Eigen::OuterStride<>(height));
  }

  // The negative of the part that a supernode subtracts from the rows below it.
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
    {
      m_rests[s].reset(new double[std::size_t(below) * below]);
      set_lower_triangle_to_zero(m_rests[s].get(), below);
    }
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

  double* front(Eigen::VectorXd& fronts, int s) const { return fronts.data() + m_starts_of_rows[s]; }

  // Children hand on what they subtract from the right side, as with the matrix. Columns come in pairs, as most
  // unknowns do: the rows are passed over half as often.
  void solve_forward(int s, Eigen::VectorXd& fronts) const
  {
    const Dense_block own = columns(s);
    const int width = int(own.cols()), height = int(own.rows());
    Eigen::Map<Eigen::VectorXd> x(front(fronts, s), height);
    x.tail(height - width).setZero();
    for(int child = m_first_child[s]; child >= 0; child = m_next_sibling[child])
    {
      const int* const rows = m_supernodes.rows_in_parent(child);
      const double* const added = front(fronts, child) + m_supernodes.width(child);
      for(int i = 0; i < m_supernodes.number_of_rows_below(child); ++i)
        x[rows[i]] += added[i];
    }
    int j = 0;
    for(; j + 2 <= width; j += 2)
    {
      const int rest = height - j - 2;
      const double first = x[j] /= own(j, j), second = x[j + 1] = (x[j + 1] - own(j + 1, j) * first) / own(j + 1, j + 1);
      x.tail(rest) -= first * own.col(j).tail(rest) + second * own.col(j + 1).tail(rest);
    }
    if(j < width)
    {
      const double last = x[j] /= own(j, j);
      x.tail(height - j - 1) -= last * own.col(j).tail(height - j - 1);
    }
  }

  void solve_backward(int s, Eigen::VectorXd& fronts) const
  {
    const Dense_block own = columns(s);
    const int width = int(own.cols()), height = int(own.rows());
    Eigen::Map<Eigen::VectorXd> x(front(fronts, s), height);
    if(m_supernodes.parent(s) >= 0)
    {
      const int* const rows = m_supernodes.rows_in_parent(s);
      const double* const above = front(fronts, m_supernodes.parent(s));
      for(int i = 0; i < height - width; ++i)
        x[width + i] = above[rows[i]];
    }
    for(int j = width - 1; j >= 0; --j)
    {
      const int rest = height - j - 1;
      x[j] = (x[j] - own.col(j).tail(rest).dot(x.tail(rest))) / own(j, j);
    }
  }

  Execution m_execution;
  Supernodes m_supernodes;
  Tree_schedule m_schedule;
  std::vector<int> m_first_child, m_next_sibling;
  std::vector<std::size_t> m_starts; // of the columns of each supernode
  std::vector<int> m_starts_of_rows; // of each supernode, where those of all are in one vector
  std::vector<int> m_rows;           // of each unknown, among these
  std::unique_ptr<double[]> m_values;
  std::vector<std::unique_ptr<double[]> > m_rests;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_SUPERNODAL_FACTORIZATION_H
