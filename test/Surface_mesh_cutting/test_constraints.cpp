// What callers say about edges and vertices: edges that must or must not be cut, weights, vertices that
// the cut has to pass through, and what cannot be satisfied.

#include "../BGL/check.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_cutting/certify_unwrap.h>
#include <CGAL/Surface_mesh_cutting/connect_points.h>
#include <CGAL/Surface_mesh_cutting/cut_length.h>
#include <CGAL/Surface_mesh_cutting/detect_feature_points.h>
#include <CGAL/Surface_mesh_cutting/greedy_cut.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace constraints_test {

namespace SMC = CGAL::Surface_mesh_cutting;
using SMC::Status_code;
using Point_2 = CGAL::Simple_cartesian<double>::Point_2;

// A mesh and all that can be said about it.
template <typename Mesh>
struct Task
{
  using Traits = boost::graph_traits<Mesh>;
  using Vertex = typename Traits::vertex_descriptor;
  using Edge = typename Traits::edge_descriptor;

  Mesh mesh;
  decltype(get(CGAL::dynamic_edge_property_t<bool>(), std::declval<Mesh&>())) must, never, is_cut;
  decltype(get(CGAL::dynamic_edge_property_t<double>(), std::declval<Mesh&>())) weight;
  decltype(get(CGAL::dynamic_vertex_property_t<bool>(), std::declval<Mesh&>())) is_terminal;
  decltype(get(CGAL::dynamic_halfedge_property_t<Point_2>(), std::declval<Mesh&>())) uv;
  SMC::Unwrap_result<Mesh> result;

  explicit Task(Mesh given) : mesh(std::move(given))
  {
    for(auto* map : {&must, &never, &is_cut})
      *map = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
    weight = get(CGAL::dynamic_edge_property_t<double>(), mesh);
    is_terminal = get(CGAL::dynamic_vertex_property_t<bool>(), mesh);
    uv = get(CGAL::dynamic_halfedge_property_t<Point_2>(), mesh);
    for(Edge e : edges(mesh))
    {
      put(must, e, false);
      put(never, e, false);
      put(is_cut, e, false);
      put(weight, e, std::sqrt(CGAL::to_double(CGAL::squared_distance(point(source(e, mesh)), point(target(e, mesh))))));
    }
    for(Vertex v : vertices(mesh))
      put(is_terminal, v, false);
  }

  auto point(Vertex v) const { return get(get(CGAL::vertex_point, mesh), v); }
  double height(Vertex v) const { return CGAL::to_double(point(v).z()); }
  double height(Edge e) const { return 0.5 * (height(source(e, mesh)) + height(target(e, mesh))); }

  // Marks the edges along the ring of vertices at the given height.
  template <typename Map>
  void mark_ring(Map map, double z)
  {
    for(Edge e : edges(mesh))
      if(height(source(e, mesh)) == z && height(target(e, mesh)) == z)
        put(map, e, true);
  }

  template <typename IsMarked>
  void mark(decltype(must) map, IsMarked is_marked)
  {
    for(Edge e : edges(mesh))
      put(map, e, is_marked(e));
  }

  Status_code run()
  {
    result = SMC::unwrap(mesh, is_cut, uv, CGAL::parameters::edge_is_constrained_map(must)
                                             .edge_is_forbidden_map(never).edge_weight_map(weight)
                                             .vertex_is_constrained_map(is_terminal));
    return result.status.code;
  }

  void check_valid(const std::string& name)
  {
    CHECK(result, name + ": " + result.status.message);
    if(!result)
      return;
    CHECK(SMC::certify_unwrap(mesh, is_cut, uv) && result.flips == 0, name + ": certificate");
    CHECK(std::abs(SMC::cut_length(mesh, is_cut) - result.cut_length) <= 1e-9 * result.cut_length, name + ": length");
    for(Edge e : edges(mesh))
    {
      CHECK(!get(must, e) || is_border(e, mesh) || get(is_cut, e), name + ": an edge that must be cut");
      CHECK(!get(never, e) || !get(is_cut, e), name + ": an edge that must not be cut");
    }
    for(Vertex v : vertices(mesh))
      if(get(is_terminal, v))
      {
        bool is_open = false;
        for(auto h : halfedges_around_target(v, mesh))
          is_open = is_open || is_border_edge(h, mesh) || get(is_cut, edge(h, mesh));
        CHECK(is_open, name + ": a terminal");
        CHECK(std::count(result.feature_points.begin(), result.feature_points.end(), v) == 1, name + ": features");
      }
  }
};

using Surface_task = Task<test::Surface_mesh>;

test::Surface_mesh sphere(int m = 16, int n = 11) { return test::make_mesh<test::Surface_mesh>(test::sphere(m, n)); }
test::Surface_mesh torus() { return test::make_mesh<test::Surface_mesh>(test::torus(20, 10)); }

template <typename Mesh>
void test_edges_that_must_be_cut(const Mesh& mesh, const std::string& name)
{
  Task<Mesh> separating(mesh);
  separating.mark_ring(separating.must, 4);
  separating.run();
  separating.check_valid(name + ", a ring");
  CHECK(separating.result.components == 1 && separating.result.genus == 0 && separating.result.borders == 0,
        "the topology is that of the input");

  Task<Mesh> single(mesh);
  put(single.must, *edges(single.mesh).begin(), true);
  single.run();
  single.check_valid(name + ", one edge");

  Task<Mesh> apart(mesh);
  apart.mark(apart.must, [&](auto e) { return apart.height(e) == 2.5 || apart.height(e) == 7.5; });
  apart.run();
  apart.check_valid(name + ", many paths");
}

void test_loops_of_a_torus()
{
  Surface_task task(torus());
  task.mark_ring(task.must, 0); // at the inner and outer equator
  task.run();
  task.check_valid("torus in two annuli");
  CHECK(task.result.genus == 1, "genus of the input");
}

void test_edges_that_must_not_be_cut()
{
  Surface_task lower(sphere());
  lower.mark(lower.never, [&](auto e) { return lower.height(e) > 5; });
  lower.run();
  lower.check_valid("only the lower half");

  Surface_task island(sphere());
  island.mark(island.never, [&](auto e) { return island.height(e) > 3 && island.height(e) < 8; });
  island.run();
  island.check_valid("a band that must not be cut");

  std::vector<test::Surface_mesh::Vertex_index> poles;
  for(auto v : vertices(island.mesh))
    if(island.height(v) > 8)
      poles.push_back(v);
  CHECK(SMC::connect_points(island.mesh, poles, island.is_cut,
                                 CGAL::parameters::edge_is_forbidden_map(island.never)), "points beyond a band");
  poles.push_back(*vertices(island.mesh).begin());
  CHECK(SMC::connect_points(island.mesh, poles, island.is_cut,
                            CGAL::parameters::edge_is_forbidden_map(island.never)).status.code ==
          Status_code::INFEASIBLE_CONSTRAINTS, "points on both sides of a band");

  Surface_task handle(torus());
  handle.mark(handle.never, [&](auto e) { return handle.point(source(e, handle.mesh)).x() > 0; });
  CHECK(handle.run() == Status_code::INFEASIBLE_CONSTRAINTS && !handle.result.status.edges.empty(),
        "a handle on the forbidden side");
  for(auto e : handle.result.status.edges)
    CHECK(get(handle.never, e), "the witness is forbidden");

  Surface_task all(sphere());
  all.mark(all.never, [](auto) { return true; });
  CHECK(all.run() == Status_code::INFEASIBLE_CONSTRAINTS, "nothing may be cut");
  Surface_task one(sphere());
  one.mark(one.never, [&](auto e) { return e != *edges(one.mesh).begin(); });
  CHECK(one.run() == Status_code::INFEASIBLE_CONSTRAINTS, "only one edge may be cut");
  Surface_task tree(sphere());
  tree.mark(tree.never, [&](auto e) { return tree.height(e) != 2; });
  tree.run();
  tree.check_valid("only a ring may be cut");
  Surface_task disk(test::make_mesh<test::Surface_mesh>(test::patch(4, 4)));
  disk.mark(disk.never, [](auto) { return true; });
  disk.run();
  disk.check_valid("a disk that stays whole");
  Surface_task tube(test::make_mesh<test::Surface_mesh>(test::tube(8, 4)));
  tube.mark(tube.never, [&](auto e) { return tube.height(e) == 2.5; });
  CHECK(tube.run() == Status_code::INFEASIBLE_CONSTRAINTS, "the borders cannot be connected");

  Surface_task both(sphere());
  both.mark_ring(both.must, 4);
  both.mark_ring(both.never, 4);
  CHECK(both.run() == Status_code::INFEASIBLE_CONSTRAINTS && both.result.status.edges.size() == 16, "both");
}

void test_terminals()
{
  for(const test::Surface_mesh& mesh : {sphere(), torus(), test::make_mesh<test::Surface_mesh>(test::patch(6, 6))})
    for(int step : {37, 1000})
    {
      Surface_task task(mesh);
      int i = 0;
      for(auto v : vertices(task.mesh))
        put(task.is_terminal, v, i++ % step == 20);
      task.run();
      task.check_valid("terminals");

      std::vector<test::Surface_mesh::Vertex_index> points;
      SMC::detect_feature_points(task.mesh, std::back_inserter(points),
                                 CGAL::parameters::vertex_is_constrained_map(task.is_terminal));
      CHECK(std::is_sorted(points.begin(), points.end()), "sorted");
      for(auto v : vertices(task.mesh))
        CHECK(!get(task.is_terminal, v) || std::count(points.begin(), points.end(), v) == 1, "detected");
    }

  Surface_task enclosed(sphere());
  const auto v = *std::next(vertices(enclosed.mesh).begin(), 50);
  put(enclosed.is_terminal, v, true);
  put(enclosed.is_terminal, *vertices(enclosed.mesh).begin(), true);
  for(auto h : halfedges_around_target(v, enclosed.mesh))
    put(enclosed.never, edge(h, enclosed.mesh), true);
  CHECK(enclosed.run() == Status_code::INFEASIBLE_CONSTRAINTS && enclosed.result.status.vertices.size() == 1 &&
          enclosed.result.status.vertices.front() == v, "a terminal that only forbidden edges reach");
  put(enclosed.is_terminal, v, false);
  enclosed.run();
  enclosed.check_valid("a vertex that only forbidden edges reach");

  Surface_task isolated(sphere());
  const auto extra = isolated.mesh.add_vertex(test::Surface_mesh::Point(0, 0, 1));
  put(isolated.is_terminal, extra, true);
  CHECK(isolated.run() == Status_code::INFEASIBLE_CONSTRAINTS, "an isolated vertex");
}

void test_weights()
{
  // The two ends of a long tube are connected on the side where edges are cheap.
  Surface_task task(test::make_mesh<test::Surface_mesh>(test::tube(24, 12)));
  for(auto e : edges(task.mesh))
    if(task.point(source(e, task.mesh)).x() > 0.5)
      put(task.weight, e, 0.01 * get(task.weight, e));
  task.run();
  task.check_valid("weights");
  CHECK(!task.result.lower_bound && !task.result.is_optimal, "no bound on the length");
  double expensive = 0;
  for(auto e : edges(task.mesh))
    if(get(task.is_cut, e) && task.point(source(e, task.mesh)).x() <= 0.5)
      expensive += get(task.weight, e);
  CHECK(expensive < 0.01, "the cut runs where it is cheap");

  for(double invalid : {-1., std::nan(""), -std::numeric_limits<double>::infinity()})
  {
    put(task.weight, *edges(task.mesh).begin(), 1);
    for(auto e : edges(task.mesh))
      if(!is_border(e, task.mesh))
      {
        put(task.weight, e, invalid);
        CHECK(task.run() == Status_code::WRONG_PARAMETER && task.result.status.edges.size() == 1, "invalid weight");
        break;
      }
  }
  Surface_task huge(sphere());
  for(auto e : edges(huge.mesh))
    put(huge.weight, e, 1e308);
  CHECK(huge.run() == Status_code::WRONG_PARAMETER, "weights whose sum is infinite");
  Surface_task free(sphere());
  for(auto e : edges(free.mesh))
    put(free.weight, e, 0);
  free.run();
  free.check_valid("weights of zero");
  Surface_task infinite(sphere());
  for(auto e : edges(infinite.mesh))
    if(infinite.height(e) > 5)
    {
      put(infinite.weight, e, std::numeric_limits<double>::infinity());
      put(infinite.never, e, true); // to be checked
    }
  infinite.run();
  infinite.check_valid("infinite weights");
}

// Constraints that say nothing change nothing.
void test_neutral_constraints()
{
  Surface_task task(sphere());
  CHECK(task.run() == Status_code::OK, "neutral constraints");
  const auto without = SMC::unwrap(task.mesh, task.is_cut, task.uv);
  CHECK(without.cut_length == task.result.cut_length && without.average_distortion == task.result.average_distortion &&
          without.lower_bound == task.result.lower_bound, "the same as without constraints");
  const auto constant = SMC::greedy_cut(
    task.mesh, task.is_cut,
    CGAL::parameters::edge_is_constrained_map(CGAL::Constant_property_map<test::Surface_mesh::Edge_index, bool>(false))
      .edge_weight_map(CGAL::Constant_property_map<test::Surface_mesh::Edge_index, int>(3))
      .vertex_is_constrained_map(CGAL::Constant_property_map<test::Surface_mesh::Vertex_index, bool>(false)));
  CHECK(constant, "constant maps");
}

} // namespace constraints_test

int main()
{
  using namespace constraints_test;
  test_edges_that_must_be_cut(sphere(), "Surface_mesh");
  test_edges_that_must_be_cut(test::make_mesh_with_garbage(test::sphere(16, 11)), "removed elements");
  test_edges_that_must_be_cut(test::make_mesh<test::Polyhedron>(test::sphere(16, 11)), "Polyhedron_3");
  test_edges_that_must_be_cut(test::make_mesh<test::Linear_cell_complex>(test::sphere(16, 11)), "Linear_cell_complex");
  test_loops_of_a_torus();
  test_edges_that_must_not_be_cut();
  test_terminals();
  test_weights();
  test_neutral_constraints();
  return test::exit_status();
}
