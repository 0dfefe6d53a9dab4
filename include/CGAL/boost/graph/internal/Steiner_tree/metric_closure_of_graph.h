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

#ifndef CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_METRIC_CLOSURE_OF_GRAPH_H
#define CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_METRIC_CLOSURE_OF_GRAPH_H

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/internal/Steiner_tree/Tree.h>
#include <CGAL/boost/graph/internal/Steiner_tree/metric_closure.h>
#include <CGAL/boost/graph/internal/Steiner_tree/solve.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::internal::Steiner_tree {

// Can Boost search the graph in both directions of each edge?
template <typename Graph>
constexpr bool is_searched_by_boost()
{
  typedef boost::graph_traits<Graph> Traits;
  return std::is_convertible<typename Traits::traversal_category, boost::incidence_graph_tag>::value &&
         std::is_convertible<typename Traits::directed_category, boost::undirected_tag>::value;
}

// the distance at the end of an edge. Its index is larger than any, so that only a shorter path replaces another one.
struct Distance_along_edge
{
  template <typename Weight>
  Graph_kernel::Indexed_distance operator()(const Graph_kernel::Indexed_distance& distance, const Weight& weight) const
  {
    return {distance.distance + double(weight), (std::numeric_limits<int>::max)()};
  }
};

// For each vertex its nearest terminal, by Boost's search from all terminals. For an undirected model of Boost's concepts
// `VertexListGraph` and `IncidenceGraph`, and indices 0..n-1. Vertices at the same distance are settled by index.
template <typename Graph, typename WeightMap, typename VertexIndexMap>
class Regions_of_graph
{
  typedef typename boost::graph_traits<Graph>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Graph>::edge_descriptor edge_descriptor;

  struct Visitor : public boost::default_dijkstra_visitor
  {
    Regions_of_graph* regions;

    explicit Visitor(Regions_of_graph* regions) : regions(regions) {}

    void edge_relaxed(const edge_descriptor& e, const Graph& graph)
    {
      const std::size_t v = get(regions->index, target(e, graph));
      regions->terminals[v] = regions->terminals[get(regions->index, source(e, graph))];
      regions->last_edges[v] = e;
    }
  };

public:
  VertexIndexMap index;
  std::vector<double> distances;
  std::vector<int> terminals; // by their positions; -1: none can be reached
  std::vector<edge_descriptor> last_edges; // of the shortest paths

  Regions_of_graph(const Graph& graph, const std::vector<vertex_descriptor>& centers, WeightMap weight,
                   VertexIndexMap index)
    : index(index), distances(num_vertices(graph), (std::numeric_limits<double>::infinity)()),
      terminals(num_vertices(graph), -1), last_edges(num_vertices(graph))
  {
    using Graph_kernel::Indexed_distance;
    for(std::size_t i = 0; i < centers.size(); ++i)
      terminals[get(index, centers[i])] = int(i);
    // faster than Boost's default of two bits for each vertex
    std::vector<boost::default_color_type> colors(distances.size());
    boost::dijkstra_shortest_paths(graph, centers.begin(), centers.end(), boost::dummy_property_map(),
                                   Graph_kernel::Distance_map<VertexIndexMap>(distances, index), weight, index,
                                   std::less<Indexed_distance>(), Distance_along_edge(),
                                   Indexed_distance{(std::numeric_limits<double>::infinity)(), 0},
                                   Indexed_distance{0., 0}, Visitor(this),
                                   boost::make_iterator_property_map(colors.begin(), index));
  }
};

// `metric_closure_tree()` on the caller's graph, by Boost's shortest paths and spanning trees: the positions of the tree's
// edges in the order of the graph's edges.
template <typename Graph, typename WeightMap, typename VertexIndexMap>
std::vector<int> metric_closure_tree(const Graph& graph,
                                     const std::vector<typename boost::graph_traits<Graph>::vertex_descriptor>& terminals,
                                     WeightMap weight, VertexIndexMap index)
{
  typedef typename boost::graph_traits<Graph>::edge_descriptor edge_descriptor;
  const Regions_of_graph<Graph, WeightMap, VertexIndexMap> regions(graph, terminals, weight, index);
  std::vector<Edge> connections;
  std::vector<int> bridges;
  std::vector<std::size_t> ends; // of the bridges
  int position = 0;
  for(const edge_descriptor& e : CGAL::make_range(edges(graph))) {
    const std::size_t v = get(index, source(e, graph)), w = get(index, target(e, graph));
    if(regions.terminals[v] != regions.terminals[w]) {
      connections.push_back(Edge{regions.terminals[v], regions.terminals[w],
                                 regions.distances[v] + double(get(weight, e)) + regions.distances[w]});
      bridges.push_back(position);
      ends.insert(ends.end(), {v, w});
    }
    ++position;
  }
  enum : char { outside, on_path, terminal };
  std::vector<char> is_bridge(std::size_t(position), 0), place(num_vertices(graph), outside);
  for(const auto& t : terminals)
    place[get(index, t)] = terminal;
  for(int connection : minimum_spanning_forest(Csr_graph(int(terminals.size()), std::move(connections)))) {
    is_bridge[bridges[connection]] = 1;
    for(std::size_t v : {ends[2 * connection], ends[2 * connection + 1]})
      for(; place[v] == outside; v = get(index, source(regions.last_edges[v], graph)))
        place[v] = on_path;
  }
  std::vector<int> result;
  position = 0;
  for(const edge_descriptor& e : CGAL::make_range(edges(graph))) {
    bool is_in_tree = is_bridge[position];
    for(const auto v : {get(index, source(e, graph)), get(index, target(e, graph))})
      is_in_tree = is_in_tree || (place[v] == on_path && regions.last_edges[v] == e);
    if(is_in_tree)
      result.push_back(position);
    ++position;
  }
  return result;
}

// `solve()` for the method `metric_closure`, on the caller's graph; the indexed one has its vertices and edges in the same order.
template <typename Graph, typename WeightMap, typename VertexIndexMap>
Solution solve_on_graph(const Graph& graph,
                        const std::vector<typename boost::graph_traits<Graph>::vertex_descriptor>& terminals,
                        WeightMap weight, VertexIndexMap index, const Csr_graph& indexed_graph,
                        const std::vector<int>& indexed_terminals, const Go_further& go_further)
{
  if(const std::optional<Solution> solution = solve_without_search(indexed_graph, indexed_terminals))
    return *solution;
  Solution solution;
  solution.tree.edges = metric_closure_tree(graph, terminals, weight, index);
  solution.tree.length = total_weight(indexed_graph, solution.tree.edges);
  return concluded(std::move(solution), indexed_terminals.size() == 2, go_further);
}

} // namespace CGAL::internal::Steiner_tree

#endif // CGAL_BOOST_GRAPH_INTERNAL_STEINER_TREE_METRIC_CLOSURE_OF_GRAPH_H
