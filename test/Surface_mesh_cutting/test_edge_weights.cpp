// The ready-made weights on surfaces where they are known, and their effect on a cut.

#include <CGAL/Surface_mesh_cutting/connect_points.h>
#include <CGAL/Surface_mesh_cutting/crease_weights.h>
#include <CGAL/Surface_mesh_cutting/visibility_weights.h>

#include "../BGL/check.h"
#include "test_meshes.h"

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <vector>

namespace edge_weights_test {

namespace SMC = CGAL::Surface_mesh_cutting;
namespace PMP = CGAL::Polygon_mesh_processing;
using SMC::Status_code;
using test::Polyhedron;
using test::Soup;
using test::Surface_mesh;

template <typename Mesh>
using Weights
  = typename boost::property_map<Mesh, CGAL::dynamic_edge_property_t<double> >::const_type;

template <typename Mesh>
Weights<Mesh> make_weights(const Mesh& mesh)
{
  return get(CGAL::dynamic_edge_property_t<double>(), mesh);
}

template <typename Mesh, typename Edge>
double length(const Mesh& mesh, Edge e)
{
  return CGAL::to_double(PMP::edge_length(halfedge(e, mesh), mesh));
}

bool are_close(double a, double b) { return std::abs(a - b) <= 1e-12 * (1 + std::abs(b)); }

// A prism over a square, four squares around and n along, with sharp edges between its four sides;
// its ends are closed by pyramids so steep that they meet the sides at an obtuse angle.
Soup prism(int n)
{
  Soup soup = test::sphere(4, n);
  soup.points[soup.points.size() - 2][2] = -0.5;
  soup.points.back()[2] = n + 0.5;
  return soup;
}

bool is_on_side(const Surface_mesh& mesh, Surface_mesh::Edge_index e, int n)
{
  return int(mesh.vertex(e, 0)) < 4 * (n + 1) && int(mesh.vertex(e, 1)) < 4 * (n + 1);
}

void test_creases()
{
  const int n = 5;
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(prism(n));
  const Weights<Surface_mesh> weights = make_weights(mesh);
  CHECK(SMC::crease_weights(mesh, weights, CGAL::parameters::smallest_factor(0.25)));
  int creases = 0, indexed_edges = 0;
  for(auto e : edges(mesh))
  {
    const double factor = get(weights, e) / length(mesh, e);
    CHECK(factor >= 0.25 - 1e-12 && factor <= 1 + 1e-12);
    const int s = int(mesh.vertex(e, 0)), t = int(mesh.vertex(e, 1));
    if(!is_on_side(mesh, e, n) || s % (n + 1) == 0 || t % (n + 1) == 0 || s % (n + 1) == n ||
       t % (n + 1) == n)
      continue;
    const bool is_crease = s / (n + 1) == t / (n + 1);
    CHECK(are_close(factor, is_crease ? 0.25 : 1));
    ++(is_crease ? creases : indexed_edges);
  }
  CHECK(creases > 0 && indexed_edges > 0);

  // a path along the prism keeps to an edge of it
  const std::vector<Surface_mesh::Vertex_index> ends
    = {Surface_mesh::Vertex_index(0), Surface_mesh::Vertex_index(3 * (n + 1) - 1)};
  const auto marks = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  CHECK(SMC::connect_points(mesh, ends, marks, CGAL::parameters::edge_weight_map(weights)));
  int cut_creases = 0;
  for(auto e : edges(mesh))
  {
    const int s = int(mesh.vertex(e, 0)), t = int(mesh.vertex(e, 1));
    cut_creases += get(marks, e) && s / (n + 1) == t / (n + 1);
  }
  CHECK(cut_creases == n);
}

// One sphere inside another one: it cannot be seen from outside, and the outer one is in nobody's
// way.
Soup nested_spheres()
{
  Soup outer = test::sphere(12, 8), inner = outer;
  const auto center = [](Soup& soup, double radius)
  {
    for(std::array<double, 3>& p : soup.points)
    {
      p[2] -= 4;
      const double norm = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
      for(double& x : p)
        x *= radius / norm;
    }
  };
  center(outer, 2);
  center(inner, 1);
  for(std::array<double, 3>& p : inner.points)
    p[2] -= 10; // what `add()` adds
  outer.add(inner);
  return outer;
}

Soup inside_out(Soup soup)
{
  for(std::vector<std::size_t>& f : soup.faces)
    std::reverse(f.begin(), f.end());
  return soup;
}

template <typename Mesh>
void test_visibility(const Soup& soup)
{
  const Mesh mesh = test::make_mesh<Mesh>(soup);
  const Weights<Mesh> weights = make_weights(mesh), other_weights = make_weights(mesh);
  CHECK(SMC::visibility_weights(mesh, weights, CGAL::parameters::number_of_rays(32).smallest_factor(0.5)));
  for(auto e : edges(mesh))
  {
    const auto p = get(CGAL::vertex_point, mesh, source(e, mesh));
    const bool is_inside = CGAL::to_double((p - CGAL::ORIGIN).squared_length()) < 2;
    CHECK(are_close(get(weights, e), length(mesh, e) * (is_inside ? 0.5 : 1)));
  }
  CHECK(SMC::visibility_weights(mesh, other_weights, CGAL::parameters::number_of_rays(32).smallest_factor(0.5)));
  for(auto e : edges(mesh))
    CHECK(get(weights, e) == get(other_weights, e));
#ifdef CGAL_LINKED_WITH_TBB
  CHECK(SMC::visibility_weights<CGAL::Parallel_tag>(mesh, other_weights,
                                                    CGAL::parameters::number_of_rays(32).smallest_factor(0.5)));
  for(auto e : edges(mesh))
    CHECK(get(weights, e) == get(other_weights, e));
#endif
}

// The inner side of a torus sees less than the outer one, and the estimates settle with more rays.
void test_torus()
{
  const int m = 20, n = 16;
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(test::torus(m, n));
  const Weights<Surface_mesh> few = make_weights(mesh), many = make_weights(mesh);
  const Weights<Surface_mesh> other_seed = make_weights(mesh);
  CHECK(SMC::visibility_weights(mesh, few, CGAL::parameters::number_of_rays(200).smallest_factor(0.)));
  CHECK(SMC::visibility_weights(mesh, many, CGAL::parameters::number_of_rays(800).smallest_factor(0.)));
  CHECK(SMC::visibility_weights(mesh, other_seed, CGAL::parameters::random_seed(1).number_of_rays(200).smallest_factor(0.)));
  bool differs = false;
  for(auto e : edges(mesh))
  {
    const double visibility = get(many, e) / length(mesh, e);
    CHECK(std::abs(visibility - get(few, e) / length(mesh, e)) < 0.15);
    differs = differs || get(few, e) != get(other_seed, e);
    const int column = int(mesh.vertex(e, 0)) % n;
    if(column == 0 && int(mesh.vertex(e, 1)) % n == 0)
      CHECK(visibility > 0.99);
    if(column == n / 2 && int(mesh.vertex(e, 1)) % n == n / 2)
      CHECK(visibility < 0.95);
  }
  CHECK(differs);
}

void test_refused()
{
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(prism(2)), empty;
  const Weights<Surface_mesh> weights = make_weights(mesh);
  CHECK(SMC::crease_weights(empty, make_weights(empty)).code == Status_code::EMPTY_MESH);
  for(double factor : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()})
  {
    CHECK(SMC::crease_weights(mesh, weights, CGAL::parameters::smallest_factor(factor)).code == Status_code::WRONG_PARAMETER);
    CHECK(SMC::visibility_weights(mesh, weights, CGAL::parameters::smallest_factor(factor)).code == Status_code::WRONG_PARAMETER);
  }
  CHECK(SMC::visibility_weights(mesh, weights, CGAL::parameters::number_of_rays(0)).code == Status_code::WRONG_PARAMETER);
}

// Ends the run at its n-th question.
struct Stopping_visitor : SMC::Default_visitor
{
  Stopping_visitor(int n, int& questions) : n(n), questions(questions) {}
  bool go_further() const { return ++questions < n; }

  int n;
  int& questions;
};

void test_stopped()
{
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(test::torus(20, 16));
  const Weights<Surface_mesh> weights = make_weights(mesh);
  for(int n : {1, 2, 20})
  {
    for(auto e : edges(mesh))
      put(weights, e, -1);
    int questions = 0;
    const SMC::Result_status<Surface_mesh> status = SMC::visibility_weights(
      mesh, weights, CGAL::parameters::number_of_rays(16).smallest_factor(0.5).visitor(Stopping_visitor(n, questions)));
    CHECK(status.code == Status_code::STOPPED && questions == n);
    for(auto e : edges(mesh))
      CHECK(get(weights, e) == -1);
  }
  int questions = 0;
  const int many = int(num_edges(mesh));
  CHECK(SMC::visibility_weights(
    mesh, weights, CGAL::parameters::number_of_rays(16).smallest_factor(0.5).visitor(Stopping_visitor(many, questions))));
  CHECK(questions > many / 100);
}

// A weight that is infinite only at the internal scale does not forbid the edge: the sum is refused.
void test_huge_weights()
{
  Soup soup = prism(2);
  for(std::array<double, 3>& p : soup.points)
    for(double& x : p)
      x *= 1e-3;
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(soup);
  const Weights<Surface_mesh> weights = make_weights(mesh);
  for(auto e : edges(mesh))
    put(weights, e, 1);
  const auto marks = get(CGAL::dynamic_edge_property_t<bool>(), mesh);
  const std::vector<Surface_mesh::Vertex_index> ends = {Surface_mesh::Vertex_index(0), Surface_mesh::Vertex_index(5)};
  for(double weight : {1e308, 1e306, -1e308})
  {
    put(weights, *edges(mesh).begin(), weight);
    CHECK(SMC::connect_points(mesh, ends, marks, CGAL::parameters::edge_weight_map(weights)).status.code
          == Status_code::WRONG_PARAMETER);
  }
  put(weights, *edges(mesh).begin(), 1e300);
  CHECK(SMC::connect_points(mesh, ends, marks, CGAL::parameters::edge_weight_map(weights)).status);
}

} // namespace edge_weights_test

int main()
{
  using namespace edge_weights_test;
  test_creases();
  test_visibility<Surface_mesh>(nested_spheres());
  test_visibility<Surface_mesh>(inside_out(nested_spheres()));
  test_visibility<Polyhedron>(nested_spheres());
  test_torus();
  test_refused();
  test_stopped();
  test_huge_weights();
  return test::exit_status();
}
