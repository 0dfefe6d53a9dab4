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

#include <boost/pending/disjoint_sets.hpp>

#include <numeric>
#include <vector>

namespace CGAL {
namespace internal {
namespace Graph_kernel {

// the sets of the indices 0..size-1, each in one of its own at first
class Disjoint_sets
{
  std::vector<int> m_rank, m_parent;
  boost::disjoint_sets<int*, int*> m_sets;

public:
  explicit Disjoint_sets(int size) : m_rank(size, 0), m_parent(size), m_sets(m_rank.data(), m_parent.data())
  {
    std::iota(m_parent.begin(), m_parent.end(), 0);
  }

  int find(int i) { return m_sets.find_set(i); }

  // false if they were together already
  bool unite(int i, int j)
  {
    i = find(i);
    j = find(j);
    if(i == j)
      return false;
    m_sets.link(i, j);
    return true;
  }
};

} // namespace Graph_kernel
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_GRAPH_KERNEL_DISJOINT_SETS_H
