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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_COMPLETION_BOUND_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_COMPLETION_BOUND_H

#include <CGAL/boost/graph/internal/Steiner_tree/Dual_ascent.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace internal {
namespace Steiner_tree {

// A set of terminals, given by their positions 0..64*Words-1.
template <int Words>
class Terminal_set
{
  std::array<std::uint64_t, Words> m_words{};

public:
  static constexpr int capacity = 64 * Words;

  static Terminal_set all(int size)
  {
    Terminal_set result;
    for(int i = 0; i < size; ++i)
      result.insert(i);
    return result;
  }

  void insert(int i) { m_words[i / 64] |= std::uint64_t(1) << (i % 64); }
  bool contains(int i) const { return (m_words[i / 64] >> (i % 64)) & 1; }

  bool intersects(const Terminal_set& other) const
  {
    std::uint64_t common = 0;
    for(int w = 0; w < Words; ++w)
      common |= m_words[w] & other.m_words[w];
    return common != 0;
  }

  Terminal_set united(const Terminal_set& other) const
  {
    Terminal_set result;
    for(int w = 0; w < Words; ++w)
      result.m_words[w] = m_words[w] | other.m_words[w];
    return result;
  }

  Terminal_set without(const Terminal_set& other) const
  {
    Terminal_set result;
    for(int w = 0; w < Words; ++w)
      result.m_words[w] = m_words[w] & ~other.m_words[w];
    return result;
  }

  int size() const
  {
    int result = 0;
    for(std::uint64_t word : m_words)
      for(; word != 0; word &= word - 1)
        ++result;
    return result;
  }

  friend bool operator==(const Terminal_set& a, const Terminal_set& b) { return a.m_words == b.m_words; }
  friend bool operator<(const Terminal_set& a, const Terminal_set& b) { return a.m_words < b.m_words; }

  struct Hash
  {
    std::size_t operator()(const Terminal_set& set) const
    {
      std::uint64_t h = 0;
      for(std::uint64_t word : set.m_words)
        h = (h ^ word) * 0x9E3779B97F4A7C15ull + (h >> 29);
      return std::size_t(h ^ (h >> 32));
    }
  };
};

// Lower bounds for what a subtree at a vertex v that connects the terminals of a set I still needs: a tree that
// connects v and the other terminals R (the future costs of Hougardy, Silvanus and Vygen 2017), from a dual solution.
// Let r be its root.
//  - If r is in R, the rest is a tree directed away from r that enters all sets of the dual solution that hold v or a
//    terminal of R, and its path to v costs at least the distance by reduced weights on top.
//  - If r is in I, the rest is directed away from v and enters all sets that hold a terminal of R but not v.
template <int Words>
class Completion_bound
{
  using Set = Terminal_set<Words>;

  const Dual_ascent* m_dual;
  std::vector<Set> m_groups;

public:
  explicit Completion_bound(const Dual_ascent& dual) : m_dual(&dual)
  {
    for(const Dual_ascent::Group& group : dual.groups()) {
      m_groups.emplace_back();
      for(int t : group.terminals)
        m_groups.back().insert(t);
    }
  }

  // the value of all sets that hold a terminal of R
  double base(const Set& rest) const
  {
    double sum = 0.;
    for(std::size_t g = 0; g < m_groups.size(); ++g)
      if(m_groups[g].intersects(rest))
        sum += m_dual->groups()[g].value;
    return sum;
  }

  double operator()(int v, const Set& rest, double base_of_rest) const
  {
    const bool holds_root = rest.contains(m_dual->root());
    double sum = base_of_rest + (holds_root ? m_dual->distance_from_root(v) : m_dual->distance_to_terminal(v));
    for(const Dual_ascent::Share& share : m_dual->shares(v))
      if(m_groups[share.group].intersects(rest) != holds_root)
        sum += holds_root ? share.value : -share.value;
    return sum;
  }
};

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_COMPLETION_BOUND_H
