// Surfaces with many handles: loops, cuts to one disk that become cheaper, and the whole method, all decided by Euler's
// formula; a plate whose loops are known.

#include <CGAL/Surface_mesh_cutting/certify_unwrap.h>
#include <CGAL/Surface_mesh_cutting/internal/connection/Opening_search.h>
#include <CGAL/Surface_mesh_cutting/internal/connection/connect_terminals.h>
#include <CGAL/Surface_mesh_cutting/internal/handles/Handle_loops.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include "../BGL/check.h"
#include "random_surfaces.h"

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace many_handles_test {

namespace SMC = CGAL::Surface_mesh_cutting;
using namespace CGAL::Surface_mesh_cutting::internal;
using test::Soup;
using test::Surface_mesh;

using Adapter
  = Mesh_adapter<Surface_mesh, boost::property_map<Surface_mesh, CGAL::vertex_point_t>::const_type>;

Topology topology_of(const Indexed_mesh& mesh, const Cut& cut)
{
  const Corner_table chart = make_chart(mesh, cut);
  const Connected_parts parts(chart.opposites());
  CHECK(parts.number == 1);
  return topologies(chart, parts).front();
}

// More handles than a homology class has coordinates for.
void test_loops(CGAL::Random& random)
{
  const test::Random_surface surface = test::random_surface(70, 60, 150, 3, random);
  CHECK(2 * surface.genus > Homology_class::number_of_coordinates);
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(surface.soup);
  const Adapter adapter(mesh, get(CGAL::vertex_point, mesh));
  const Handle_loops handles = cut_handles(adapter.mesh(), unconstrained(adapter.mesh()));
  CHECK(handles.status);
  CHECK(int(handles.loops.size()) == surface.genus);
  CHECK(topology_of(adapter.mesh(), handles.cut).genus() == 0);
}

void test_opening(CGAL::Random& random)
{
  const int handles = random.uniform_int(5, 25), holes = random.uniform_int(0, 4);
  const test::Random_surface surface = test::random_surface(30, 25, handles, holes, random);
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(surface.soup);
  const Adapter adapter(mesh, get(CGAL::vertex_point, mesh));
  const Indexed_mesh& indexed = adapter.mesh();
  Edge_constraints constraints = unconstrained(indexed);
  constraints.mandatory = cut_handles(indexed, constraints).cut;

  std::vector<int> terminals;
  std::vector<char> is_kept(indexed.number_of_vertices(), 0);
  const std::vector<char> is_on_border = open_vertices(indexed, Cut(indexed.number_of_edges(), 0));
  for(int i = random.uniform_int(0, 5); i > 0; --i)
  {
    const int v = random.uniform_int(0, indexed.number_of_vertices() - 1);
    if(!is_on_border[v] && !is_kept[v])
      terminals.push_back(v);
    is_kept[v] = !is_on_border[v];
  }
  CGAL::internal::Steiner_tree::Options options;
  options.method = CGAL::internal::Steiner_tree::Method::metric_closure;
  const Connected_cut connected
    = connect_terminals(indexed, constraints, terminals, options, Execution::SEQUENTIAL, always_go_further);
  CHECK(connected.status);
  CHECK(topology_of(indexed, connected.cut).is_disk());

  Opening_search search(indexed, constraints, is_kept, connected.cut);
  search.run(always_go_further);
  CHECK(topology_of(indexed, search.cut()).is_disk());
  CHECK(cut_length(indexed, search.cut()) < cut_length(indexed, connected.cut));
  const std::vector<char> is_open = open_vertices(indexed, search.cut());
  for(int v : terminals)
    CHECK(is_open[v]);
}

// A row of squares with a round hole each, of two sides with `thickness` between them.
Soup plate(int columns, int segments, double radius, double thickness)
{
  Soup soup;
  const auto corner = [&](int side, int i, int j) { return std::size_t(side * 2 * (columns + 1) + 2 * i + j); };
  for(int side = 0; side < 2; ++side)
    for(int i = 0; i <= columns; ++i)
      for(int j = 0; j < 2; ++j)
        soup.points.push_back({double(i), double(j), side * thickness});
  const auto add = [&](int side, std::size_t a, std::size_t b, std::size_t c)
  {
    if(side == 1)
      soup.faces.push_back({a, b, c});
    else
      soup.faces.push_back({a, c, b});
  };
  for(int i = 0; i < columns; ++i)
  {
    const std::size_t first = soup.points.size();
    const auto circle = [&](int side, int k) { return first + side * segments + k % segments; };
    for(int side = 0; side < 2; ++side)
    {
      for(int k = 0; k < segments; ++k)
      {
        const double angle = 2 * CGAL_PI * k / segments;
        soup.points.push_back({i + 0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle), side * thickness});
      }
      const std::size_t square[4] = {corner(side, i + 1, 1), corner(side, i, 1), corner(side, i, 0), corner(side, i + 1, 0)};
      for(int k = 0; k < segments; ++k)
        add(side, circle(side, k), square[4 * k / segments], circle(side, k + 1));
      for(int k = 0; k < 4; ++k)
        add(side, circle(side, k * segments / 4), square[(k + 3) % 4], square[k]);
    }
    for(int k = 0; k < segments; ++k)
    {
      soup.faces.push_back({circle(0, k), circle(1, k), circle(1, k + 1)});
      soup.faces.push_back({circle(0, k), circle(1, k + 1), circle(0, k + 1)});
    }
  }
  const auto wall = [&](int i, int j, int k, int l)
  {
    soup.faces.push_back({corner(0, i, j), corner(0, k, l), corner(1, k, l)});
    soup.faces.push_back({corner(0, i, j), corner(1, k, l), corner(1, i, j)});
  };
  for(int i = 0; i < columns; ++i)
  {
    wall(i, 0, i + 1, 0);
    wall(i + 1, 1, i, 1);
  }
  wall(columns, 0, columns, 1);
  wall(0, 1, 0, 0);
  return soup;
}

// In a thick plate with narrow holes, the shortest loops go around the holes.
void test_plate()
{
  const int columns = 4, segments = 16;
  const double radius = 0.1;
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(plate(columns, segments, radius, 1));
  const Adapter adapter(mesh, get(CGAL::vertex_point, mesh));
  const Handle_loops handles = cut_handles(adapter.mesh(), unconstrained(adapter.mesh()));
  CHECK(int(handles.loops.size()) == columns);
  const double expected = columns * segments * 2 * radius * std::sin(CGAL_PI / segments);
  const double length = adapter.to_original_scale(cut_length(adapter.mesh(), handles.cut));
  CHECK(std::abs(length - expected) < 1e-9);
}

// The method opens it to a disk before it looks for features.
void test_unwrap(CGAL::Random& random)
{
  const test::Random_surface surface = test::random_surface(32, 28, 30, 2, random);
  CHECK(2 * surface.genus + surface.borders > int(Cutting_parameters::many_terminals));
  Surface_mesh mesh = test::make_mesh<Surface_mesh>(surface.soup);
  using UV = CGAL::Simple_cartesian<double>::Point_2;
  auto uv = mesh.add_property_map<Surface_mesh::Halfedge_index, UV>("h:uv").first;
  std::vector<bool> cuts[2];
  for(int i = 0; i < 2; ++i)
  {
    auto is_cut = mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:is_cut" + std::to_string(i), false).first;
    const auto parameters = CGAL::parameters::effort(SMC::Effort::FAST);
    const SMC::Unwrap_result<Surface_mesh> result
      = i == 0 ? SMC::unwrap<CGAL::Sequential_tag>(mesh, is_cut, uv, parameters)
               : SMC::unwrap<CGAL::Parallel_if_available_tag>(mesh, is_cut, uv, parameters);
    CHECK(result.status && result.genus == surface.genus && result.borders == surface.borders);
    CHECK(result.flips == 0 && SMC::certify_unwrap(mesh, is_cut, uv));
    for(auto e : mesh.edges())
      cuts[i].push_back(is_cut[e]);
  }
  CHECK(cuts[0] == cuts[1]);
}

} // namespace many_handles_test

int main()
{
  using namespace many_handles_test;
  const unsigned int seed = 5;
  std::cout << "seed " << seed << std::endl;
  CGAL::Random random(seed);
  test_loops(random);
  for(int i = 0; i < 10; ++i)
    test_opening(random);
  test_plate();
  test_unwrap(random);
  return test::exit_status();
}
