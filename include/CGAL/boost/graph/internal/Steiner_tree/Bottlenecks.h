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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_BOTTLENECKS_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_BOTTLENECKS_H

#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>
#include <CGAL/boost/graph/internal/Graph_kernel/Disjoint_sets.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

using Graph_kernel::Disjoint_sets;
using Graph_kernel::Edge;

// The longest links of the paths in a tree. Kruskal's algorithm puts its points into a row: sets that it unites become
// neighbors there, with the link between them. The longest link on the path between two points is the longest one
// between their positions in the row.
class Bottlenecks
{
  std::vector<int> m_positions;
  std::vector<std::vector<double>> m_longest; // [i][j]: of the 2^i links from the j-th on

public:
  // `links` in the order of their weights; O(k log k)
  Bottlenecks(int number_of_points, const std::vector<Edge>& links)
    : m_positions(number_of_points), m_longest(1)
  {
    Disjoint_sets sets(number_of_points);
    std::vector<int> first(number_of_points), last(number_of_points), next(number_of_points, -1);
    std::vector<double> weights(number_of_points, 0.); // of the links to the next ones
    for(int p = 0; p < number_of_points; ++p)
      first[p] = last[p] = p;
    for(const Edge& link : links) {
      const int a = sets.find(link.source), b = sets.find(link.target);
      const int head = first[a], end = last[b];
      weights[last[a]] = link.weight;
      next[last[a]] = first[b];
      sets.unite(a, b);
      first[sets.find(a)] = head;
      last[sets.find(a)] = end;
    }
    int position = 0;
    for(int p = first[sets.find(0)]; p >= 0; p = next[p]) {
      m_positions[p] = position++;
      m_longest[0].push_back(weights[p]);
    }
    for(std::size_t size = 2; size <= m_longest[0].size(); size *= 2) {
      const std::vector<double>& halves = m_longest.back();
      std::vector<double> longest(halves.size() - size / 2);
      for(std::size_t j = 0; j < longest.size(); ++j)
        longest[j] = (std::max)(halves[j], halves[j + size / 2]);
      m_longest.push_back(std::move(longest));
    }
  }

  int position(int point) const { return m_positions[point]; }

  // between different positions, the lower one first
  double between(int i, int j) const
  {
    int level = 0;
    while((2 << level) <= j - i)
      ++level;
    return (std::max)(m_longest[level][i], m_longest[level][j - (1 << level)]);
  }
};

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_BOTTLENECKS_H
