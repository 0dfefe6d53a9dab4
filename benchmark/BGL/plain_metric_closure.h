#ifndef PLAIN_METRIC_CLOSURE_H
#define PLAIN_METRIC_CLOSURE_H

#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

// The same searches and trees as with Boost.Graph, without it: what it is measured against. Ties are decided in the
// same way, so that the results have to be the same, too.
namespace plain {

using CGAL::internal::Graph_kernel::Csr_graph;
using CGAL::internal::Graph_kernel::Edge;

// a 4-ary heap of items 0..n-1 that holds the keys, too
class Heap
{
  typedef std::pair<double, int> Entry;

  std::vector<Entry> m_entries;
  std::vector<int> m_positions;

public:
  explicit Heap(int size) : m_positions(size, -1) {}

  bool empty() const { return m_entries.empty(); }

  void push_or_decrease(int item, double key)
  {
    int position = m_positions[item];
    if(position < 0) {
      position = int(m_entries.size());
      m_entries.push_back(Entry(key, item));
    }
    for(int parent = (position - 1) / 4; position > 0 && is_less(Entry(key, item), m_entries[parent]);
        parent = (position - 1) / 4) {
      place(position, m_entries[parent]);
      position = parent;
    }
    place(position, Entry(key, item));
  }

  int pop()
  {
    const int result = m_entries.front().second;
    m_positions[result] = -1;
    const Entry last = m_entries.back();
    m_entries.pop_back();
    if(!m_entries.empty())
      move_down(last);
    return result;
  }

private:
  static bool is_less(const Entry& a, const Entry& b)
  {
    return a.first < b.first || (a.first == b.first && a.second < b.second);
  }

  void place(int position, const Entry& entry)
  {
    m_entries[position] = entry;
    m_positions[entry.second] = position;
  }

  void move_down(const Entry& entry)
  {
    const int size = int(m_entries.size());
    int position = 0;
    for(;;) {
      const int first = 4 * position + 1;
      if(first >= size)
        break;
      int best = first;
      for(int child = first + 1; child < size && child < first + 4; ++child)
        if(is_less(m_entries[child], m_entries[best]))
          best = child;
      if(!is_less(m_entries[best], entry))
        break;
      place(position, m_entries[best]);
      position = best;
    }
    place(position, entry);
  }
};

// Dijkstra's algorithm from several sources
struct Shortest_paths
{
  std::vector<double> distances;
  std::vector<int> last_edges, centers;

  Shortest_paths(const Csr_graph& graph, const std::vector<int>& sources)
    : distances(graph.number_of_vertices(), (std::numeric_limits<double>::infinity)())
    , last_edges(graph.number_of_vertices(), -1)
    , centers(graph.number_of_vertices(), -1)
  {
    Heap heap(graph.number_of_vertices());
    for(int s : sources) {
      distances[s] = 0.;
      heap.push_or_decrease(s, 0.);
    }
    while(!heap.empty()) {
      const int v = heap.pop();
      centers[v] = last_edges[v] < 0 ? v : centers[graph.opposite(last_edges[v], v)];
      for(int i = graph.offsets[v]; i < graph.offsets[v + 1]; ++i) {
        const Csr_graph::Arc& arc = graph.arcs[i];
        const double distance = distances[v] + arc.weight;
        if(distance < distances[arc.target]) {
          distances[arc.target] = distance;
          last_edges[arc.target] = arc.edge;
          heap.push_or_decrease(arc.target, distance);
        }
      }
    }
  }
};

// Kruskal's algorithm
inline std::vector<int> minimum_spanning_forest(int number_of_vertices, const std::vector<Edge>& edges)
{
  std::vector<int> order(edges.size()), parents(number_of_vertices), forest;
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return std::make_pair(edges[a].weight, a) < std::make_pair(edges[b].weight, b);
  });
  std::iota(parents.begin(), parents.end(), 0);
  const auto find = [&](int v) {
    while(parents[v] != v)
      v = parents[v] = parents[parents[v]];
    return v;
  };
  for(int e : order) {
    const int v = find(edges[e].source), w = find(edges[e].target);
    if(v != w) {
      parents[v] = w;
      forest.push_back(e);
    }
  }
  return forest;
}

// the edges of the tree of Kou, Markowsky and Berman as Mehlhorn finds it, in increasing order
inline std::vector<int> metric_closure_tree(const Csr_graph& graph, const std::vector<int>& terminals)
{
  const Shortest_paths paths(graph, terminals);
  std::vector<Edge> connections;
  std::vector<int> bridges;
  for(int e = 0; e < graph.number_of_edges(); ++e) {
    const Edge& edge = graph.edges[e];
    const int v = paths.centers[edge.source], w = paths.centers[edge.target];
    if(v != w) {
      connections.push_back({v, w, paths.distances[edge.source] + edge.weight + paths.distances[edge.target]});
      bridges.push_back(e);
    }
  }
  std::vector<int> tree;
  for(int i : minimum_spanning_forest(graph.number_of_vertices(), connections)) {
    tree.push_back(bridges[i]);
    for(int v : {graph.edges[bridges[i]].source, graph.edges[bridges[i]].target})
      for(; paths.last_edges[v] >= 0; v = graph.opposite(paths.last_edges[v], v))
        tree.push_back(paths.last_edges[v]);
  }
  std::sort(tree.begin(), tree.end());
  tree.erase(std::unique(tree.begin(), tree.end()), tree.end());
  return tree;
}

} // namespace plain

#endif // PLAIN_METRIC_CLOSURE_H
