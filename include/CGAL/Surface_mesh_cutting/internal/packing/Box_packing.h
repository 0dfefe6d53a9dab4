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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_BOX_PACKING_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_BOX_PACKING_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/packing/Packing_random.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Where a box lies: its lower left corner, whether it was turned by a quarter, and on which page.
struct Box_place
{
  Eigen::Vector2d corner;
  bool is_turned;
  int page;
};

// Places boxes in squares, without a grid: always the widest one that fits into the lowest gap of the skyline of those
// before it (Burke, Kendall and Whitwell: a new placement heuristic for the orthogonal stock-cutting problem, 2004).
class Box_packing
{
public:
  Box_packing(const std::vector<Eigen::Vector2d>& sizes, double side, bool may_turn)
    : m_sizes(sizes), m_side(side), m_may_turn(may_turn)
  {}

  // On page after page; none if a box is left. With `noise`, up to 1, widths are misjudged by such a share.
  std::optional<std::vector<Box_place> > pack(int most_pages, double noise, Packing_random& random)
  {
    std::vector<Box_place> places(m_sizes.size());
    for(int i = 0; i < int(m_sizes.size()); ++i)
      for(const bool is_turned : {false, true})
        if(!is_turned || m_may_turn)
          m_left.insert({width(i, is_turned), 2 * i + is_turned});
    for(int page = 0; page < most_pages && !m_left.empty(); ++page)
    {
      const std::size_t number = m_left.size();
      m_skyline.assign(1, {0, 0});
      for(std::size_t gap = 0; gap < m_skyline.size(); gap = lowest_gap())
        if(const std::optional<int> side = best_side(gap, noise, random))
          places[*side / 2] = {place(*side, gap), *side % 2 == 1, page};
        else if(!fill(gap))
          break;
      if(m_left.size() == number) // each is larger than a page
        break;
    }
    return m_left.empty() ? std::make_optional(places) : std::nullopt;
  }

private:
  // A level piece of the skyline, up to the beginning of the next one.
  struct Piece { double begin, height; };

  // Boxes by their widths: twice the number of a box, and one more for a turned one.
  using Sides = std::set<std::pair<double, int> >;

  double width(int i, bool is_turned) const { return m_sizes[i][is_turned ? 1 : 0]; }
  double height(int i, bool is_turned) const { return width(i, !is_turned); }
  double end_of(std::size_t piece) const { return piece + 1 < m_skyline.size() ? m_skyline[piece + 1].begin : m_side; }

  // The heights of the pieces at the sides of a gap.
  double height_before(std::size_t gap) const
  { return gap > 0 ? m_skyline[gap - 1].height : std::numeric_limits<double>::infinity(); }
  double height_behind(std::size_t gap) const
  { return gap + 1 < m_skyline.size() ? m_skyline[gap + 1].height : std::numeric_limits<double>::infinity(); }

  // None, past the end, once all boxes are placed.
  std::size_t lowest_gap() const
  {
    if(m_left.empty())
      return m_skyline.size();
    const auto lowest = std::min_element(m_skyline.begin(), m_skyline.end(),
                                         [](const Piece& a, const Piece& b) { return a.height < b.height; });
    return std::size_t(lowest - m_skyline.begin());
  }

  std::optional<int> best_side(std::size_t gap, double noise, Packing_random& random) const
  {
    constexpr int most_looks = 8;
    const double room = end_of(gap) - m_skyline[gap].begin;
    std::optional<int> best;
    double most = 0;
    int looks = 0;
    for(auto side = m_left.upper_bound({room, std::numeric_limits<int>::max()}); side != m_left.begin() && looks < most_looks;)
    {
      --side;
      if(m_skyline[gap].height + height(side->second / 2, side->second % 2 == 1) > m_side)
        continue;
      const double rating = noise > 0 ? side->first * (1 - noise * random.share()) : side->first;
      if(!best || rating > most)
      {
        best = side->second;
        most = rating;
      }
      looks = noise > 0 ? looks + 1 : most_looks;
    }
    return best;
  }

  // At the higher side of the gap.
  Eigen::Vector2d place(int side, std::size_t gap)
  {
    const int i = side / 2;
    const bool is_turned = side % 2 == 1;
    for(const bool other : {false, true})
      m_left.erase({width(i, other), 2 * i + other});
    const Piece below = m_skyline[gap];
    const double end = end_of(gap), top = below.height + height(i, is_turned);
    const bool is_at_end = gap > 0 && height_behind(gap) > height_before(gap);
    const double begin = is_at_end ? end - width(i, is_turned) : below.begin;
    const auto at = m_skyline.begin() + std::ptrdiff_t(gap);
    if(is_at_end)
      m_skyline.insert(at + 1, {begin, top});
    else
    {
      at->height = top;
      if(begin + width(i, is_turned) < end)
        m_skyline.insert(at + 1, {begin + width(i, is_turned), below.height});
    }
    return {begin, below.height};
  }

  // Up to the lower one of its sides, which it then joins; false if it has none.
  bool fill(std::size_t gap)
  {
    if(m_skyline.size() == 1)
      return false;
    const auto at = m_skyline.begin() + std::ptrdiff_t(gap);
    if(height_before(gap) > height_behind(gap))
    {
      at->height = (at + 1)->height;
      m_skyline.erase(at + 1);
    }
    else
      m_skyline.erase(at);
    return true;
  }

  const std::vector<Eigen::Vector2d>& m_sizes;
  const double m_side;
  const bool m_may_turn;
  Sides m_left;
  std::vector<Piece> m_skyline;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_PACKING_BOX_PACKING_H
