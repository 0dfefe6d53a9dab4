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

#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Linear_solver.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The rows of the entries in each column of the upper triangle of a matrix, the diagonal included.
struct Upper_pattern
{
  std::vector<int> starts, rows;

  int size() const { return int(starts.size()) - 1; }
};

// The parents of the columns of a Cholesky factor in its elimination tree, -1 at roots: the row of the first entry
// below the diagonal. Found without the factor, along paths that each visit shortens [Liu 1990].
inline std::vector<int> elimination_tree(const Upper_pattern& upper)
{
  const int n = upper.size();
  std::vector<int> parent(n, -1), ancestor(n, -1);
  for(int column = 0; column < n; ++column)
    for(int entry = upper.starts[column]; entry < upper.starts[column + 1]; ++entry)
      for(int i = upper.rows[entry]; i >= 0 && i < column;)
      {
        const int next = std::exchange(ancestor[i], column);
        if(next < 0)
          parent[i] = column;
        i = next;
      }
  return parent;
}

// The place of each node of a forest in a postorder: subtrees are consecutive, the largest one right before its
// root. Parents have larger numbers than their children.
inline std::vector<int> postorder(const std::vector<int>& parent)
{
  const int n = int(parent.size());
  std::vector<int> size(n, 1), largest_child(n, -1);
  for(int v = 0; v < n; ++v)
    if(const int p = parent[v]; p >= 0)
    {
      size[p] += size[v];
      if(largest_child[p] < 0 || size[v] > size[largest_child[p]])
        largest_child[p] = v;
    }
  std::vector<int> place(n), end(n); // `end`: of the next subtree to be placed among the children
  int end_of_roots = n;
  for(int v = n - 1; v >= 0; --v)
  {
    const int p = parent[v];
    const bool is_largest = p >= 0 && largest_child[p] == v;
    int& former_end = p >= 0 ? end[p] : end_of_roots;
    place[v] = (is_largest ? place[p] : former_end) - 1;
    if(!is_largest)
      former_end -= size[v];
    end[v] = place[v] - (largest_child[v] >= 0 ? size[largest_child[v]] : 0);
  }
  return place;
}

// The columns of a Cholesky factor in groups with the same rows below them, up to a few zeros: supernodes
// [Ashcraft, Grimes 1989]. Columns are numbered in a postorder of the elimination tree. Where a matrix consists of
// blocks of two rows and columns, as that of a map to the plane, all is found for nodes of two unknowns.
class Supernodes
{
public:
  Supernodes() = default;
  explicit Supernodes(const Sparse_matrix& upper) : m_node_size(has_pairs(upper) ? 2 : 1)
  {
    sort_entries(upper);
    find_supernodes();
    find_parents();
    locate_rows();
  }

  int number_of_columns() const { return m_node_size * int(m_places.size()); }
  int size() const { return int(m_supernodes.size()) - 1; }
  // The number of an unknown among the columns.
  int place(int unknown) const { return m_node_size * m_places[unknown / m_node_size] + unknown % m_node_size; }
  int first_column(int s) const { return m_node_size * m_supernodes[s].first_node; }
  int width(int s) const { return first_column(s + 1) - first_column(s); }
  int number_of_rows_below(int s) const
  { return m_node_size * (m_supernodes[s + 1].first_row - m_supernodes[s].first_row); }
  int height(int s) const { return width(s) + number_of_rows_below(s); }
  int parent(int s) const { return m_parents[s]; } // -1 at roots
  // The places of the rows below the supernode in its parent, whose own columns come first.
  const int* rows_in_parent(int s) const
  { return m_rows_in_parent.data() + std::size_t(m_node_size) * m_supernodes[s].first_row; }

  // Calls `f(row, column, entry)` for the entries of the matrix in the columns of a supernode: where they are in it,
  // and their numbers in the matrix.
  template <typename Function>
  void for_each_entry(int s, const Function& f) const
  {
    const int first = m_supernodes[s].first_node, end = m_supernodes[s + 1].first_node;
    for(int node = first; node < end; ++node)
      for(int i = m_starts[node]; i < m_starts[node + 1]; ++i)
      {
        const Entry& e = m_entries[i];
        const int row = m_node_size * e.row, column = m_node_size * (node - first);
        f(row, column, e.first);
        if(m_node_size == 1)
          continue;
        f(row + 1, column, e.second);
        f(row + 1, column + 1, e.second + 1);
        if(row != column)
          f(row, column + 1, e.first + 1);
      }
  }

  // About as many operations as its part of the factorization takes.
  double work(int s) const { return double(width(s)) * height(s) * height(s); }

private:
  struct Supernode
  {
    int first_node;
    int first_row; // in m_rows_below
    double zeros;  // entries that are stored, but zero
  };

  // An entry, or a block of two rows and columns, below the diagonal or on it. `first` and `second` number the entries
  // in its first row; below the diagonal, those in the second row come next to each.
  struct Entry { int row, first, second; };

  // Whether the upper triangle consists of blocks of two rows and columns.
  static bool has_pairs(const Sparse_matrix& upper)
  {
    if(upper.cols() % 2 != 0)
      return false;
    for(int column = 0; column < upper.cols(); column += 2)
    {
      const int* const starts = upper.outerIndexPtr() + column;
      const int size = starts[1] - starts[0];
      const int *const rows = upper.innerIndexPtr() + starts[0], *const next_rows = upper.innerIndexPtr() + starts[1];
      if(size % 2 == 0 || starts[2] - starts[1] != size + 1 || rows[size - 1] != column || next_rows[size] != column + 1
         || !std::equal(rows, rows + size, next_rows))
        return false;
      for(int i = 0; i + 1 < size; i += 2)
        if(rows[i] % 2 != 0 || rows[i + 1] != rows[i] + 1)
          return false;
    }
    return true;
  }

  // The pattern of the nodes; calls `f(i)` for the entry of the matrix that is the first one of each of the pattern's.
  template <typename Function>
  Upper_pattern node_pattern(const Sparse_matrix& upper, const Function& f) const
  {
    Upper_pattern pattern;
    pattern.starts.push_back(0);
    for(int column = 0; column < upper.cols(); column += m_node_size)
    {
      for(int i = upper.outerIndexPtr()[column]; i < upper.outerIndexPtr()[column + 1]; i += m_node_size)
        if(upper.innerIndexPtr()[i] <= column)
        {
          pattern.rows.push_back(upper.innerIndexPtr()[i] / m_node_size);
          f(i);
        }
      pattern.starts.push_back(int(pattern.rows.size()));
    }
    return pattern;
  }

  // The lower triangle by columns, in postorder.
  void sort_entries(const Sparse_matrix& upper)
  {
    std::vector<int> first_entries;
    const Upper_pattern pattern = node_pattern(upper, [&](int i) { first_entries.push_back(i); });
    const int n = pattern.size();
    const std::vector<int> parent = elimination_tree(pattern);
    m_places = postorder(parent);
    m_parents.assign(n, -1);
    std::vector<int> nodes(n);
    m_starts.assign(n + 1, 0);
    for(int v = 0; v < n; ++v)
    {
      nodes[m_places[v]] = v;
      if(parent[v] >= 0)
        m_parents[m_places[v]] = m_places[parent[v]];
    }
    for(int v : pattern.rows)
      ++m_starts[m_places[v] + 1];
    for(int c = 0; c < n; ++c)
      m_starts[c + 1] += m_starts[c];
    m_entries.resize(m_starts[n]);
    std::vector<int> ends(m_starts.begin(), m_starts.end() - 1);
    // Rows come in ascending order: an entry's row is above its column in the tree, hence later in the postorder.
    for(int row = 0; row < n; ++row)
    {
      const int node = nodes[row], column = m_node_size * node;
      const int to_next = m_node_size == 2 ? upper.outerIndexPtr()[column + 1] - upper.outerIndexPtr()[column] : 0;
      for(int i = pattern.starts[node]; i < pattern.starts[node + 1]; ++i)
        m_entries[ends[m_places[pattern.rows[i]]]++] = {row, first_entries[i], first_entries[i] + to_next};
    }
  }

  void find_supernodes()
  {
    const int n = int(m_places.size());
    std::vector<int> marks(n, -1), first_child(n, -1), next_sibling; // supernodes by the column above them
    std::vector<int> new_rows;
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
        f(m_entries[i].row);
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
          new_rows.push_back(row);
      });
      m_rows_below.insert(m_rows_below.end(), new_rows.begin(), new_rows.end());
      new_rows.clear();
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
    m_rows_below.erase(rows, rows + (end - s.first_node - 1));
    while(m_supernodes.size() > 1)
    {
      const Supernode latest = m_supernodes.back();
      Supernode& child = m_supernodes[m_supernodes.size() - 2];
      const double width = latest.first_node - child.first_node, rows_below = m_rows_below.size() - latest.first_row;
      const double rows_of_child = latest.first_row - child.first_row, total = end - child.first_node;
      if(rows_of_child == 0 || m_rows_below[child.first_row] >= end)
        return;
      const double zeros = child.zeros + latest.zeros + width * (end - latest.first_node + rows_below - rows_of_child);
      if(zeros > bearable_share(m_node_size * int(total)) * (0.5 * total * (total + 1) + total * rows_below))
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
    std::vector<int> supernodes(m_places.size());
    for(int s = 0; s < size(); ++s)
      std::fill(supernodes.begin() + m_supernodes[s].first_node, supernodes.begin() + m_supernodes[s + 1].first_node, s);
    m_parents.assign(size(), -1);
    for(int s = 0; s < size(); ++s)
      if(number_of_rows_below(s) > 0)
        m_parents[s] = supernodes[m_rows_below[m_supernodes[s].first_row]];
  }

  // Replaces rows by where they are in the supernodes that need them.
  void locate_rows()
  {
    m_rows_in_parent.reserve(m_node_size * m_rows_below.size());
    for(int s = 0; s < size(); ++s)
    {
      for(int node = m_supernodes[s].first_node; node < m_supernodes[s + 1].first_node; ++node)
      {
        int below = m_supernodes[s].first_row;
        for(int i = m_starts[node]; i < m_starts[node + 1]; ++i)
          m_entries[i].row = row_in(s, m_entries[i].row, below);
      }
      int below = parent(s) < 0 ? 0 : m_supernodes[parent(s)].first_row;
      for(int i = m_supernodes[s].first_row; i < m_supernodes[s + 1].first_row; ++i)
      {
        const int row = row_in(parent(s), m_rows_below[i], below);
        for(int k = 0; k < m_node_size; ++k)
          m_rows_in_parent.push_back(m_node_size * row + k);
      }
    }
    std::vector<int>().swap(m_rows_below);
  }

  // Where a row is in a supernode; `below` goes up in its list of rows below, from row to row.
  int row_in(int s, int row, int& below) const
  {
    const Supernode& supernode = m_supernodes[s];
    const int end = m_supernodes[s + 1].first_node;
    if(row < end)
      return row - supernode.first_node;
    while(m_rows_below[below] < row)
      ++below;
    return end - supernode.first_node + below - supernode.first_row;
  }

  int m_node_size = 1;       // unknowns per node; all below is in nodes, but for m_rows_in_parent
  std::vector<int> m_places;
  std::vector<int> m_parents; // of the nodes, then of the supernodes
  std::vector<int> m_starts;  // of the entries of each column
  std::vector<Entry> m_entries;
  std::vector<Supernode> m_supernodes; // and one past the last
  std::vector<int> m_rows_below;
  std::vector<int> m_rows_in_parent;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_SUPERNODES_H
