// The public call: graph types, named parameters, special cases, and what is reported.

#include "check.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/steiner_tree.h>

#include <boost/graph/adjacency_list.hpp>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <type_traits>
#include <vector>

namespace steiner_tree_test {

namespace ST = CGAL::Steiner_tree;
namespace params = CGAL::parameters;

template <typename Directed>
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, Directed, boost::no_property,
                                    boost::property<boost::edge_weight_t, double>>;

// a star with center 0 and rays of length 1, whose ends 1, 2, 3 are also connected by edges of length 1.9
template <typename Directed>
void test_star()
{
  typedef Graph<Directed> G;
  G graph(6);
  for(int i = 1; i <= 3; ++i) {
    add_edge(0, i, 1., graph);
    add_edge(i, i % 3 + 1, 1.9, graph);
  }
  add_edge(1, 1, 0., graph);   // loop
  add_edge(0, 1, 5., graph);   // parallel
  add_edge(4, 5, 1., graph);   // another component
  typedef typename boost::graph_traits<G>::vertex_descriptor V;
  typedef typename boost::graph_traits<G>::edge_descriptor E;
  std::vector<E> tree;
  const std::vector<V> ends{1, 2, 3, 2};

  ST::Result result = CGAL::steiner_tree(graph, ends, std::back_inserter(tree));
  CHECK(result && result.is_optimal && result.length == 3. && result.lower_bound == 3.);
  CHECK(tree.size() == 3 && result.number_of_auxiliary_points == 1);

  tree.clear();
  result = CGAL::steiner_tree(graph, ends, std::back_inserter(tree), params::algorithm(ST::Metric_closure_tag()));
  CHECK(result && !result.is_optimal && std::abs(result.length - 3.8) < 1e-12 && result.lower_bound == 0.);
  CHECK(tree.size() == 2 && result.number_of_auxiliary_points == 0);

  const auto length = [&](const auto& np) {
    tree.clear();
    const ST::Result r = CGAL::steiner_tree(graph, ends, std::back_inserter(tree), np);
    CHECK(r);
    return r.length;
  };
  CHECK(std::abs(length(params::algorithm(ST::Shortest_path_heuristic_tag())) - 3.8) < 1e-12);
  CHECK(length(params::algorithm(ST::Greedy_auxiliary_points_tag<>())) == 3.);
  CHECK(length(params::algorithm(ST::Greedy_auxiliary_points_tag<ST::Shortest_path_heuristic_tag>())) == 3.);
  CHECK(length(params::algorithm(ST::Greedy_auxiliary_points_tag<>()).minimum_length_decrease(1.)) > 3.);
  CHECK(length(params::algorithm(ST::Local_search_tag())) == 3.);
  CHECK(length(params::algorithm(ST::Exact_tag())) == 3.);

  // few terminals
  tree.clear();
  result = CGAL::steiner_tree(graph, std::vector<V>(), std::back_inserter(tree));
  CHECK(result && result.is_optimal && result.length == 0. && tree.empty());
  result = CGAL::steiner_tree(graph, std::vector<V>(2, V(4)), std::back_inserter(tree));
  CHECK(result && result.is_optimal && result.length == 0. && tree.empty());
  result = CGAL::steiner_tree(graph, std::vector<V>{1, 0}, std::back_inserter(tree),
                              params::algorithm(ST::Shortest_path_heuristic_tag()));
  CHECK(result && result.is_optimal && result.length == 1. && tree.size() == 1);

  // no tree
  tree.clear();
  result = CGAL::steiner_tree(graph, std::vector<V>{1, 4}, std::back_inserter(tree));
  CHECK(!result && result.status == ST::Result_status::TERMINALS_NOT_CONNECTED && tree.empty());
  for(double bad : {-1., std::nan(""), (std::numeric_limits<double>::infinity)()}) {
    G invalid(4);
    add_edge(1, 2, 1., invalid);
    add_edge(2, 3, bad, invalid);
    result = CGAL::steiner_tree(invalid, ends, std::back_inserter(tree));
    CHECK(!result && result.status == ST::Result_status::INVALID_WEIGHT && tree.empty());
  }

  // all terminals
  result = CGAL::steiner_tree(graph, std::vector<V>{0, 1, 2, 3}, std::back_inserter(tree));
  CHECK(result && result.is_optimal && result.length == 3.);

  // cancelled
  struct Impatient
  {
    int calls = 0;
    bool go_further() { ++calls; return false; }
  } impatient;
  tree.clear();
  G bigger(20);
  for(int i = 0; i < 20; ++i)
    for(int j = 0; j < i; ++j)
      add_edge(i, j, 10. + (i * j) % 7, bigger);
  const std::vector<V> some{0, 3, 6, 9, 12, 15};
  result = CGAL::steiner_tree(bigger, some, std::back_inserter(tree), params::visitor(std::ref(impatient)));
  CHECK(result.is_optimal || (result.status == ST::Result_status::CANCELLED && tree.size() >= 5 && impatient.calls > 0));

  // budget
  G hypercube(32); // half of its vertices: a large gap between bounds and trees
  std::vector<V> half;
  for(int v = 0; v < 32; ++v) {
    int number_of_ones = 0;
    for(int bit = 1; bit < 32; bit *= 2) {
      if((v & bit) == 0)
        add_edge(v, v + bit, 1., hypercube);
      else
        ++number_of_ones;
    }
    if(number_of_ones % 2 == 0)
      half.push_back(V(v));
  }
  tree.clear();
  result = CGAL::steiner_tree(hypercube, half, std::back_inserter(tree),
                              params::algorithm(ST::Exact_tag()).maximum_number_of_states(0));
  CHECK(!result && result.status == ST::Result_status::BUDGET_EXCEEDED && !result.is_optimal);
  CHECK(tree.size() >= 15 && double(tree.size()) == result.length && result.lower_bound < result.length);
  result = CGAL::steiner_tree(bigger, some, std::back_inserter(tree), params::maximum_number_of_states(0));
  CHECK(result && tree.size() >= 5 && result.lower_bound <= result.length);
}

void test_surface_mesh()
{
  typedef CGAL::Simple_cartesian<double>::Point_3 Point;
  typedef CGAL::Surface_mesh<Point> Mesh;
  Mesh mesh;
  CGAL::make_grid(4, 4, mesh, [](int i, int j) { return Point(i, j, 0.); }, true);
  typedef boost::graph_traits<Mesh>::vertex_descriptor V;
  typedef boost::graph_traits<Mesh>::edge_descriptor E;
  std::vector<V> corners;
  for(V v : vertices(mesh))
    if(std::fmod(mesh.point(v).x(), 4.) == 0. && std::fmod(mesh.point(v).y(), 4.) == 0.)
      corners.push_back(v);
  CHECK(corners.size() == 4);
  std::vector<E> tree;
  ST::Result result = CGAL::steiner_tree(mesh, corners, std::back_inserter(tree));
  CHECK(result && result.is_optimal);
  CHECK(std::abs(result.length - (8. + 4. * std::sqrt(2.))) < 4.); // between the star and the border
  double length = 0.;
  for(E e : tree)
    length += get(boost::edge_weight, mesh, e);
  CHECK(std::abs(length - result.length) < 1e-12);

  // removed elements that are not collected yet, weights and indices given by the caller
  const V extra = mesh.add_vertex(Point(7., 7., 7.));
  const V far = mesh.add_vertex(Point(9., 9., 9.));
  mesh.remove_vertex(extra);
  CHECK(mesh.has_garbage());
  auto ones = mesh.add_property_map<E, int>("e:one", 1).first;
  auto index = mesh.add_property_map<V, std::size_t>("v:index", 0).first;
  std::size_t next = 5;
  for(V v : vertices(mesh))
    put(index, v, next += 3);
  tree.clear();
  result = CGAL::steiner_tree(mesh, corners, std::back_inserter(tree),
                              params::edge_weight_map(ones).vertex_index_map(index));
  CHECK(result && result.is_optimal && result.length == double(tree.size()));
  CHECK(result.length >= 8. && result.length <= 12.);
  corners.push_back(far);
  CHECK(CGAL::steiner_tree(mesh, corners, std::back_inserter(tree)).status == ST::Result_status::TERMINALS_NOT_CONNECTED);
}

// more than the dynamic program has sets for: a tree no longer than those of the heuristics
void test_many_terminals()
{
  typedef Graph<boost::undirectedS> G;
  const int side = 60;
  G graph(side * side);
  for(int i = 0; i < side; ++i)
    for(int j = 0; j < side; ++j) {
      const int v = side * i + j;
      if(j + 1 < side)
        add_edge(v, v + 1, 1. + (v * 7 % 11) / 20., graph);
      if(i + 1 < side)
        add_edge(v, v + side, 1. + (v * 5 % 13) / 20., graph);
    }
  std::vector<boost::graph_traits<G>::vertex_descriptor> terminals;
  for(int v = 0; v < side * side; v += 11)
    terminals.push_back(v);
  CHECK(terminals.size() > 256);
  std::vector<boost::graph_traits<G>::edge_descriptor> tree, other;
  const ST::Result best = CGAL::steiner_tree(graph, terminals, std::back_inserter(tree));
  CHECK(best && tree.size() + 1 >= terminals.size());
  const ST::Result heuristic = CGAL::steiner_tree(graph, terminals, std::back_inserter(other),
                                                  params::algorithm(ST::Shortest_path_heuristic_tag()));
  CHECK(best.length <= heuristic.length);
}

} // namespace steiner_tree_test

int main()
{
  using namespace steiner_tree_test;
  test_star<boost::undirectedS>();
  test_star<boost::bidirectionalS>();
  test_star<boost::directedS>();
  test_surface_mesh();
  test_many_terminals();
  return test::exit_status();
}
