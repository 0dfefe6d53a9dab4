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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_SUPERNODES_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_SUPERNODES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Elimination_tree.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

// The columns of a Cholesky factor in groups with the same rows below them, up to a few zeros: supernodes
// [Ashcraft, Grimes 1989]. Columns are numbered in a postorder of the elimination tree.
class Supernodes
{
public:
  Supernodes() = default;
  explicit Supernodes(const Sparse_matrix& upper)
  {
    sort_entries(upper);
    find_supernodes();
    find_parents();
    locate_rows();
  }

  int number_of_columns() const { return int(m_places.size()); }
  int size() const { return int(m_supernodes.size()) - 1; }
  // The number of each unknown among the columns.
  const std::vector<int>& places() const { return m_places; }
  int first_column(int s) const { return m_supernodes[s].first_column; }
  int width(int s) const { return first_column(s + 1) - first_column(s); }
  int number_of_rows_below(int s) const { return m_supernodes[s + 1].first_row - m_supernodes[s].first_row; }
  int height(int s) const { return width(s) + number_of_rows_below(s); }
  int parent(int s) const { return m_parents[s]; } // -1 at roots
  // Of the rows below the supernode, their places in its parent, whose own columns come first.
  const int* rows_in_parent(int s) const { return m_rows_in_parent.data() + m_supernodes[s].first_row; }

  // Calls `f(row, entry)` for the entries of the matrix in a column: where they are in the supernode, and their
  // numbers in the matrix.
  template <typename Function>
  void for_each_entry(int column, const Function& f) const
  {
    for(int i = m_starts[column]; i < m_starts[column + 1]; ++i)
      f(m_rows[i], m_entries[i]);
  }

  // About as many operations as its part of the factorization takes.
  double work(int s) const { return double(width(s)) * height(s) * height(s); }

private:
  struct Supernode
  {
    int first_column;
    int first_row; // in m_rows_below
    double zeros;  // entries that are stored, but zero
  };

  // The lower triangle by columns, in postorder.
  void sort_entries(const Sparse_matrix& upper)
  {
    const int n = int(upper.cols());
    std::vector<int> parent = elimination_tree(upper);
    m_places = postorder(parent);
    m_parents.assign(n, -1);
    std::vector<int> columns(n);
    for(int v = 0; v < n; ++v)
    {
      columns[m_places[v]] = v;
      if(parent[v] >= 0)
        m_parents[m_places[v]] = m_places[parent[v]];
    }
    m_starts.assign(n + 1, 0);
    for_each_upper_entry(upper, columns, [&](int column, int, int) { ++m_starts[column + 1]; });
    for(int c = 0; c < n; ++c)
      m_starts[c + 1] += m_starts[c];
    m_rows.resize(m_starts[n]);
    m_entries.resize(m_starts[n]);
    std::vector<int> ends(m_starts.begin(), m_starts.end() - 1);
    for_each_upper_entry(upper, columns, [&](int column, int row, int entry)
    {
      m_rows[ends[column]] = row;
      m_entries[ends[column]++] = entry;
    });
  }

  // Rows come in ascending order: an entry's row is above its column in the tree, hence later in the postorder.
  template <typename Function>
  void for_each_upper_entry(const Sparse_matrix& upper, const std::vector<int>& columns, const Function& f) const
  {
    for(int row = 0; row < int(columns.size()); ++row)
      for(Sparse_matrix::InnerIterator it(upper, columns[row]); it; ++it)
        if(it.index() <= columns[row])
          f(m_places[it.index()], row, int(&it.value() - upper.valuePtr()));
  }

  void find_supernodes()
  {
    const int n = number_of_columns();
    std::vector<int> marks(n, -1), first_child(n, -1), next_sibling; // supernodes by the column above them
    int mark = -1;
    const auto close = [&](int end)
    {
      close_supernode(end);
      if(m_rows_below.size() == std::size_t(m_supernodes.back().first_row))
        return;
      const int s = int(m_supernodes.size()) - 1, above = m_rows_below[m_supernodes.back().first_row];
      next_sibling.resize(s + 1);
      next_sibling[s] = std::exchange(first_child[above], s);
    };
    // The rows below a column: those of the matrix and of the supernodes whose parent it is.
    const auto for_each_row_below = [&](int column, const auto& f)
    {
      for(int i = m_starts[column]; i < m_starts[column + 1]; ++i)
        f(m_rows[i]);
      for(int s = first_child[column]; s >= 0; s = next_sibling[s])
      {
        const int last = s + 1 < int(m_supernodes.size()) ? m_supernodes[s + 1].first_row : int(m_rows_below.size());
        for(int i = m_supernodes[s].first_row; i < last; ++i)
          f(m_rows_below[i]);
      }
    };
    for(int column = 0; column < n; ++column)
    {
      if(column > 0 && m_parents[column - 1] == column)
      {
        bool has_same_rows = true;
        for_each_row_below(column, [&](int row) { has_same_rows = has_same_rows && marks[row] == mark; });
        if(has_same_rows)
          continue;
      }
      if(column > 0)
        close(column);
      mark = column;
      marks[column] = mark;
      const int first_row = int(m_rows_below.size());
      for_each_row_below(column, [&](int row)
      {
        if(std::exchange(marks[row], mark) != mark)
          m_new_rows.push_back(row);
      });
      m_rows_below.insert(m_rows_below.end(), m_new_rows.begin(), m_new_rows.end());
      m_new_rows.clear();
      std::sort(m_rows_below.begin() + first_row, m_rows_below.end());
      m_supernodes.push_back({column, first_row, 0});
    }
    if(n > 0)
      close(n);
    m_supernodes.push_back({n, int(m_rows_below.size()), 0});
  }

  // Takes its own columns out of the rows of the latest supernode, and merges it with the one before as long as that
  // is its child and hardly any zeros are stored for it.
  void close_supernode(int end)
  {
    Supernode& s = m_supernodes.back();
    const auto rows = m_rows_below.begin() + s.first_row;
    m_rows_below.erase(rows, rows + (end - s.first_column - 1));
    while(m_supernodes.size() > 1)
    {
      const Supernode latest = m_supernodes.back();
      Supernode& child = m_supernodes[m_supernodes.size() - 2];
      const double width = latest.first_column - child.first_column, rows_below = m_rows_below.size() - latest.first_row;
      const double rows_of_child = latest.first_row - child.first_row, total = end - child.first_column;
      if(rows_of_child == 0 || m_rows_below[child.first_row] >= end)
        return;
      const double zeros
        = child.zeros + latest.zeros + width * (end - latest.first_column + rows_below - rows_of_child);
      if(zeros > bearable_share(int(total)) * (0.5 * total * (total + 1) + total * rows_below))
        return;
      m_rows_below.erase(m_rows_below.begin() + child.first_row, m_rows_below.begin() + latest.first_row);
      child.zeros = zeros;
      m_supernodes.pop_back();
    }
  }

  // The share of zeros that costs less than the overhead of another supernode, as in CHOLMOD [CDHR08].
  static double bearable_share(int width)
  {
    return width <= 4 ? 1 : width <= 16 ? 0.8 : width <= 48 ? 0.1 : 0.05;
  }

  void find_parents()
  {
    std::vector<int> supernodes(number_of_columns());
    for(int s = 0; s < size(); ++s)
      std::fill(supernodes.begin() + first_column(s), supernodes.begin() + first_column(s + 1), s);
    m_parents.assign(size(), -1);
    for(int s = 0; s < size(); ++s)
      if(number_of_rows_below(s) > 0)
        m_parents[s] = supernodes[m_rows_below[m_supernodes[s].first_row]];
  }

  // Replaces rows by where they are in the supernodes that need them.
  void locate_rows()
  {
    m_rows_in_parent.resize(m_rows_below.size());
    for(int s = 0; s < size(); ++s)
    {
      for(int column = first_column(s); column < first_column(s + 1); ++column)
        locate(m_rows.begin() + m_starts[column], m_rows.begin() + m_starts[column + 1], s,
               m_rows.begin() + m_starts[column]);
      if(parent(s) >= 0)
        locate(m_rows_below.begin() + m_supernodes[s].first_row, m_rows_below.begin() + m_supernodes[s + 1].first_row,
               parent(s), m_rows_in_parent.begin() + m_supernodes[s].first_row);
    }
    std::vector<int>().swap(m_rows_below);
  }

  using Iterator = std::vector<int>::iterator;
  void locate(Iterator first, Iterator last, int s, Iterator result)
  {
    const Iterator begin = m_rows_below.begin() + m_supernodes[s].first_row;
    Iterator below = begin;
    for(; first != last; ++first)
      if(*first < first_column(s + 1))
        *result++ = *first - first_column(s);
      else
      {
        while(*below < *first)
          ++below;
        *result++ = width(s) + int(below - begin);
      }
  }

  std::vector<int> m_places;
  std::vector<int> m_parents; // of the columns, then of the supernodes
  std::vector<int> m_starts, m_rows, m_entries; // of the matrix's columns
  std::vector<Supernode> m_supernodes; // and one past the last
  std::vector<int> m_rows_below, m_new_rows;
  std::vector<int> m_rows_in_parent;
};

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_SUPERNODES_H
