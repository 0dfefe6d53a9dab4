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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_TERMINAL_SET_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_TERMINAL_SET_H

#include <array>
#include <cstddef>
#include <cstdint>

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

} // namespace Steiner_tree
} // namespace internal
} // namespace CGAL

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_TERMINAL_SET_H
