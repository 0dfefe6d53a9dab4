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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_DENSE_CHOLESKY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_DENSE_CHOLESKY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>

#include <Eigen/Core>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

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

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_DENSE_CHOLESKY_H
