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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_ORIENTED_PIECES_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_ORIENTED_PIECES_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Pieces of a surface, each of which may be turned over as a whole: disjoint sets that know which of their members are
// turned relative to each other.
class Oriented_pieces
{
public:
  explicit Oriented_pieces(int number)
    : m_parents(number), m_sizes(number, 1), m_is_turned(number, 0)
  {
    std::iota(m_parents.begin(), m_parents.end(), 0);
  }

  // The piece that stands for all that this one is connected with, and whether the two are turned relative to each
  // other.
  std::pair<int, bool> find(int piece)
  {
    int root = piece;
    bool is_turned = false;
    for(; m_parents[root] != root; root = m_parents[root])
      is_turned = is_turned != bool(m_is_turned[root]);
    bool rest = is_turned;
    while(m_parents[piece] != piece)
    {
      const bool former = m_is_turned[piece];
      m_is_turned[piece] = rest;
      rest = rest != former;
      piece = std::exchange(m_parents[piece], root);
    }
    return {root, is_turned};
  }

  // Whether the two can be connected so that one is turned relative to the other, or not.
  bool can_connect(int piece, int other, bool is_turned)
  {
    const auto a = find(piece), b = find(other);
    return a.first != b.first || (a.second != b.second) == is_turned;
  }

  void connect(int piece, int other, bool is_turned)
  {
    auto a = find(piece), b = find(other);
    if(a.first == b.first)
      return;
    if(m_sizes[a.first] < m_sizes[b.first])
      std::swap(a, b);
    m_parents[b.first] = a.first;
    m_sizes[a.first] += m_sizes[b.first];
    m_is_turned[b.first] = (a.second != b.second) != is_turned;
  }

private:
  std::vector<int> m_parents, m_sizes;
  std::vector<char> m_is_turned; // relative to the parent
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_ORIENTED_PIECES_H
