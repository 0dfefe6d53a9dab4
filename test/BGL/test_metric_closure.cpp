// The tree of the metric closure, on flat arrays and, by Boost's searches and spanning trees, on graphs of other types,
// against a plain implementation.

#include "mesh_graphs.h"
#include "steiner_tree_checks.h"

#include <CGAL/boost/graph/internal/Steiner_tree/metric_closure.h>
#include <CGAL/boost/graph/internal/Steiner_tree/metric_closure_of_graph.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <boost/graph/adjacency_list.hpp>

#include <iterator>
#include <limits>
#include <map>
#include <set>

namespace metric_closure_test {

const double infinity = (std::numeric_limits<double>::infinity)();

// the shortest distances from some vertices, in quadratic time
struct Plain_search
{
  std::vector<double> distances;
  std::vector<int> sources, last_edges; // of each vertex; -1: none

  Plain_search(const Core::Csr_graph& graph, const std::vector<int>& from)
    : distances(graph.number_of_vertices(), infinity)
    , sources(graph.number_of_vertices(), -1)
    , last_edges(graph.number_of_vertices(), -1)
  {
    for(int v : from) {
      distances[v] = 0.;
      sources[v] = v;
    }
    std::vector<char> is_settled(distances.size(), 0);
    for(;;) {
      int v = -1;
      for(int w = 0; w < int(distances.size()); ++w)
        if(!is_settled[w] && distances[w] < (v < 0 ? infinity : distances[v]))
          v = w;
      if(v < 0)
        return;
      is_settled[v] = 1;
      for(int e = 0; e < graph.number_of_edges(); ++e)
        if(graph.edges[e].source == v || graph.edges[e].target == v) {
          const int w = graph.opposite(e, v);
          if(distances[v] + graph.edges[e].weight < distances[w]) {
            distances[w] = distances[v] + graph.edges[e].weight;
            sources[w] = sources[v];
            last_edges[w] = e;
          }
        }
    }
  }
};

// Mehlhorn's variant
std::vector<int> plain_tree(const Core::Csr_graph& graph, const std::vector<int>& terminals)
{
  const Plain_search search(graph, terminals);
  std::set<std::pair<double, int>> connections;
  for(int e = 0; e < graph.number_of_edges(); ++e) {
    const Core::Edge& edge = graph.edges[e];
    if(search.sources[edge.source] != search.sources[edge.target])
      connections.insert({search.distances[edge.source] + edge.weight + search.distances[edge.target], e});
  }
  std::vector<int> part(graph.number_of_vertices());
  for(std::size_t v = 0; v < part.size(); ++v)
    part[v] = int(v);
  std::set<int> tree;
  for(const auto& connection : connections) {
    const Core::Edge& edge = graph.edges[connection.second];
    const int first = part[search.sources[edge.source]], second = part[search.sources[edge.target]];
    if(first == second)
      continue;
    for(int& p : part)
      if(p == second)
        p = first;
    tree.insert(connection.second);
    for(int v : {edge.source, edge.target})
      for(; search.last_edges[v] >= 0; v = graph.opposite(search.last_edges[v], v))
        tree.insert(search.last_edges[v]);
  }
  return std::vector<int>(tree.begin(), tree.end());
}

// the weight of the minimum spanning tree of the whole metric closure (Prim), which is what the tree comes from
double metric_closure_length(const Core::Csr_graph& graph, const std::vector<int>& terminals)
{
  std::vector<double> nearest(terminals.size(), infinity);
  std::vector<char> is_reached(terminals.size(), 0);
  double length = 0.;
  std::size_t next = 0;
  for(std::size_t step = 0; step < terminals.size(); ++step) {
    length += step == 0 ? 0. : nearest[next];
    is_reached[next] = 1;
    const Plain_search search(graph, {terminals[next]});
    std::size_t best = terminals.size();
    for(std::size_t i = 0; i < terminals.size(); ++i) {
      nearest[i] = (std::min)(nearest[i], search.distances[terminals[i]]);
      if(!is_reached[i] && (best == terminals.size() || nearest[i] < nearest[best]))
        best = i;
    }
    next = best;
  }
  return length;
}

// the same graph as adjacency lists: the same tree
template <typename VertexList>
void check_adjacency_list(const Core::Csr_graph& graph, const std::vector<int>& terminals,
                          const std::vector<int>& expected)
{
  typedef boost::property<boost::edge_weight_t, double, boost::property<boost::edge_index_t, int>> Edge_property;
  typedef boost::adjacency_list<boost::vecS, VertexList, boost::undirectedS, boost::no_property, Edge_property> Graph;
  typedef typename boost::graph_traits<Graph>::vertex_descriptor Vertex;
  Graph other;
  std::vector<Vertex> vertices;
  std::map<Vertex, int> index;
  for(int v = 0; v < graph.number_of_vertices(); ++v) {
    vertices.push_back(add_vertex(other));
    index[vertices.back()] = v;
  }
  for(int e = 0; e < graph.number_of_edges(); ++e)
    add_edge(vertices[graph.edges[e].source], vertices[graph.edges[e].target],
             Edge_property(graph.edges[e].weight, e), other);
  std::vector<Vertex> ends;
  for(int t : terminals)
    ends.push_back(vertices[t]);
  // its edges are in the order in which they were added
  CHECK(Core::metric_closure_tree(other, ends, get(boost::edge_weight, other), boost::make_assoc_property_map(index))
        == expected);
}

void test_random_graphs(CGAL::Random& random)
{
  int number_connected = 0;
  for(int i = 0; i < 12000; ++i) {
    const int n = random.get_int(2, 30);
    const bool has_ties = random.get_bool();
    const auto weight = [&] { return has_ties ? double(random.get_int(0, 4)) : random.get_double(0., 1.); };
    std::vector<Core::Edge> edges; // loops, parallel edges, and several components included
    if(random.get_int(0, 4) != 0)
      for(int v = 1; v < n; ++v)
        edges.push_back(Core::Edge{random.get_int(0, v), v, weight()});
    for(int j = random.get_int(0, 3 * n); j > 0; --j)
      edges.push_back(Core::Edge{random.get_int(0, n), random.get_int(0, n), weight()});
    const Core::Csr_graph graph(n, edges);
    const std::vector<int> terminals = random_terminals(n, random.get_int(1, n + 1), random);
    const Core::Tree tree = Core::metric_closure_tree(graph, terminals);
    CHECK(tree.edges == plain_tree(graph, terminals));
    check_adjacency_list<boost::vecS>(graph, terminals, tree.edges);
    check_adjacency_list<boost::listS>(graph, terminals, tree.edges);
    const double length = metric_closure_length(graph, terminals);
    if(length < infinity) {
      ++number_connected;
      check_tree(graph, terminals, tree);
      CHECK(tree.length <= length * (1. + 1e-9));
    }
  }
  std::cout << number_connected << " with connected terminals" << std::endl;
  CHECK(number_connected >= 6000);
}

void test_surface_mesh(CGAL::Random& random)
{
  typedef CGAL::Simple_cartesian<double>::Point_3 Point;
  typedef CGAL::Surface_mesh<Point> Mesh;
  typedef boost::graph_traits<Mesh>::vertex_descriptor Vertex;
  Mesh mesh;
  const auto shifted = [&](int i, int j) {
    return Point(i + random.get_double(0., 0.4), j + random.get_double(0., 0.4), random.get_double(0., 1.));
  };
  CGAL::make_grid(20, 15, mesh, shifted, true);
  std::vector<Core::Edge> edges;
  for(const auto& e : CGAL::make_range(CGAL::edges(mesh)))
    edges.push_back(Core::Edge{int(source(e, mesh)), int(target(e, mesh)), get(boost::edge_weight, mesh, e)});
  const Core::Csr_graph graph(int(num_vertices(mesh)), edges);
  for(int i = 0; i < 50; ++i) {
    const std::vector<int> terminals = random_terminals(graph.number_of_vertices(), 2 + i, random);
    std::vector<Vertex> ends;
    for(int t : terminals)
      ends.push_back(Vertex(std::size_t(t)));
    const Core::Tree tree = Core::metric_closure_tree(graph, terminals);
    check_tree(graph, terminals, tree);
    CHECK(tree.edges == plain_tree(graph, terminals));
    CHECK(Core::metric_closure_tree(mesh, ends, get(boost::edge_weight, mesh), get(boost::vertex_index, mesh))
          == tree.edges);
  }
}

} // namespace metric_closure_test

int main()
{
  using namespace metric_closure_test;
  const unsigned int seed = 20260104;
  std::cout << "seed " << seed << std::endl;
  CGAL::Random random(seed);
  test_random_graphs(random);
  test_surface_mesh(random);
  return test::exit_status();
}
