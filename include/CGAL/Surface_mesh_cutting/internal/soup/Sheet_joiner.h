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

#ifndef CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_SHEET_JOINER_H
#define CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_SHEET_JOINER_H

#include <CGAL/license/Surface_mesh_cutting.h>

#include <CGAL/Surface_mesh_cutting/internal/soup/Oriented_pieces.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Polygons.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Side_choice.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/Soup_edges.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/continuing_sides.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/former_duplicates.h>

#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_cutting {
namespace internal {

// Which side of a polygon is across which side, and which polygons are turned over for that: a surface that is
// manifold wherever vertices are split into the fans of their corners.
//
// Edges with two polygons connect these, unless the surface has only one side: then where a breadth-first search from
// the lowest polygon meets itself turned over, the edge stays open. Of an edge with more polygons, as many pairs
// as possible are connected, first those that close a fan at one of its vertices: an edge where two bodies touch is
// closed on both, and along a line of such edges the same sheets stay connected. Then those that agree, and of these the
// flattest. A polygon is never connected with its own reverse, so a sheet with two sides is two sheets; where two bodies have
// such a wall in common, each side of it is connected with one of them.
class Sheet_joiner
{
public:
  Sheet_joiner(const std::vector<Point>& points, const Polygons& polygons, const std::vector<char>& is_used,
               const Soup_edges& edges)
    : m_points(points), m_polygons(polygons), m_edges(edges), m_owners(polygons.owners()),
      m_mates(polygons.vertices.size(), -1), m_is_turned(polygons.ends.size(), 0), m_pieces(0), m_fans(0)
  {
    if(is_oriented_manifold())
    {
      join_sides();
      return;
    }
    m_pieces_of_polygons.assign(polygons.ends.size(), -1);
    m_fans = Disjoint_sets(polygons.number_of_corners());
    join_simple_edges(is_used);
    join_other_edges();
    turn_as_few_as_possible(is_used);
  }

  // Per side of a polygon, the one across, or -1.
  const std::vector<int>& mates() const { return m_mates; }
  // Per polygon.
  const std::vector<char>& is_turned() const { return m_is_turned; }
  // The edges with two polygons that had to stay open.
  const std::vector<int>& non_orientable_edges() const { return m_non_orientable_edges; }

private:
  using Side = Soup_edges::Side;
  using Disjoint_sets = CGAL::internal::Graph_kernel::Disjoint_sets;

  int owner(const Side& side) const { return m_owners[side.corner]; }
  int target(const Side& side) const { return m_polygons.next(owner(side), side.corner); }
  // The corner at the lower or at the higher vertex.
  int corner_at(const Side& side, bool is_low) const { return is_low == side.is_upward ? side.corner : target(side); }

  // Which side of the surface is up, within the piece of a side as it is turned so far.
  bool is_up(const Side& side) const { return side.is_upward != bool(m_is_turned[owner(side)]); }
  // Two sides at an edge.
  bool disagree(const Side& a, const Side& b) const { return is_up(a) == is_up(b); }

  // Whether each edge has one polygon, or two that agree as they are.
  bool is_oriented_manifold() const
  {
    for(int e = 0; e < m_edges.number(); ++e)
      if(m_edges.size(e) > 2 ||
         (m_edges.size(e) == 2 && (m_edges.side(e, 0).is_upward == m_edges.side(e, 1).is_upward || !is_simple(e))))
        return false;
    return true;
  }

  // Whether an edge connects two polygons without a choice.
  bool is_simple(int e) const { return m_edges.size(e) == 2 && !are_reverse(m_edges.side(e, 0), m_edges.side(e, 1)); }

  bool are_reverse(const Side& a, const Side& b) const
  {
    return a.is_upward != b.is_upward &&
           internal::are_reverse(m_polygons, owner(a), a.corner, owner(b), target(b));
  }

  // All there is to do on an oriented manifold.
  void join_sides()
  {
    for(int e = 0; e < m_edges.number(); ++e)
      if(m_edges.size(e) == 2)
        set_mates(m_edges.side(e, 0), m_edges.side(e, 1));
  }

  void set_mates(const Side& a, const Side& b)
  {
    m_mates[a.corner] = b.corner;
    m_mates[b.corner] = a.corner;
  }

  void mate(const Side& a, const Side& b)
  {
    set_mates(a, b);
    for(bool is_low : {true, false})
      m_fans.unite(corner_at(a, is_low), corner_at(b, is_low));
  }

  void join_simple_edges(const std::vector<char>& is_used)
  {
    std::vector<int> edge_of_side(m_mates.size(), -1);
    for(int e = 0; e < m_edges.number(); ++e)
      for(int i = 0; i < 2 && is_simple(e); ++i)
        edge_of_side[m_edges.side(e, i).corner] = e;
    int number_of_pieces = 0;
    for(int seed = 0; seed < m_polygons.number(); ++seed)
      if(is_used[seed] && m_pieces_of_polygons[seed] < 0)
        visit_piece(seed, number_of_pieces++, edge_of_side);
    m_pieces = Oriented_pieces(number_of_pieces);
    for(int e = 0; e < m_edges.number(); ++e)
      if(is_simple(e))
      {
        if(disagree(m_edges.side(e, 0), m_edges.side(e, 1)))
          m_non_orientable_edges.push_back(e);
        else
          mate(m_edges.side(e, 0), m_edges.side(e, 1));
      }
  }

  void visit_piece(int seed, int piece, const std::vector<int>& edge_of_side)
  {
    std::deque<int> queue = {seed};
    m_pieces_of_polygons[seed] = piece;
    while(!queue.empty())
    {
      const int polygon = queue.front();
      queue.pop_front();
      for(int c = m_polygons.begin(polygon); c < m_polygons.end(polygon); ++c)
      {
        const int e = edge_of_side[c];
        if(e < 0)
          continue;
        const Side& a = m_edges.side(e, 0);
        const Side& b = m_edges.side(e, 1);
        const int other = owner(a) == polygon ? owner(b) : owner(a);
        if(m_pieces_of_polygons[other] >= 0)
          continue;
        m_pieces_of_polygons[other] = piece;
        m_is_turned[other] = (a.is_upward == b.is_upward) != bool(m_is_turned[polygon]);
        queue.push_back(other);
      }
    }
  }

  Side_choice choice(int e, int i, int j)
  {
    const Side& a = m_edges.side(e, i);
    const Side& b = m_edges.side(e, j);
    const bool do_disagree = disagree(a, b);
    const int piece = m_pieces_of_polygons[owner(a)], other = m_pieces_of_polygons[owner(b)];
    if(!m_pieces.can_connect(piece, other, do_disagree) || are_reverse(a, b))
      return Side_choice();
    Side_choice result;
    result.fans = 0;
    for(bool is_low : {true, false})
      result.fans += m_fans.find(corner_at(a, is_low)) == m_fans.find(corner_at(b, is_low));
    result.is_same_piece = m_pieces.find(piece).first == m_pieces.find(other).first;
    result.agrees = !do_disagree;
    result.flatness = (a.is_upward == b.is_upward ? -1 : 1) * m_normals[owner(a)].dot(m_normals[owner(b)]);
    result.first = i;
    result.second = j;
    return result;
  }

  std::vector<int> open_sides(int e) const
  {
    std::vector<int> open;
    for(int i = 0; i < m_edges.size(e); ++i)
      if(m_mates[m_edges.side(e, i).corner] < 0)
        open.push_back(i);
    return open;
  }

  Side_choice best_choice(int e, const std::vector<int>& open)
  {
    const auto has_reverse = [&](int i)
    {
      const Side& side = m_edges.side(e, i);
      return std::any_of(open.begin(), open.end(), [&](int j) { return are_reverse(side, m_edges.side(e, j)); });
    };
    Side_choice best;
    for(std::size_t i = 0; i < open.size(); ++i)
      for(std::size_t j = i + 1; j < open.size(); ++j)
      {
        Side_choice next = choice(e, open[i], open[j]);
        next.reverses = has_reverse(open[i]) + has_reverse(open[j]);
        if(best < next)
          best = next;
      }
    return best;
  }

  // Among many sides, only the two open ones of each fan are compared, in the order of what is best.
  bool close_many(int e, const std::vector<int>& open)
  {
    std::vector<Side_choice> choices;
    for(bool is_low : {true, false})
    {
      std::vector<std::pair<int, int> > fans;
      for(int i : open)
        fans.emplace_back(m_fans.find(corner_at(m_edges.side(e, i), is_low)), i);
      std::sort(fans.begin(), fans.end());
      for(std::size_t i = 0; i + 1 < fans.size(); ++i)
        if(fans[i].first == fans[i + 1].first)
          if(const Side_choice next = choice(e, fans[i].second, fans[i + 1].second); next.fans > 0)
            choices.push_back(next);
    }
    std::stable_sort(choices.begin(), choices.end(), [](const Side_choice& a, const Side_choice& b) { return b < a; });
    bool has_changed = false;
    for(const Side_choice& choice : choices)
      has_changed = connect(e, choice.first, choice.second) || has_changed;
    return has_changed;
  }

  // Connects many sides with those that continue them.
  bool continue_many(int e, const std::vector<int>& open)
  {
    const Turn_around_edge turn(m_points[m_edges.high(e)] - m_points[m_edges.low(e)]);
    std::vector<Side_at_angle> sides;
    for(int i : open)
    {
      const Side& side = m_edges.side(e, i);
      sides.push_back({turn.angle(m_normals[owner(side)], side.is_upward), is_up(side), i});
    }
    bool has_changed = false;
    connect_continuing_sides(sides, [&](int i, int j)
    {
      const bool is_connected = connect(e, i, j);
      has_changed = has_changed || is_connected;
      return is_connected;
    });
    return has_changed;
  }

  void join_other_edges()
  {
    std::vector<int> edges;
    for(int e = 0; e < m_edges.number(); ++e)
      if(m_edges.size(e) > 2)
        edges.push_back(e);
    if(edges.empty())
      return;
    m_normals = unit_normals(m_points, m_polygons);
    collect_neighbors(edges);
    m_is_waiting.assign(m_edges.number(), 0);
    for(int e : edges)
      wait(e);
    close_fans();
    for(int e : edges)
      while(join(e, 0))
        close_fans();
  }

  // The edges with more than two polygons at each vertex.
  void collect_neighbors(const std::vector<int>& edges)
  {
    m_neighbor_ends.assign(m_points.size() + 1, 0);
    for(int e : edges)
      for(int v : {m_edges.low(e), m_edges.high(e)})
        ++m_neighbor_ends[v + 1];
    for(std::size_t v = 0; v < m_points.size(); ++v)
      m_neighbor_ends[v + 1] += m_neighbor_ends[v];
    m_neighbors.resize(m_neighbor_ends.back());
    std::vector<int> places(m_neighbor_ends.begin(), m_neighbor_ends.end() - 1);
    for(int e : edges)
      for(int v : {m_edges.low(e), m_edges.high(e)})
        m_neighbors[places[v]++] = e;
  }

  void wait(int e)
  {
    if(!std::exchange(m_is_waiting[e], char(1)))
      m_waiting.push_back(e);
  }

  void close_fans()
  {
    while(!m_waiting.empty())
    {
      const int e = m_waiting.front();
      m_waiting.pop_front();
      m_is_waiting[e] = 0;
      while(join(e, 1)) {}
    }
  }

  // Connects the best two sides of an edge that close at least this number of fans, of many sides all such pairs. False if
  // there are none.
  bool join(int e, int least_number_of_fans)
  {
    constexpr std::size_t many = 8;
    const std::vector<int> open = open_sides(e);
    bool has_changed = false;
    if(open.size() > many)
      has_changed = least_number_of_fans > 0 ? close_many(e, open) : continue_many(e, open);
    else if(const Side_choice best = best_choice(e, open); best.fans >= least_number_of_fans)
      has_changed = connect(e, best.first, best.second);
    if(has_changed)
      wait_for_neighbors(e);
    return has_changed;
  }

  // Connects two sides if both are still open and fit together.
  bool connect(int e, int i, int j)
  {
    const Side& a = m_edges.side(e, i);
    const Side& b = m_edges.side(e, j);
    const int piece = m_pieces_of_polygons[owner(a)], other = m_pieces_of_polygons[owner(b)];
    if(m_mates[a.corner] >= 0 || m_mates[b.corner] >= 0 || !m_pieces.can_connect(piece, other, disagree(a, b)) ||
       are_reverse(a, b))
      return false;
    m_pieces.connect(piece, other, disagree(a, b));
    mate(a, b);
    return true;
  }

  void wait_for_neighbors(int e)
  {
    constexpr int many = 64; // edges at a vertex: then the order in which they are connected matters little
    for(int v : {m_edges.low(e), m_edges.high(e)})
      if(m_neighbor_ends[v + 1] - m_neighbor_ends[v] <= many)
        for(int i = m_neighbor_ends[v]; i < m_neighbor_ends[v + 1]; ++i)
          if(m_neighbors[i] != e)
            wait(m_neighbors[i]);
  }

  // Of what is connected, most polygons stay as they are; if as many would be turned, the lowest one stays.
  void turn_as_few_as_possible(const std::vector<char>& is_used)
  {
    std::vector<int> votes(m_polygons.number(), 0); // per piece, for turning it
    for(int p = 0; p < m_polygons.number(); ++p)
      if(is_used[p])
      {
        const auto [root, is_turned] = m_pieces.find(m_pieces_of_polygons[p]);
        m_is_turned[p] = bool(m_is_turned[p]) != is_turned;
        const int weight = votes[root] == 0 ? 3 : 2; // a tie is broken by the lowest one
        votes[root] += m_is_turned[p] ? weight : -weight;
      }
    for(int p = 0; p < m_polygons.number(); ++p)
      if(is_used[p] && votes[m_pieces.find(m_pieces_of_polygons[p]).first] > 0)
        m_is_turned[p] = !m_is_turned[p];
  }

  const std::vector<Point>& m_points;
  const Polygons& m_polygons;
  const Soup_edges& m_edges;
  const std::vector<int> m_owners;
  std::vector<int> m_mates;
  std::vector<int> m_pieces_of_polygons; // connected by edges with two polygons
  std::vector<char> m_is_turned;
  Oriented_pieces m_pieces;
  Disjoint_sets m_fans; // of corners
  std::vector<int> m_non_orientable_edges;
  std::vector<Point> m_normals; // per polygon
  std::vector<int> m_neighbors, m_neighbor_ends; // in compressed rows
  std::deque<int> m_waiting;
  std::vector<char> m_is_waiting;
};

} // namespace internal
} // namespace Surface_mesh_cutting
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CUTTING_INTERNAL_SOUP_SHEET_JOINER_H
