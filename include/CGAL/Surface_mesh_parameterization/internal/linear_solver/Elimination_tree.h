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

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_ELIMINATION_TREE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_ELIMINATION_TREE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_parameterization {
namespace internal {

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

} // namespace internal
} // namespace Surface_mesh_parameterization
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_SOLVER_ELIMINATION_TREE_H
