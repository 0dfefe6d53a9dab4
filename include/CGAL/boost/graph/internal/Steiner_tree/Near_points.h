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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_NEAR_POINTS_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_NEAR_POINTS_H

#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Tree.h>
#include <CGAL/boost/graph/internal/Steiner_tree/metric_closure.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::internal::Steiner_tree {

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

// Terminals and auxiliary points with the minimum spanning tree of their metric closure, as `Key_points`, for so many
// of them that distances from each to all vertices would take too long. The value of a point depends on points no
// farther away than their longest links: each knows the vertices up to there. The spanning tree comes from the borders
// of the Voronoi regions (Mehlhorn 1988). O(n log n) for each round, in which many auxiliary points come, move and go.
class Near_points
{
  struct Near_vertex
  {
    int vertex;
    double distance;
  };

  // what a point knows around it
  struct Ball
  {
    double radius = -1.;
    std::vector<Near_vertex> vertices;
  };

  struct Near_point
  {
    int position; // in the row of the bottlenecks
    int point;
    double distance;
  };

  struct Insertion
  {
    double gain;
    int vertex;
  };

  const Csr_graph* m_graph;
  int m_number_of_terminals;
  std::vector<int> m_points; // the terminals first
  std::vector<Ball> m_balls;
  std::vector<Edge> m_links; // between points, in the order of their weights
  double m_length = 0.;
  Shortest_paths m_paths;
  Buckets<std::pair<int, double>> m_near; // the points around each vertex, with distances

public:
  Near_points(const Csr_graph& graph, const std::vector<int>& terminals, const std::vector<int>& auxiliary_points)
    : m_graph(&graph), m_number_of_terminals(int(terminals.size())), m_points(terminals), m_paths(graph)
  {
    m_points.insert(m_points.end(), auxiliary_points.begin(), auxiliary_points.end());
    m_balls.resize(m_points.size());
    span();
  }

  double length() const { return m_length; }
  std::vector<int> auxiliary_points() const { return {m_points.begin() + m_number_of_terminals, m_points.end()}; }

  Tree tree() const
  {
    const std::vector<int> terminals(m_points.begin(), m_points.begin() + m_number_of_terminals);
    const Tree tree = make_tree(*m_graph, terminals, metric_closure_tree(*m_graph, m_points).edges);
    return make_tree_on_same_vertices(*m_graph, terminals, tree);
  }

  // adds, moves, and removes auxiliary points until no single one of these steps pays
  void improve(double minimum_decrease, const Go_further& go_further)
  {
    while(go_further() && (insert(minimum_decrease) || relocate(minimum_decrease)))
      continue;
  }

private:
  void span()
  {
    for(;;) {
      const Region_graph regions(*m_graph, m_points);
      m_links.clear();
      for(int e : minimum_spanning_forest(regions.graph()))
        m_links.push_back(regions.graph().edges[e]);
      if(!remove_idle_points())
        break;
    }
    sort_by_key(m_links, [](const Edge& link) { return link.weight; });
    m_length = 0.;
    for(const Edge& link : m_links)
      m_length += link.weight;
  }

  // auxiliary points with at most two links: they gain nothing
  bool remove_idle_points()
  {
    std::vector<int> degrees(m_points.size(), 0);
    for(const Edge& link : m_links) {
      ++degrees[link.source];
      ++degrees[link.target];
    }
    std::size_t size = std::size_t(m_number_of_terminals);
    for(std::size_t p = size; p < m_points.size(); ++p)
      if(degrees[p] > 2) {
        m_points[size] = m_points[p];
        std::swap(m_balls[size], m_balls[p]);
        ++size;
      }
    const bool is_any = size < m_points.size();
    m_points.resize(size);
    m_balls.resize(size);
    return is_any;
  }

  // each point's ball reaches as far as its longest link
  void grow_balls()
  {
    std::vector<double> radii(m_points.size(), 0.);
    for(const Edge& link : m_links)
      for(int p : {link.source, link.target})
        radii[p] = (std::max)(radii[p], link.weight);
    for(std::size_t p = 0; p < m_points.size(); ++p)
      if(m_balls[p].radius != radii[p])
        grow_ball(int(p), radii[p]);
    m_near = Buckets<std::pair<int, double>>(m_graph->number_of_vertices(), [&](const auto& visit) {
      for(std::size_t p = 0; p < m_points.size(); ++p)
        for(const Near_vertex& near : m_balls[p].vertices)
          visit(near.vertex, {int(p), near.distance});
    });
  }

  void grow_ball(int p, double radius)
  {
    Ball& ball = m_balls[p];
    ball.radius = radius;
    ball.vertices.clear();
    m_paths.clear();
    m_paths.add_source(m_points[p]);
    m_paths.run([&](int v) {
      if(m_paths.distance(v) > radius)
        return false;
      ball.vertices.push_back({v, m_paths.distance(v)});
      return true;
    });
  }

  std::vector<Near_point> points_around(int v, const Bottlenecks& bottlenecks) const
  {
    std::vector<Near_point> result;
    for(const auto& near : m_near[v])
      result.push_back({bottlenecks.position(near.first), near.first, near.second});
    std::sort(result.begin(), result.end(),
              [](const Near_point& a, const Near_point& b) { return a.position < b.position; });
    return result;
  }

  // How much shorter the spanning tree gets with a point that has these points around it. Their longest links on the
  // way from one to the next, and links to the new point, are a fan; along the row, the longest link of each cycle goes
  // (Chin and Houck 1978).
  static double gain(const std::vector<Near_point>& near, const Bottlenecks& bottlenecks)
  {
    double result = -near.front().distance, longest = near.front().distance; // on the way to the new point
    for(std::size_t i = 1; i < near.size(); ++i) {
      const double link = bottlenecks.between(near[i - 1].position, near[i].position);
      const double spoke = near[i].distance;
      const double removed = (std::max)(link, (std::max)(spoke, longest));
      result += removed - spoke;
      longest = removed == spoke ? (std::max)(link, longest) : spoke;
    }
    return result;
  }

  std::vector<Insertion> insertions(const Bottlenecks& bottlenecks, double minimum_decrease) const
  {
    std::vector<Insertion> result;
    for(int v = 0; v < m_graph->number_of_vertices(); ++v)
      if(m_near.size(v) > 2) {
        const Insertion insertion{gain(points_around(v, bottlenecks), bottlenecks), v};
        if(insertion.gain > minimum_decrease)
          result.push_back(insertion);
      }
    sort_by_key(result, [](const Insertion& insertion) { return -insertion.gain; });
    return result;
  }

  // Inserts the best points, but those only that have no point around them in common: what they gain adds up, mostly.
  bool insert(double minimum_decrease)
  {
    grow_balls();
    const Bottlenecks bottlenecks(int(m_points.size()), m_links);
    std::vector<char> is_taken(m_points.size(), 0);
    std::vector<int> vertices;
    for(const Insertion& insertion : insertions(bottlenecks, minimum_decrease)) {
      const auto around = std::as_const(m_near)[insertion.vertex];
      if(std::any_of(around.begin(), around.end(), [&](const auto& near) { return is_taken[near.first]; }))
        continue;
      for(const auto& near : around)
        is_taken[near.first] = 1;
      vertices.push_back(insertion.vertex);
    }
    return !vertices.empty() && change(minimum_decrease, [&](std::size_t size) {
      size = (std::min)(size, vertices.size());
      m_points.insert(m_points.end(), vertices.begin(), vertices.begin() + size);
      m_balls.resize(m_points.size());
      return size;
    });
  }

  // Moves auxiliary points to where their links are shortest together, but no two neighbors.
  bool relocate(double minimum_decrease)
  {
    std::vector<std::vector<int>> neighbors(m_points.size());
    std::vector<double> lengths(m_points.size(), 0.);
    for(const Edge& link : m_links) {
      neighbors[link.source].push_back(link.target);
      neighbors[link.target].push_back(link.source);
      lengths[link.source] += link.weight;
      lengths[link.target] += link.weight;
    }
    std::vector<std::pair<int, int>> moves; // of a point to a vertex
    std::vector<char> is_taken(m_points.size(), 0);
    for(int p = m_number_of_terminals; p < int(m_points.size()); ++p) {
      const bool is_free = std::none_of(neighbors[p].begin(), neighbors[p].end(), [&](int q) { return is_taken[q]; });
      const std::pair<double, int> best = is_free ? meeting_vertex(neighbors[p]) : std::make_pair(lengths[p], -1);
      if(best.first < lengths[p] - minimum_decrease) {
        is_taken[p] = 1;
        moves.emplace_back(p, best.second);
      }
    }
    return !moves.empty() && change(minimum_decrease, [&](std::size_t size) {
      size = (std::min)(size, moves.size());
      for(std::size_t i = 0; i < size; ++i) {
        m_points[moves[i].first] = moves[i].second;
        m_balls[moves[i].first] = Ball();
      }
      return size;
    });
  }

  // The vertex with the least sum of distances to the points, of those that all of them know, and the sum.
  std::pair<double, int> meeting_vertex(const std::vector<int>& points) const
  {
    std::pair<double, int> best(Shortest_paths::infinity(), -1);
    for(const Near_vertex& candidate : m_balls[points.front()].vertices) {
      double sum = 0.;
      std::size_t number = 0;
      for(const auto& near : m_near[candidate.vertex])
        if(std::find(points.begin(), points.end(), near.first) != points.end()) {
          sum += near.second;
          ++number;
        }
      if(number == points.size())
        best = (std::min)(best, std::make_pair(sum, candidate.vertex));
    }
    return best;
  }

  // Makes changes, or, where they disturb each other, a quarter of them. `apply(size)` makes up to `size` of them and
  // returns how many.
  template <typename Apply>
  bool change(double minimum_decrease, const Apply& apply)
  {
    const auto former = std::make_tuple(m_points, m_balls, m_links, m_length);
    for(std::size_t size = std::size_t(m_graph->number_of_vertices()); size > 0; size /= 4) {
      size = apply(size);
      span();
      if(m_length < std::get<double>(former) - minimum_decrease)
        return true;
      std::tie(m_points, m_balls, m_links, m_length) = former;
    }
    return false;
  }
};

} // namespace CGAL::internal::Steiner_tree

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_NEAR_POINTS_H
