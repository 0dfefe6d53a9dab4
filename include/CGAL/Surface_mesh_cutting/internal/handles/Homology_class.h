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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_HOMOLOGY_CLASS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_HOMOLOGY_CLASS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// A class of cycles of a surface over Z_2, or what a path contributes to one: which of the coordinates
// that a `Tree_cotree` chose are 1.
class Homology_class
{
public:
  using Word = std::uint64_t;
  static constexpr int number_of_words = 4, number_of_coordinates = 64 * number_of_words;

  bool operator[](int i) const { return (m_words[i / 64] >> (i % 64)) & 1; }
  void flip(int i) { m_words[i / 64] ^= Word(1) << (i % 64); }
  Word& word(int i) { return m_words[i]; }

  Homology_class& operator^=(const Homology_class& other)
  {
    for(int w = 0; w < number_of_words; ++w)
      m_words[w] ^= other.m_words[w];
    return *this;
  }
  friend Homology_class operator^(Homology_class a, const Homology_class& b) { return a ^= b; }

  bool is_zero() const { return m_words == std::array<Word, number_of_words>{}; }

  // The first coordinate that is 1; there must be one.
  int first() const
  {
    int i = 0;
    while(!(*this)[i])
      ++i;
    return i;
  }

private:
  std::array<Word, number_of_words> m_words{};
};

// The classes that sums of the given ones make up.
class Homology_span
{
public:
  int dimension() const { return int(m_basis.size()); }

  bool contains(const Homology_class& c) const { return c.is_zero() || remainder(c).is_zero(); }

  // `c` must not be one of them yet.
  void add(const Homology_class& c)
  {
    const Homology_class rest = remainder(c);
    m_basis.emplace_back(rest.first(), rest);
  }

private:
  // The first coordinate of an element of the basis is 0 in those after it.
  Homology_class remainder(Homology_class c) const
  {
    for(const auto& [first, element] : m_basis)
      if(c[first])
        c ^= element;
    return c;
  }

  std::vector<std::pair<int, Homology_class> > m_basis;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_HANDLES_HOMOLOGY_CLASS_H
