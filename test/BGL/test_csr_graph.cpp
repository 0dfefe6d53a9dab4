// Shortest paths, spanning trees and disjoint sets of the flat graph against Boost's algorithms on adjacency lists, which
// the public call gets, too; buckets and index sets against lists.

#include "steiner_tree_checks.h"

#include <CGAL/Random.h>
#include <CGAL/boost/graph/internal/Graph_kernel/Csr_graph.h>
#include <CGAL/boost/graph/internal/Graph_kernel/Shortest_paths.h>
#include <CGAL/boost/graph/internal/Graph_kernel/index_sets.h>
#include <CGAL/boost/graph/steiner_tree.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>

#include <iterator>
#include <limits>
#include <set>

namespace csr_graph_test {

using Core::Csr_graph;
typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                              boost::property<boost::edge_weight_t, double>> Lists;
typedef boost::graph_traits<Lists>::edge_descriptor Descriptor;

Lists adjacency_lists(const Csr_graph& graph)
{
  Lists result(std::size_t(graph.number_of_vertices()));
  for(const Core::Edge& e : graph.edges)
    add_edge(std::size_t(e.source), std::size_t(e.target), e.weight, result);
  return result;
}

Csr_graph random_graph(CGAL::Random& random)
{
  const int n = random.get_int(1, 40);
  std::vector<Core::Edge> edges; // loops, parallel edges, zero weights, and several components included
  for(int i = random.get_int(0, 4 * n); i > 0; --i)
    edges.push_back(Core::Edge{random.get_int(0, n), random.get_int(0, n), double(random.get_int(0, 9))});
  return Csr_graph(n, edges);
}

void test_shortest_paths(const Csr_graph& graph, const Lists& lists, int source)
{
  std::vector<double> expected(graph.number_of_vertices());
  boost::dijkstra_shortest_paths(lists, std::size_t(source), boost::distance_map(expected.data())
                                                                .distance_inf((std::numeric_limits<double>::infinity)()));
  CGAL::internal::Graph_kernel::Shortest_paths paths(graph);
  paths.add_source(source);
  paths.run();
  CHECK(paths.distances() == expected); // sums of integers are exact
  for(int v = 0; v < graph.number_of_vertices(); ++v)
    if(paths.distance(v) < (std::numeric_limits<double>::infinity)()) {
      std::vector<int> path;
      paths.path(v, std::back_inserter(path));
      CHECK(Core::total_weight(graph, path) == expected[v]);
    }
}

void test_spanning_forest(const Csr_graph& graph, const Lists& lists)
{
  std::vector<Descriptor> expected;
  boost::kruskal_minimum_spanning_tree(lists, std::back_inserter(expected));
  double length = 0.;
  for(const Descriptor& e : expected)
    length += get(boost::edge_weight, lists, e);
  std::vector<int> all;
  for(int e = 0; e < graph.number_of_edges(); ++e)
    all.push_back(e);
  const std::vector<int> forest = Core::minimum_spanning_forest(graph, all);
  CHECK(forest.size() == expected.size());
  CHECK(Core::total_weight(graph, forest) == length);
}

// Components are numbered in the order of their lowest vertices.
void test_disjoint_sets(const Csr_graph& graph, const Lists& lists)
{
  std::vector<int> expected(graph.number_of_vertices()), lowest;
  const int number = boost::connected_components(lists, expected.data());
  for(int v = 0; v < graph.number_of_vertices(); ++v)
    if(expected[v] == int(lowest.size()))
      lowest.push_back(v);
  CGAL::internal::Graph_kernel::Disjoint_sets sets(graph.number_of_vertices());
  int number_of_sets = graph.number_of_vertices();
  for(const Core::Edge& e : graph.edges)
    number_of_sets -= sets.unite(e.source, e.target);
  CHECK(number_of_sets == number);
  for(int v = 0; v < graph.number_of_vertices(); ++v)
    CHECK(sets.find(v) == lowest[expected[v]]);
}

// Against lists of their own, with buckets that stay empty; entries keep their order.
void test_buckets(CGAL::Random& random)
{
  std::vector<std::vector<int>> expected(random.get_int(0, 10));
  std::vector<int> bucket_of(expected.empty() ? 0 : random.get_int(0, 30));
  for(std::size_t i = 0; i < bucket_of.size(); ++i)
    expected[bucket_of[i] = random.get_int(0, int(expected.size()))].push_back(int(i));
  const CGAL::internal::Graph_kernel::Buckets<int> buckets(int(expected.size()), [&](const auto& visit) {
    for(std::size_t i = 0; i < bucket_of.size(); ++i)
      visit(bucket_of[i], int(i));
  });
  CHECK(buckets.number_of_buckets() == int(expected.size()));
  for(int b = 0; b < buckets.number_of_buckets(); ++b) {
    CHECK(buckets.size(b) == int(expected[b].size()));
    CHECK(std::vector<int>(buckets[b].begin(), buckets[b].end()) == expected[b]);
  }
}

// Against a standard set, also when used again.
void test_index_set(CGAL::Random& random)
{
  CGAL::internal::Graph_kernel::Index_set set(random.get_int(1, 20));
  for(int round = 0; round < 2; ++round) {
    std::set<int> expected;
    std::vector<int> order;
    for(int i = random.get_int(0, 30); i > 0; --i) {
      const int value = random.get_int(0, set.number_of_possible());
      if(expected.insert(value).second)
        order.push_back(value);
      set.insert(value);
    }
    for(int i = 0; i < set.number_of_possible(); ++i)
      CHECK(set.contains(i) == (expected.count(i) > 0));
    CHECK(set.indices() == order);
    set.sort();
    CHECK(set.indices() == std::vector<int>(expected.begin(), expected.end()));
    set.clear();
    CHECK(set.indices().empty());
  }
}

} // namespace csr_graph_test

int main()
{
  using namespace csr_graph_test;
  const unsigned int seed = 20260103;
  std::cout << "seed " << seed << std::endl;
  CGAL::Random random(seed);
  for(int i = 0; i < 2000; ++i) {
    test_buckets(random);
    test_index_set(random);
    const Csr_graph graph = random_graph(random);
    const Lists lists = adjacency_lists(graph);
    test_shortest_paths(graph, lists, random.get_int(0, graph.number_of_vertices()));
    test_spanning_forest(graph, lists);
    test_disjoint_sets(graph, lists);

    // terminals may be given several times
    const int s = random.get_int(0, graph.number_of_vertices()), t = random.get_int(0, graph.number_of_vertices());
    const std::vector<std::size_t> terminals{std::size_t(s), std::size_t(t), std::size_t(s)};
    std::vector<Descriptor> tree;
    const CGAL::Steiner_tree::Result result = CGAL::steiner_tree(lists, terminals, std::back_inserter(tree));
    CGAL::internal::Graph_kernel::Shortest_paths paths(graph);
    paths.add_source(s);
    paths.run();
    if(paths.distance(t) < (std::numeric_limits<double>::infinity)())
      CHECK(result && result.is_optimal && result.length == paths.distance(t));
    else
      CHECK(result.status == CGAL::Steiner_tree::Result_status::TERMINALS_NOT_CONNECTED && tree.empty());
  }
  return test::exit_status();
}
