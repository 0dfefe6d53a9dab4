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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_FREE_CELLS_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_FREE_CELLS_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/Chart_mask.h>

#include <boost/multiprecision/integer.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

struct Cell { int x, y; };

// The cells of a square grid that are still free, as bits.
//
// Level k of a row has a bit where one of the 2^k cells that start there is taken: whether a run of any length fits is
// then two shifted words away, for 64 places at once.
class Free_cells
{
public:
  // `longest`: the most cells of a run of any chart.
  Free_cells(int size, int longest)
    : m_size(size), m_words((size + 63) / 64), m_longest_gaps(size, size), m_blocked(m_words)
  {
    while((1 << m_levels) <= longest)
      ++m_levels;
    m_bits.assign(std::size_t(m_levels) * size * stride(), 0);
  }

  int size() const { return m_size; }

  void clear()
  {
    std::fill(m_bits.begin(), m_bits.end(), 0);
    std::fill(m_longest_gaps.begin(), m_longest_gaps.end(), m_size);
  }

  // The leftmost place in the lowest row from `begin` on, but before `end`, where the chart touches no taken cell.
  std::optional<Cell> lowest_place(const Chart_mask& mask, int begin, int end)
  {
    end = (std::min)(end, m_size - mask.height + 1);
    if(mask.width > m_size)
      return std::nullopt;
    for(int y = begin; y < end; ++y)
    {
      const int x = leftmost_place(mask, y);
      if(x >= 0)
        return Cell{x, y};
    }
    return std::nullopt;
  }

  // Takes what is too close to the chart.
  void take(const Chart_mask& mask, const Cell& place)
  {
    int last_row = -1, low = m_size, high = -1; // of the row
    for(const Cell_run& run : mask.outer)
    {
      const int y = run.row + place.y;
      const int first = (std::max)(0, run.first + place.x), last = (std::min)(m_size - 1, run.last + place.x);
      if(y < 0 || y >= m_size || first > last)
        continue;
      if(last_row >= 0 && last_row != y)
      {
        update(last_row, low, high);
        low = m_size;
        high = -1;
      }
      last_row = y;
      low = (std::min)(low, first);
      high = (std::max)(high, last);
      std::uint64_t* const bits = row(0, y);
      for(int word = first / 64; word <= last / 64; ++word)
        bits[word] |= ones(first - 64 * word, last - 64 * word);
    }
    if(last_row >= 0)
      update(last_row, low, high);
  }

private:
  // A word of zeros follows each row.
  int stride() const { return m_words + 1; }
  std::uint64_t* row(int level, int y) { return &m_bits[(std::size_t(level) * m_size + y) * stride()]; }

  // Bits from `first` to `last`, which may lie outside of the word.
  static std::uint64_t ones(int first, int last)
  {
    const std::uint64_t all = ~std::uint64_t(0);
    return (first > 0 ? all << first : all) & (last < 63 ? ~(all << (last + 1)) : all);
  }

  // Where cells from `low` to `high` are newly taken.
  void update(int y, int low, int high)
  {
    for(int level = 1; level < m_levels; ++level)
    {
      const int shift = 1 << (level - 1), words = shift / 64, bits = shift % 64, end = high / 64 + 1;
      const std::uint64_t* const source = row(level - 1, y);
      std::uint64_t* const target = row(level, y);
      for(int i = (std::max)(0, low - 2 * shift + 1) / 64; i < end; ++i)
      {
        const int j = i + words;
        target[i] = source[i] | (j < m_words ? source[j] >> bits | source[j + 1] << 1 << (63 - bits) : 0);
      }
    }
    m_longest_gaps[y] = longest_gap(row(0, y));
  }

  int longest_gap(const std::uint64_t* bits) const
  {
    int gap = 0, longest = 0;
    for(int begin = 0; begin < m_size; begin += 64, ++bits)
    {
      const int length = (std::min)(64, m_size - begin);
      std::uint64_t rest = *bits;
      int place = 0;
      while(rest != 0) // up to the next taken cell, past the next free one
      {
        const int free = int(boost::multiprecision::lsb(rest));
        longest = (std::max)(longest, gap + free);
        rest >>= free;
        place += free;
        gap = 0;
        const std::uint64_t inverse = ~rest;
        const int taken = inverse == 0 ? 64 : int(boost::multiprecision::lsb(inverse));
        rest = taken >= 64 ? 0 : rest >> taken;
        place += taken;
      }
      gap += (std::max)(0, length - place);
      longest = (std::max)(longest, gap);
    }
    return longest;
  }

  // Adds the row moved to the left; whether a zero is left.
  bool add_shifted(const std::uint64_t* source, int shift, std::uint64_t* target) const
  {
    const int words = shift / 64, bits = shift % 64;
    source += words;
    const int end = m_words - words;
    std::uint64_t common = ~std::uint64_t(0);
    for(int i = 0; i < end; ++i)
      common &= target[i] |= source[i] >> bits | source[i + 1] << 1 << (63 - bits);
    for(int i = (std::max)(0, end); i < m_words; ++i)
      common &= target[i];
    return common != ~std::uint64_t(0);
  }

  // -1 if there is none in this row.
  int leftmost_place(const Chart_mask& mask, int y)
  {
    for(const Cell_run& run : mask.inner)
      if(run.length() > m_longest_gaps[y + run.row])
        return -1;
    const int last = m_size - mask.width;
    for(int word = 0; word < m_words; ++word)
      m_blocked[word] = ~(64 * word <= last ? ones(0, last - 64 * word) : 0);
    for(const Cell_run& run : mask.inner)
    {
      int level = 0;
      while((2 << level) <= run.length())
        ++level;
      const std::uint64_t* const bits = row(level, y + run.row);
      add_shifted(bits, run.first, m_blocked.data());
      if(!add_shifted(bits, run.last + 1 - (1 << level), m_blocked.data()))
        return -1;
    }
    for(int x = 0; x <= last; ++x)
      if(!(m_blocked[x / 64] >> (x % 64) & 1))
        return x;
    return -1;
  }

  const int m_size, m_words;
  int m_levels = 0;
  std::vector<std::uint64_t> m_bits;
  std::vector<int> m_longest_gaps;      // of free cells in each row
  std::vector<std::uint64_t> m_blocked; // places in the row that is looked at
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_FREE_CELLS_H
