// Handle loops: what they are, what is left, how short they are, and what is refused.

#include <CGAL/Surface_mesh_cutting/cut_handles.h>

#include "../BGL/check.h"
#include "random_surfaces.h"
#include "test_meshes.h"

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <limits>
#include <set>
#include <vector>

namespace cut_handles_test {

namespace SMC = CGAL::Surface_mesh_cutting;
using namespace CGAL::Surface_mesh_cutting::internal;
using SMC::Status_code;
using test::Polyhedron;
using test::Linear_cell_complex;
using test::Soup;
using test::Surface_mesh;

template <typename Mesh>
using Marks = typename boost::property_map<Mesh, CGAL::dynamic_edge_property_t<bool> >::const_type;

template <typename Mesh>
Marks<Mesh> no_marks(const Mesh& mesh)
{
  Marks<Mesh> marks = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  for(auto e : edges(mesh))
    put(marks, e, false);
  return marks;
}

template <typename Mesh>
using Adapter
  = Mesh_adapter<Mesh, typename boost::property_map<Mesh, CGAL::vertex_point_t>::const_type>;

template <typename Mesh>
Adapter<Mesh> adapt(const Mesh& mesh)
{
  return {mesh, get(CGAL::vertex_point, mesh)};
}

struct Shape
{
  int parts, genus, borders;
};

Shape shape(const Indexed_mesh& mesh, const Cut& cut)
{
  const Corner_table chart = make_chart(mesh, cut);
  const Connected_parts parts(chart.opposites());
  Shape result{parts.number, 0, 0};
  for(const Topology& t : topologies(chart, parts))
  {
    result.genus += t.genus();
    result.borders += t.border_loops;
  }
  return result;
}

template <typename Mesh>
void check_loops(const Mesh& mesh, const SMC::Handles_result<Mesh>& result, Marks<Mesh> marks,
                 Marks<Mesh> constrained)
{
  const auto adapter = adapt(mesh);
  const Shape before = shape(adapter.mesh(), adapter.read_cut(constrained));
  const Shape after = shape(adapter.mesh(), adapter.read_cut(marks));
  CHECK(result);
  CHECK(int(result.loops.size()) == before.genus);
  CHECK(after.genus == 0);
  CHECK(after.parts == before.parts);
  // each loop makes two borders, or joins borders that it meets
  CHECK(after.borders <= before.borders + 2 * before.genus);

  Marks<Mesh> is_open = no_marks(mesh);
  for(auto e : edges(mesh))
    put(is_open, e, CGAL::is_border(e, mesh) || get(constrained, e));
  double length = 0;
  for(const auto& loop : result.loops)
  {
    CHECK(!loop.empty());
    using halfedge_descriptor = typename boost::graph_traits<Mesh>::halfedge_descriptor;
    const std::set<halfedge_descriptor> distinct(loop.begin(), loop.end());
    CHECK(distinct.size() == loop.size());
    bool opens_an_edge = false;
    for(std::size_t i = 0; i < loop.size(); ++i)
    {
      CHECK(source(loop[i], mesh) == target(loop[i == 0 ? loop.size() - 1 : i - 1], mesh));
      if(get(is_open, edge(loop[i], mesh)))
        continue;
      put(is_open, edge(loop[i], mesh), opens_an_edge = true);
      const auto p = get(CGAL::vertex_point, mesh, source(loop[i], mesh));
      const auto q = get(CGAL::vertex_point, mesh, target(loop[i], mesh));
      length += std::sqrt(CGAL::to_double(CGAL::squared_distance(p, q)));
    }
    CHECK(opens_an_edge);
  }
  for(auto e : edges(mesh))
    CHECK(get(marks, e) == (get(is_open, e) && !CGAL::is_border(e, mesh)));
  CHECK(std::abs(length - result.length) <= 1e-9 * (1 + length));
}

template <typename Mesh>
std::vector<int> test_surface(const Soup& soup)
{
  const Mesh mesh = test::make_mesh<Mesh>(soup);
  Marks<Mesh> marks = no_marks(mesh);
  const SMC::Handles_result<Mesh> result = SMC::cut_handles(mesh, marks);
  check_loops(mesh, result, marks, no_marks(mesh));
  std::vector<int> cut;
  for(auto h : halfedges(mesh))
    cut.push_back(get(marks, edge(h, mesh)));
  return cut;
}

void test_random_surfaces()
{
  CGAL::Random random(1);
  std::set<int> genera;
  for(int i = 0; i < 100; ++i)
  {
    const int rows = random.uniform_int(4, 14), columns = random.uniform_int(2, 10);
    const int handles = random.uniform_int(0, 8), holes = random.uniform_int(0, 4);
    const test::Random_surface surface
      = test::random_surface(rows, columns, handles, holes, random);
    Soup soup = surface.soup;
    if(i % 4 == 0)
      soup.add(test::torus(6, 5));
    const std::vector<int> cut = test_surface<Surface_mesh>(soup);
    CHECK(cut == test_surface<Surface_mesh>(soup)); // deterministic
    if(i % 5 == 0)
    {
      test_surface<Polyhedron>(soup);
      test_surface<Linear_cell_complex>(soup);
    }
    genera.insert(surface.genus);
  }
  CHECK(genera.size() >= 5);
}

// Distances and shortest path trees by relaxing all edges again and again.
struct Slow_shortest_paths
{
  std::vector<double> distance;
  std::vector<int> last;

  Slow_shortest_paths(const Indexed_mesh& mesh, int root)
    : distance(mesh.number_of_vertices(), std::numeric_limits<double>::infinity()),
      last(mesh.number_of_vertices(), -1)
  {
    distance[root] = 0;
    for(bool has_changed = true; has_changed; )
    {
      has_changed = false;
      for(int e = 0; e < mesh.number_of_edges(); ++e)
        for(int k = 0; k < 2; ++k)
        {
          const int h = mesh.halfedge(e);
          const int s = k ? mesh.source(h) : mesh.target(h);
          const int t = k ? mesh.target(h) : mesh.source(h);
          if(!(distance[s] + mesh.length(e) < distance[t]))
            continue;
          distance[t] = distance[s] + mesh.length(e);
          last[t] = e;
          has_changed = true;
        }
    }
  }

  std::set<int> path(const Indexed_mesh& mesh, int v) const
  {
    std::set<int> edges;
    while(last[v] >= 0)
    {
      edges.insert(last[v]);
      const int h = mesh.halfedge(last[v]);
      v = mesh.source(h) == v ? mesh.target(h) : mesh.source(h);
    }
    return edges;
  }
};

// The length of the shortest cycle of a closed surface whose opening does not fall apart, from all
// roots.
double shortest_loop_by_brute_force(const Indexed_mesh& mesh)
{
  double best = std::numeric_limits<double>::infinity();
  for(int root = 0; root < mesh.number_of_vertices(); ++root)
  {
    const Slow_shortest_paths paths(mesh, root);
    for(int e = 0; e < mesh.number_of_edges(); ++e)
    {
      const int s = mesh.source(mesh.halfedge(e)), t = mesh.target(mesh.halfedge(e));
      if(paths.distance[s] + mesh.length(e) + paths.distance[t] >= best)
        continue;
      const std::set<int> forth = paths.path(mesh, s), back = paths.path(mesh, t);
      std::set<int> cycle;
      std::set_symmetric_difference(forth.begin(), forth.end(), back.begin(), back.end(),
                                    std::inserter(cycle, cycle.end()));
      if(!cycle.insert(e).second || cycle.size() < 2)
        continue;
      Cut cut(mesh.number_of_edges(), 0);
      for(int c : cycle)
        cut[c] = 1;
      if(shape(mesh, cut).parts == 1)
        best = (std::min)(best, cut_length(mesh, cut));
    }
  }
  return best;
}

// With all nodes as roots and no tolerance the first loop is a shortest one, and the default is
// almost as short.
void test_lengths()
{
  CGAL::Random random(2);
  for(int i = 0; i < 20; ++i)
  {
    const int rows = random.uniform_int(5, 8), columns = random.uniform_int(3, 5);
    const test::Random_surface surface
      = test::random_surface(rows, columns, random.uniform_int(1, 3), 0, random);
    const Surface_mesh mesh = test::make_mesh<Surface_mesh>(surface.soup);
    const auto adapter = adapt(mesh);
    const Indexed_mesh& flat = adapter.mesh();
    const Edge_constraints constraints = unconstrained(flat);
    const double best = shortest_loop_by_brute_force(flat);
    const auto first_length = [&](const Handle_loops& handles)
    {
      double length = 0;
      for(const Directed_edge& e : handles.loops.front())
        length += flat.length(flat.edge(e.halfedge));
      return length;
    };
    const Handle_loops exact = cut_handles(flat, constraints, always_go_further, 0.);
    const Handle_loops usual = cut_handles(flat, constraints);
    CHECK(std::abs(first_length(exact) - best) < 1e-9 * best);
    CHECK(first_length(usual) * 0.95 <= best);
    CHECK(cut_length(flat, usual.cut) <= 1.25 * cut_length(flat, exact.cut));
  }
}

void test_stop()
{
  CGAL::Random random(3);
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(test::random_surface(6, 6, 3, 0, random).soup);
  const auto adapter = adapt(mesh);
  const Edge_constraints constraints = unconstrained(adapter.mesh());
  const std::size_t number_of_loops = cut_handles(adapter.mesh(), constraints).loops.size();
  CHECK(number_of_loops > 1);
  for(std::size_t allowed = 0; allowed <= number_of_loops; ++allowed)
  {
    std::size_t questions = 0;
    const Handle_loops handles = cut_handles(adapter.mesh(), constraints, [&] { return questions++ < allowed; });
    CHECK(handles.loops.size() == allowed);
    CHECK(bool(handles.status) == (allowed == number_of_loops));
    CHECK(handles.status || handles.status.finding.code == Status_code::STOPPED);
  }
}

// A torus of m by n squares: vertex (i, j) is i * n + j.
const int m = 9, n = 7;

Soup flat_torus() { return test::torus(m, n); }

bool is_across(const Surface_mesh& mesh, Surface_mesh::Edge_index e, int column)
{
  const int s = int(mesh.vertex(e, 0)) / n, t = int(mesh.vertex(e, 1)) / n;
  return s != t && (std::min)(s, t) == column && (std::max)(s, t) == column + 1;
}

void test_constraints()
{
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(flat_torus());
  const Marks<Surface_mesh> none = no_marks(mesh);
  Marks<Surface_mesh> marks = no_marks(mesh);

  // a ring that cannot be crossed leaves the loops along it
  Marks<Surface_mesh> ring = no_marks(mesh);
  for(auto e : edges(mesh))
    put(ring, e, is_across(mesh, e, 3));
  auto result = SMC::cut_handles(mesh, marks, CGAL::parameters::edge_is_forbidden_map(ring));
  check_loops(mesh, result, marks, none);
  for(auto e : edges(mesh))
    CHECK(!get(marks, e) || !get(ring, e));

  // a cross that cannot be crossed leaves none, and is the witness
  Marks<Surface_mesh> cross = no_marks(mesh);
  for(auto e : edges(mesh))
  {
    const int s = int(mesh.vertex(e, 0)) % n, t = int(mesh.vertex(e, 1)) % n;
    put(cross, e, get(ring, e) || (s != t && (std::min)(s, t) == 2 && (std::max)(s, t) == 3));
    put(marks, e, true);
  }
  result = SMC::cut_handles(mesh, marks, CGAL::parameters::edge_is_forbidden_map(cross));
  CHECK(result.status.code == Status_code::INFEASIBLE_CONSTRAINTS);
  CHECK(!result.status.edges.empty() && result.loops.empty());
  for(auto e : result.status.edges)
    CHECK(get(cross, e));
  for(auto e : edges(mesh))
    CHECK(get(marks, e)); // unchanged

  // a constrained loop leaves no handle; with an edge of it forbidden, that is the witness
  Marks<Surface_mesh> meridian = no_marks(mesh);
  for(auto e : edges(mesh))
    put(meridian, e, int(mesh.vertex(e, 0)) / n == 4 && int(mesh.vertex(e, 1)) / n == 4);
  result = SMC::cut_handles(mesh, marks, CGAL::parameters::edge_is_constrained_map(meridian));
  check_loops(mesh, result, marks, meridian);
  CHECK(result.length == 0);
  result = SMC::cut_handles(mesh, marks, CGAL::parameters::edge_is_constrained_map(meridian)
                                                          .edge_is_forbidden_map(meridian));
  CHECK(result.status.code == Status_code::INFEASIBLE_CONSTRAINTS);
  CHECK(result.status.edges.size() == std::size_t(n));

  // constrained edges that leave the handle
  Marks<Surface_mesh> path = no_marks(mesh);
  for(auto e : edges(mesh))
    put(path, e, get(meridian, e) && int(mesh.vertex(e, 0)) % n > 1 &&
                 int(mesh.vertex(e, 1)) % n > 1);
  result = SMC::cut_handles(mesh, marks, CGAL::parameters::edge_is_constrained_map(path));
  check_loops(mesh, result, marks, path);
  for(auto e : edges(mesh))
    CHECK(get(marks, e) == get(meridian, e)); // the constrained edges come for free
}

void test_weights()
{
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(flat_torus());
  Marks<Surface_mesh> marks = no_marks(mesh);
  auto weights = get(CGAL::dynamic_edge_property_t<double>(), mesh);
  for(auto e : edges(mesh))
    put(weights, e,
        int(mesh.vertex(e, 0)) % n == 5 && int(mesh.vertex(e, 1)) % n == 5 ? 0.001 : 1.);
  auto result = SMC::cut_handles(mesh, marks, CGAL::parameters::edge_weight_map(weights));
  check_loops(mesh, result, marks, no_marks(mesh));
  for(auto e : edges(mesh))
    CHECK(get(marks, e) == (get(weights, e) < 1));

  for(double invalid : {-1., std::numeric_limits<double>::quiet_NaN()})
  {
    put(weights, *edges(mesh).begin(), invalid);
    result = SMC::cut_handles(mesh, marks, CGAL::parameters::edge_weight_map(weights));
    CHECK(result.status.code == Status_code::WRONG_PARAMETER);
    CHECK(result.status.edges.size() == 1 && result.status.edges[0] == *edges(mesh).begin());
  }
}

void test_refused()
{
  // weights that cannot be added
  Soup soup = flat_torus();
  soup.scale(0.25); // to an extent between 1 and 2, which leaves the weights as they are
  const Surface_mesh torus = test::make_mesh<Surface_mesh>(soup);
  auto huge = get(CGAL::dynamic_edge_property_t<double>(), torus);
  for(auto e : edges(torus))
    put(huge, e, (std::numeric_limits<double>::max)());
  const auto result
    = SMC::cut_handles(torus, no_marks(torus), CGAL::parameters::edge_weight_map(huge));
  CHECK(result.status.code == Status_code::WRONG_PARAMETER);

  Surface_mesh mesh;
  Marks<Surface_mesh> marks = no_marks(mesh);
  CHECK(SMC::cut_handles(mesh, marks).status.code == Status_code::EMPTY_MESH);
}

} // namespace cut_handles_test

int main()
{
  using namespace cut_handles_test;
  test_random_surfaces();
  test_lengths();
  test_stop();
  test_constraints();
  test_weights();
  test_refused();
  return test::exit_status();
}
