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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_LOCAL_SEARCH_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_LOCAL_SEARCH_H

#include <CGAL/boost/graph/internal/Steiner_tree/Tree.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::internal::Steiner_tree {

// Terminals and auxiliary points with the minimum spanning tree of their metric closure, which can grow and shrink
// by a point. Keeps one search per point: O(k n) memory. Boost's spanning trees of a metric closure, which is a complete
// graph, would need its edges; Prim's algorithm on the searches needs none, and its order of the links serves
// to update the tree.
class Key_points
{
public:
  // the distances from a point and the last edges of the paths to all vertices
  struct Search
  {
    int source;
    std::vector<double> distances;
    std::vector<int> last_edges;

    Search(const Csr_graph& graph, int v) : source(v)
    {
      Shortest_paths paths(graph);
      paths.add_source(v);
      paths.run();
      distances = paths.distances();
      last_edges = paths.last_edges();
    }
  };

  struct Insertion
  {
    int vertex;
    double length;
  };

private:
  static constexpr int block_size = 64; // vertices: half a kilobyte per point, which caches hold
  static constexpr int number_of_searches_at_once = 16; // work for threads between two questions whether to go on

  const Csr_graph* m_graph;
  std::vector<int> m_terminals;
  Execution m_execution;
  std::vector<std::shared_ptr<const Search>> m_searches; // those of the terminals first
  // spanning tree: positions in `m_searches` in the order of Prim's algorithm, with the position of the parent
  struct Link
  {
    int child;
    int parent;
    double weight;
  };
  std::vector<Link> m_links;
  double m_length = 0.;

public:
  Key_points(const Csr_graph& graph, const std::vector<int>& terminals, Execution execution,
             const Go_further& go_further)
    : m_graph(&graph), m_terminals(terminals), m_execution(execution)
  {
    const int k = int(terminals.size());
    for(int first = 0; first < k && go_further(); first = int(m_searches.size())) {
      m_searches.resize((std::min)(k, first + number_of_searches_at_once));
      execute(m_execution, int(m_searches.size()) - first, [&](int i) {
        m_searches[first + i] = std::make_shared<const Search>(graph, terminals[first + i]);
      });
    }
    if(is_complete())
      span();
  }

  // false if the searches were stopped: of no use then
  bool is_complete() const { return m_searches.size() >= m_terminals.size(); }

  // the paper's L: the weight of the spanning tree of the metric closure
  double length() const { return m_length; }
  int number_of_auxiliary_points() const { return int(m_searches.size() - m_terminals.size()); }
  int auxiliary_point(int i) const { return m_searches[m_terminals.size() + i]->source; }

  void insert(int v)
  {
    m_searches.push_back(std::make_shared<const Search>(*m_graph, v));
    span();
  }

  void erase_auxiliary_point(int i)
  {
    m_searches.erase(m_searches.begin() + m_terminals.size() + i);
    span();
  }

  // the point whose addition makes the spanning tree shortest (lowest index among equals). The new tree consists
  // of old links and links to the new point v (Chin and Houck 1978); going up the old tree, the longest link of
  // each cycle through v is dropped: O(k) per vertex, here for blocks of vertices at once.
  Insertion best_insertion() const
  {
    const int n = m_graph->number_of_vertices();
    const int number_of_blocks = (n + block_size - 1) / block_size;
    std::vector<Insertion> best(number_of_blocks);
    execute(m_execution, number_of_blocks, [&](int block) {
      best[block] = best_insertion_in_block(block * block_size, (std::min)(n, (block + 1) * block_size));
    });
    return *std::min_element(best.begin(), best.end(), [](const Insertion& a, const Insertion& b) {
      return a.length < b.length; // the first of equals
    });
  }

  // the tree that the links' shortest paths leave when cycles and dangling auxiliary points are gone
  Tree tree() const
  {
    std::vector<int> edges;
    for(const Link& link : m_links) {
      const Search& search = *m_searches[link.parent];
      for(int v = m_searches[link.child]->source; v != search.source;) {
        const int e = search.last_edges[v];
        edges.push_back(e);
        v = m_graph->opposite(e, v);
      }
    }
    return make_tree(*m_graph, m_terminals, edges);
  }

private:
  // Prim's algorithm; ties by position
  void span()
  {
    const int k = int(m_searches.size());
    m_links.clear();
    m_length = 0.;
    std::vector<Link> candidates;
    for(int i = 1; i < k; ++i)
      candidates.push_back(Link{i, 0, m_searches[0]->distances[m_searches[i]->source]});
    while(!candidates.empty()) {
      const auto next = std::min_element(candidates.begin(), candidates.end(), [](const Link& a, const Link& b) {
        return a.weight < b.weight;
      });
      const Link link = *next;
      candidates.erase(next);
      m_links.push_back(link);
      m_length += link.weight;
      const std::vector<double>& distances = m_searches[link.child]->distances;
      for(Link& c : candidates) {
        const double distance = distances[m_searches[c.child]->source];
        if(distance < c.weight)
          c = Link{c.child, link.child, distance};
      }
    }
  }

  Insertion best_insertion_in_block(int first, int last) const
  {
    // nearest[i]: the shortest connection of v to the part of the tree below point i that has been seen
    std::vector<std::array<double, block_size>> nearest(m_searches.size());
    for(std::size_t i = 0; i < m_searches.size(); ++i)
      std::copy(m_searches[i]->distances.begin() + first, m_searches[i]->distances.begin() + last, nearest[i].begin());
    std::array<double, block_size> length{};
    const int size = last - first;
    for(auto link = m_links.rbegin(); link != m_links.rend(); ++link) {
      const std::array<double, block_size>& below = nearest[link->child];
      std::array<double, block_size>& above = nearest[link->parent];
      const double weight = link->weight;
      for(int j = 0; j < size; ++j) {
        length[j] += (std::min)(below[j], weight);
        above[j] = (std::min)(above[j], (std::max)(below[j], weight));
      }
    }
    Insertion best{first, length[0] + nearest[0][0]};
    for(int j = 1; j < size; ++j)
      if(length[j] + nearest[0][j] < best.length)
        best = Insertion{first + j, length[j] + nearest[0][j]};
    return best;
  }
};

// adds the auxiliary point that shortens the metric closure's spanning tree most as long as that is by more than
// `minimum_decrease` (paper, Section 3.2). The union of the paths counts in the end; they may share
// edges: the shortest union over all steps is returned.
inline Tree insert_auxiliary_points(Key_points& points, double minimum_decrease, const Go_further& go_further)
{
  Tree best = points.tree();
  while(go_further()) {
    const Key_points::Insertion insertion = points.best_insertion();
    // no gain below rounding errors, or it would go on for ever
    if(!(points.length() - insertion.length > (std::max)(minimum_decrease, 1e-12 * points.length())))
      break;
    points.insert(insertion.vertex);
    Tree tree = points.tree();
    if(tree.length < best.length)
      best = tree;
  }
  return best;
}

// Local search over the auxiliary points (key vertices) after the greedy insertion: eliminates a point and inserts
// the best others again (which includes exchanges) as long as the tree, measured by the union of its paths, gets
// shorter. `minimum_decrease` keeps rounding errors from looking like progress.
inline Tree local_search(Key_points points, double minimum_decrease, const Go_further& go_further)
{
  Tree best = insert_auxiliary_points(points, minimum_decrease, go_further);
  for(int i = 0; i < points.number_of_auxiliary_points() && go_further(); ++i) {
    Key_points candidate = points;
    candidate.erase_auxiliary_point(i);
    const Tree tree = insert_auxiliary_points(candidate, minimum_decrease, go_further);
    const bool is_shorter = tree.length < best.length - minimum_decrease;
    if(is_shorter || candidate.length() < points.length() - minimum_decrease) {
      if(is_shorter)
        best = tree;
      points = candidate;
      i = -1;
    }
  }
  return best;
}

// the graph with weights up to a fifth larger, at random: another way into the local search, and out of ties
inline Csr_graph perturbed(const Csr_graph& graph, unsigned int seed)
{
  std::mt19937 generator(seed);
  std::vector<Edge> edges(graph.edges);
  for(Edge& e : edges)
    e.weight *= 1. + 0.2 * double(generator()) / 4294967296.;
  return Csr_graph(graph.number_of_vertices(), std::move(edges));
}

} // namespace CGAL::internal::Steiner_tree

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_LOCAL_SEARCH_H
