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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_INDEX_SETS_H
#define CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_INDEX_SETS_H

#include <algorithm>
#include <numeric>
#include <vector>

namespace CGAL::internal::Graph_kernel {

// A set of numbers from 0 to a known one, in the order in which they come until it is sorted. One mark for each possible
// number is kept, so that all calls but sorting take time for what the set holds alone, and it can be used again.
class Index_set
{
public:
  explicit Index_set(int number_of_possible = 0) : m_is_in(number_of_possible, 0) {}

  int number_of_possible() const { return int(m_is_in.size()); }
  bool contains(int i) const { return m_is_in[i]; }
  const std::vector<int>& indices() const { return m_indices; }

  void insert(int i)
  {
    if(!m_is_in[i])
    {
      m_is_in[i] = 1;
      m_indices.push_back(i);
    }
  }

  void sort() { std::sort(m_indices.begin(), m_indices.end()); }

  void clear()
  {
    for(int i : m_indices)
      m_is_in[i] = 0;
    m_indices.clear();
  }

private:
  std::vector<char> m_is_in;
  std::vector<int> m_indices;
};

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

  // takes i apart; so must be all of its set
  void reset(int i) { m_parent[i] = i; }
};

} // namespace CGAL::internal::Graph_kernel

#endif // CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_INDEX_SETS_H
