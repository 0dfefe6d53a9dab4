// Cuts through given points on surfaces of all kinds.

#include <CGAL/Surface_mesh_cutting/connect_points.h>
#include <CGAL/Surface_mesh_cutting/cut_length.h>
#include <CGAL/Surface_mesh_cutting/is_cut_to_disks.h>

#include "../BGL/check.h"
#include "random_surfaces.h"
#include "test_meshes.h"

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Random.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <limits>
#include <set>
#include <vector>

namespace connect_points_test {

namespace SMC = CGAL::Surface_mesh_cutting;
namespace params = CGAL::parameters;
using SMC::Connection;
using SMC::Status_code;
using test::Linear_cell_complex;
using test::Polyhedron;
using test::Soup;
using test::Surface_mesh;

template <typename Mesh>
using Marks = typename boost::property_map<Mesh, CGAL::dynamic_edge_property_t<bool> >::const_type;
template <typename Mesh>
using Vertices = std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor>;

template <typename Mesh>
Marks<Mesh> no_marks(const Mesh& mesh)
{
  Marks<Mesh> marks = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  for(auto e : edges(mesh))
    put(marks, e, false);
  return marks;
}

template <typename Mesh>
Vertices<Mesh> some_vertices(const Mesh& mesh, int number, CGAL::Random& random)
{
  const Vertices<Mesh> all(vertices(mesh).begin(), vertices(mesh).end());
  Vertices<Mesh> result;
  for(int i = 0; i < number; ++i)
    result.push_back(all[random.uniform_int(0, int(all.size()) - 1)]); // may repeat
  return result;
}

// The marked edges that are not on the border.
template <typename Mesh>
std::vector<typename boost::graph_traits<Mesh>::edge_descriptor>
cut_edges(const Mesh& mesh, Marks<Mesh> marks)
{
  std::vector<typename boost::graph_traits<Mesh>::edge_descriptor> result;
  for(auto e : edges(mesh))
    if(get(marks, e))
    {
      CHECK(!CGAL::is_border(e, mesh));
      result.push_back(e);
    }
  return result;
}

template <typename Mesh>
int cut_degree(const Mesh& mesh, Marks<Mesh> marks,
               typename boost::graph_traits<Mesh>::vertex_descriptor v)
{
  int degree = 0;
  for(auto h : CGAL::halfedges_around_target(v, mesh))
    degree += get(marks, edge(h, mesh)) || CGAL::is_border(edge(h, mesh), mesh);
  return degree;
}

// Each part is a disk with at least three border edges, and each point lies on a border.
template <typename Mesh>
void check_cut(const Mesh& mesh, const Vertices<Mesh>& points, Marks<Mesh> marks,
               const SMC::Connection_result<Mesh>& result)
{
  CHECK(SMC::is_cut_to_disks(mesh, marks));
  for(auto v : points)
    CHECK(cut_degree(mesh, marks, v) > 0);
  CHECK(std::abs(SMC::cut_length(mesh, marks) - result.length) <= 1e-9 * result.length);
  const auto edges = cut_edges(mesh, marks);
  if(CGAL::is_closed(mesh))
    CHECK(edges.size() >= 2);
}

// The edges of a tree: no cycle, no other leaf than the points.
template <typename Mesh>
void check_tree(const Mesh& mesh, const Vertices<Mesh>& points, Marks<Mesh> marks)
{
  std::set<typename boost::graph_traits<Mesh>::vertex_descriptor> ends;
  const auto edges = cut_edges(mesh, marks);
  for(auto e : edges)
  {
    ends.insert(source(e, mesh));
    ends.insert(target(e, mesh));
  }
  CHECK(ends.size() == edges.size() + 1);
  for(auto v : ends)
    if(cut_degree(mesh, marks, v) == 1)
      CHECK(std::find(points.begin(), points.end(), v) != points.end() || edges.size() == 2);
}

template <typename Mesh>
void test_methods(const Soup& soup, int number_of_points, int seed)
{
  const Mesh mesh = test::make_mesh<Mesh>(soup);
  CGAL::Random random(seed);
  const Vertices<Mesh> points = some_vertices(mesh, number_of_points, random);
  Marks<Mesh> best_marks = no_marks(mesh), marks = no_marks(mesh);
  const auto best = SMC::connect_points(mesh, points, best_marks);
  CHECK(best);
  check_cut(mesh, points, best_marks, best);
  const bool is_single_edge = cut_edges(mesh, best_marks).size() == 2; // after the extension
  CHECK(best.is_optimal || is_single_edge);
  CHECK(best.lower_bound <= best.length * (1 + 1e-9));
  CHECK(!best.is_optimal || best.lower_bound >= best.length * (1 - 1e-9));

  for(Connection connection : {Connection::METRIC_CLOSURE, Connection::SHORTEST_PATH_HEURISTIC,
                               Connection::GREEDY, Connection::EXACT})
  {
    const auto result = SMC::connect_points(mesh, points, marks, params::connection(connection));
    CHECK(result || (is_single_edge && result.status.code == Status_code::BOUND_NOT_REACHED));
    check_cut(mesh, points, marks, result);
    CHECK(is_single_edge || result.length >= best.length * (1 - 1e-9));
    CHECK(connection != Connection::EXACT || std::abs(result.length - best.length) <= 1e-9);
  }
#ifdef CGAL_LINKED_WITH_TBB
  CHECK(SMC::connect_points<CGAL::Parallel_tag>(mesh, points, marks));
  for(auto e : edges(mesh))
    CHECK(get(marks, e) == get(best_marks, e));
#endif
}

void test_random_surfaces()
{
  CGAL::Random random(1);
  for(int i = 0; i < 60; ++i)
  {
    const int rows = random.uniform_int(4, 12), columns = random.uniform_int(2, 9);
    const int handles = random.uniform_int(0, 3), holes = random.uniform_int(0, 4);
    const test::Random_surface surface
      = test::random_surface(rows, columns, handles, holes, random);
    const int points = random.uniform_int(surface.genus + surface.borders == 0 ? 8 : 0, 10);
    Soup soup = surface.soup;
    if(i % 3 == 0)
      soup.add(test::torus(5, 4));
    test_methods<Surface_mesh>(soup, points, i);
    if(i % 10 == 0)
    {
      test_methods<Polyhedron>(soup, points, i);
      test_methods<Linear_cell_complex>(soup, points, i);
    }
  }
}

void test_trees_on_spheres()
{
  CGAL::Random random(2);
  for(int i = 0; i < 30; ++i)
  {
    const test::Random_surface surface = test::random_surface(9, 7, 0, 0, random);
    const Surface_mesh mesh = test::make_mesh<Surface_mesh>(surface.soup);
    Vertices<Surface_mesh> points = some_vertices(mesh, random.uniform_int(2, 9), random);
    points.push_back(*std::next(vertices(mesh).begin(), 3));
    points.push_back(*std::next(vertices(mesh).begin(), 60));
    Marks<Surface_mesh> marks = no_marks(mesh);
    CHECK(SMC::connect_points(mesh, points, marks));
    check_tree(mesh, points, marks);
  }
}

// One point and one border: the shortest path, found by relaxing all edges again and again.
void test_path_to_border()
{
  CGAL::Random random(3);
  const test::Random_surface surface = test::random_surface(10, 8, 0, 1, random);
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(surface.soup);
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> distance(num_vertices(mesh), infinity);
  for(auto h : halfedges(mesh))
    if(CGAL::is_border(h, mesh))
      distance[target(h, mesh)] = 0;
  for(std::size_t round = 0; round < num_vertices(mesh); ++round)
    for(auto h : halfedges(mesh))
    {
      const double length = CGAL::Polygon_mesh_processing::edge_length(h, mesh);
      double& d = distance[target(h, mesh)];
      d = (std::min)(d, distance[source(h, mesh)] + length);
    }
  Marks<Surface_mesh> marks = no_marks(mesh);
  for(auto v : vertices(mesh))
  {
    const auto result = SMC::connect_points(mesh, Vertices<Surface_mesh>(1, v), marks);
    CHECK(result && result.is_optimal);
    CHECK(std::abs(result.length - distance[v]) < 1e-9);
  }
}

void test_small_cuts()
{
  // a tetrahedron: any two vertices are neighbors, and one edge is not enough
  Soup tetrahedron;
  tetrahedron.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(tetrahedron);
  const Vertices<Surface_mesh> all(vertices(mesh).begin(), vertices(mesh).end());
  Marks<Surface_mesh> marks = no_marks(mesh);
  for(std::size_t number = 2; number <= 4; ++number)
  {
    const Vertices<Surface_mesh> points(all.begin(), all.begin() + number);
    const auto result = SMC::connect_points(mesh, points, marks);
    CHECK(result);
    check_cut(mesh, points, marks, result);
    CHECK(cut_edges(mesh, marks).size() == (std::max)(number - 1, std::size_t(2)));
  }

  // nothing to connect on a closed sphere
  for(std::size_t number = 0; number <= 1; ++number)
  {
    const Vertices<Surface_mesh> points(all.begin(), all.begin() + number);
    const auto result = SMC::connect_points(mesh, points, marks);
    CHECK(result.status.code == Status_code::WRONG_PARAMETER);
    CHECK(result.status.faces.size() == 4);
  }

  // one constrained edge
  Marks<Surface_mesh> constrained = no_marks(mesh);
  put(constrained, *edges(mesh).begin(), true);
  const auto result = SMC::connect_points(mesh, Vertices<Surface_mesh>(), marks,
                                          params::edge_is_constrained_map(constrained));
  CHECK(result);
  check_cut(mesh, {}, marks, result);
  CHECK(get(marks, *edges(mesh).begin()));

  // a disk without points stays closed
  const Surface_mesh patch = test::make_mesh<Surface_mesh>(test::patch(4, 3));
  Marks<Surface_mesh> patch_marks = no_marks(patch);
  const auto none = SMC::connect_points(patch, Vertices<Surface_mesh>(), patch_marks);
  CHECK(none && none.length == 0 && none.is_optimal);
  CHECK(cut_edges(patch, patch_marks).empty());
}

// Random edges that must be cut and that must not: a cut as asked for, or a refusal. There is a cut at
// least where cutting all edges that may be cut leaves only disks; test_random_topology.cpp decides
// exactly where.
void test_random_constraints()
{
  CGAL::Random random(4);
  int number_of_cuts = 0, number_of_refusals = 0;
  for(int i = 0; i < 150; ++i)
  {
    const test::Random_surface surface = test::random_surface(
      8, 6, random.uniform_int(0, 2), random.uniform_int(0, 2), random);
    const Surface_mesh mesh = test::make_mesh<Surface_mesh>(surface.soup);
    Marks<Surface_mesh> constrained = no_marks(mesh), forbidden = no_marks(mesh);
    Marks<Surface_mesh> allowed = no_marks(mesh), marks = no_marks(mesh);
    const double part_forbidden = random.get_double(0, 0.8);
    for(auto e : edges(mesh))
    {
      const double x = random.get_double();
      put(forbidden, e, x < part_forbidden);
      put(constrained, e, x > 0.97 - 0.3 * (i % 3 == 0));
      put(allowed, e, !get(forbidden, e));
    }
    Vertices<Surface_mesh> points = some_vertices(mesh, 4, random);
    bool is_feasible = SMC::is_cut_to_disks(mesh, allowed);
    for(auto v : points)
      is_feasible = is_feasible && cut_degree(mesh, allowed, v) > 0;

    const auto result = SMC::connect_points(
      mesh, points, marks,
      params::edge_is_constrained_map(constrained).edge_is_forbidden_map(forbidden));
    if(result)
    {
      ++number_of_cuts;
      check_cut(mesh, points, marks, result);
      for(auto e : edges(mesh))
      {
        CHECK(!get(marks, e) || !get(forbidden, e));
        CHECK(get(marks, e) || !get(constrained, e) || CGAL::is_border(e, mesh));
      }
    }
    else
    {
      ++number_of_refusals;
      CHECK(result.status.code == Status_code::INFEASIBLE_CONSTRAINTS);
      CHECK(!result.status.edges.empty() || !result.status.vertices.empty());
      for(auto e : result.status.edges)
        CHECK(get(forbidden, e));
    }
    CHECK(!is_feasible || result);
  }
  std::cout << number_of_cuts << " cuts, " << number_of_refusals << " refusals\n";
  CHECK(number_of_cuts > 20 && number_of_refusals > 20);
}

// A constrained loop around the middle separates a sphere: each half gets its own tree.
void test_separating_constraint()
{
  const int m = 8, n = 6;
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(test::sphere(m, n));
  Marks<Surface_mesh> constrained = no_marks(mesh), marks = no_marks(mesh);
  for(auto e : edges(mesh))
  {
    const int s = int(mesh.vertex(e, 0)), t = int(mesh.vertex(e, 1));
    put(constrained, e, s < m * (n + 1) && t < m * (n + 1) && s % (n + 1) == 3 && t % (n + 1) == 3);
  }
  const Vertices<Surface_mesh> poles = {Surface_mesh::Vertex_index(m * (n + 1)),
                                        Surface_mesh::Vertex_index(m * (n + 1) + 1)};
  const auto result
    = SMC::connect_points(mesh, poles, marks, params::edge_is_constrained_map(constrained));
  CHECK(result && result.is_optimal);
  check_cut(mesh, poles, marks, result);
  // straight up and straight down
  CHECK(cut_edges(mesh, marks).size() == std::size_t(m + (3 + 1) + (n - 3 + 1)));
}

struct Impatient : public SMC::Default_visitor
{
  bool go_further() const { return false; }
};

void test_stopped()
{
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(test::sphere(12, 12));
  CGAL::Random random(5);
  const Vertices<Surface_mesh> points = some_vertices(mesh, 12, random);
  Marks<Surface_mesh> marks = no_marks(mesh);
  const auto result = SMC::connect_points(mesh, points, marks, params::visitor(Impatient()));
  CHECK(result || result.status.code == Status_code::STOPPED);
  check_cut(mesh, points, marks, result);
}

} // namespace connect_points_test

int main()
{
  using namespace connect_points_test;
  test_random_surfaces();
  test_trees_on_spheres();
  test_path_to_border();
  test_small_cuts();
  test_random_constraints();
  test_separating_constraint();
  test_stopped();
  return test::exit_status();
}
