// Variants and products of the ready-made weights on surfaces where they are known.

#include <CGAL/Surface_mesh_cutting/crease_weights.h>
#include <CGAL/Surface_mesh_cutting/painted_weights.h>
#include <CGAL/Surface_mesh_cutting/straightness_weights.h>
#include <CGAL/Surface_mesh_cutting/visibility_weights.h>

#include "../BGL/check.h"
#include "test_meshes.h"

#include <CGAL/number_type_config.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <vector>

namespace weight_factors_test {

namespace SMC = CGAL::Surface_mesh_cutting;
namespace parameters = CGAL::parameters;
using SMC::Status_code;
using test::Soup;
using Mesh = test::Surface_mesh;
using Kernel = CGAL::Simple_cartesian<double>;
using Edge = Mesh::Edge_index;
using Vertex = Mesh::Vertex_index;
using Weights = Mesh::Property_map<Edge, double>;
using Paint = Mesh::Property_map<Vertex, double>;

constexpr double infinity = std::numeric_limits<double>::infinity(), not_a_number = std::numeric_limits<double>::quiet_NaN();

const auto rays = parameters::number_of_rays(400).smallest_factor(0.);

Weights make_weights(Mesh& mesh) { return mesh.add_property_map<Edge, double>("", -1).first; }

double length(const Mesh& mesh, Edge e)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
}

double factor(const Mesh& mesh, Weights weights, Edge e) { return weights[e] / length(mesh, e); }

bool are_close(double a, double b, double tolerance = 1e-12) { return std::abs(a - b) <= tolerance * (1 + std::abs(b)); }

// The place of a vertex of `test::tube(m, n)`.
int column(Vertex v, int n) { return int(v) / (n + 1); }
int row(Vertex v, int n) { return int(v) % (n + 1); }

// A tube over an L, whose fourth side edge is the only concave one.
void test_concave_creases()
{
  const int n = 3, concave_column = 3;
  const std::array<std::array<double, 2>, 6> l = {{{{0, 0}}, {{2, 0}}, {{2, 1}}, {{1, 1}}, {{1, 2}}, {{0, 2}}}};
  Soup soup = test::tube(6, n);
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    for(std::size_t k : {0, 1})
      soup.points[i][k] = l[i / (n + 1)][k];
  Mesh mesh = test::make_mesh<Mesh>(soup);
  const Weights plain = make_weights(mesh), concave = make_weights(mesh);
  CHECK(SMC::crease_weights(mesh, plain, parameters::smallest_factor(0.25)));
  CHECK(SMC::crease_weights(mesh, concave, parameters::smallest_convex_factor(0.75).smallest_factor(0.25)));
  int number_of_concave = 0, number_of_convex = 0;
  for(const Edge e : mesh.edges())
  {
    const bool is_crease = column(mesh.vertex(e, 0), n) == column(mesh.vertex(e, 1), n);
    const bool is_concave = is_crease && column(mesh.vertex(e, 0), n) == concave_column;
    CHECK(are_close(factor(mesh, plain, e), is_crease ? 0.25 : 1));
    CHECK(are_close(factor(mesh, concave, e), is_concave ? 0.25 : is_crease ? 0.75 : 1));
    number_of_concave += is_concave;
    number_of_convex += is_crease && !is_concave;
  }
  CHECK(number_of_concave == n && number_of_convex == 5 * n);
}

Soup round_sphere()
{
  const int n = 22;
  Soup soup = test::sphere(48, n);
  for(std::array<double, 3>& p : soup.points)
  {
    const double polar = CGAL_PI * (p[2] + 1) / (n + 2), around = std::atan2(p[1], p[0]);
    p = {std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), -std::cos(polar)};
  }
  return soup;
}

// Of a dome of sky, a sphere sees the part above its tangent planes.
void test_sky()
{
  Mesh mesh = test::make_mesh<Mesh>(round_sphere());
  const Weights cosine = make_weights(mesh), uniform = make_weights(mesh);
  for(const Kernel::Vector_3& up : {Kernel::Vector_3(0, 0, 1), Kernel::Vector_3(-3e8, 1e8, 2e8)})
  {
    CHECK(SMC::visibility_weights(mesh, cosine, rays.up_direction(up)));
    CHECK(SMC::visibility_weights(mesh, uniform, rays.up_direction(up).use_uniform_directions(true)));
    for(const Edge e : mesh.edges())
    {
      const Kernel::Vector_3 normal = CGAL::midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))) - CGAL::ORIGIN;
      const double c = normal * up / std::sqrt(normal.squared_length() * up.squared_length());
      CHECK(are_close(factor(mesh, cosine, e), (1 + c) / 2, 0.08));
      CHECK(are_close(factor(mesh, uniform, e), 1 - std::acos(c) / CGAL_PI, 0.08));
      CHECK(c > -0.99 || factor(mesh, cosine, e) < 0.03); // the underside
    }
  }
#ifdef CGAL_LINKED_WITH_TBB
  const Weights parallel = make_weights(mesh);
  CHECK(SMC::visibility_weights<CGAL::Parallel_tag>(mesh, parallel, rays.up_direction(Kernel::Vector_3(-3e8, 1e8, 2e8))));
  for(const Edge e : mesh.edges())
    CHECK(parallel[e] == cosine[e]);
#endif
}

// A cup, with rings of edges: 0 to 2 up the outer wall, 3 to 5 down the inner one.
Soup cup()
{
  const std::array<std::array<double, 2>, 6> profile
    = {{{{1, 0}}, {{1, 1}}, {{1, 2}}, {{0.9, 2}}, {{0.9, 1}}, {{0.9, 0.1}}}};
  const int n = 5;
  Soup soup = test::sphere(48, n);
  for(std::size_t i = 0; i + 2 < soup.points.size(); ++i)
  {
    const std::array<double, 2>& p = profile[i % (n + 1)];
    soup.points[i] = {p[0] * soup.points[i][0], p[0] * soup.points[i][1], p[1]};
  }
  soup.points[soup.points.size() - 2][2] = 0;
  soup.points.back()[2] = 0.1;
  return soup;
}

// The inside is darker; with a radius, only where something is near. Where the bottom meets the wall at a right
// angle, the part of the view that is left is the cosine of half that angle.
void test_occlusion()
{
  const int n = 5;
  Mesh mesh = test::make_mesh<Mesh>(cup());
  const Weights far = make_weights(mesh), near = make_weights(mesh);
  CHECK(SMC::visibility_weights(mesh, far, rays));
  CHECK(SMC::visibility_weights(mesh, near, rays.occlusion_radius(0.02)));
  int edges_of_rings = 0;
  for(const Edge e : mesh.edges())
  {
    const int ring = row(mesh.vertex(e, 0), n);
    const bool is_on_ring = (std::max)(int(mesh.vertex(e, 0)), int(mesh.vertex(e, 1))) < 48 * (n + 1)
                            && ring == row(mesh.vertex(e, 1), n);
    CHECK(near[e] >= far[e]);
    if(!is_on_ring)
      continue;
    ++edges_of_rings;
    if(ring <= 2)
      CHECK(are_close(factor(mesh, far, e), 1));
    if(ring == 4)
      CHECK(factor(mesh, far, e) < 0.6 && factor(mesh, near, e) > 0.95);
    if(ring == 5)
      CHECK(are_close(factor(mesh, near, e), std::cos(CGAL_PI / 4), 0.05));
  }
  CHECK(edges_of_rings == 48 * (n + 1));
}

// On a cylinder, edges along and around are cheap; others have the squared cosine of twice their angle.
void test_straightness(double stretch, double scale)
{
  const int m = 24, n = 8;
  const double side = 2 * std::sin(CGAL_PI / m), height = stretch * side;
  Soup soup = test::tube(m, n);
  for(std::array<double, 3>& p : soup.points)
    p[2] *= height;
  soup.scale(scale);
  Mesh mesh = test::make_mesh<Mesh>(soup);
  const Weights weights = make_weights(mesh);
  CHECK(SMC::straightness_weights(mesh, weights, parameters::smallest_factor(0.2)));
  const double bent = 1 / (1 + 1 / (8 + n * height * n * height)); // curvature 1, and the squared diagonal
  const double cosine = (1 - stretch * stretch) / (1 + stretch * stretch);
  int straight = 0, oblique = 0;
  for(const Edge e : mesh.edges())
  {
    const Vertex s = mesh.vertex(e, 0), t = mesh.vertex(e, 1);
    if((std::min)(row(s, n), row(t, n)) == 0 || (std::max)(row(s, n), row(t, n)) == n)
      continue;
    const bool is_along = column(s, n) == column(t, n), is_straight = is_along || row(s, n) == row(t, n);
    const double length = is_along ? height : is_straight ? side : std::hypot(height, side);
    CHECK(are_close(weights[e] / (scale * length), 1 - 0.8 * bent * (is_straight ? 1 : cosine * cosine), 1e-3));
    ++(is_straight ? straight : oblique);
  }
  CHECK(straight > oblique && oblique > 0);
}

// Where no direction is better than the others, nothing is favored.
void test_without_directions()
{
  Soup flat = test::patch(6, 6);
  for(std::array<double, 3>& p : flat.points)
    p[2] = 0;
  Mesh plane = test::make_mesh<Mesh>(flat), sphere = test::make_mesh<Mesh>(round_sphere());
  const Weights on_plane = make_weights(plane), on_sphere = make_weights(sphere);
  CHECK(SMC::straightness_weights(plane, on_plane, parameters::smallest_factor(0.2)));
  CHECK(SMC::straightness_weights(sphere, on_sphere, parameters::smallest_factor(0.2)));
  for(const Edge e : plane.edges())
    CHECK(are_close(factor(plane, on_plane, e), 1));
  for(const Edge e : sphere.edges())
    CHECK(std::abs(sphere.point(sphere.vertex(e, 0)).z()) > 0.5 || factor(sphere, on_sphere, e) > 0.9);
}

Paint make_paint(Mesh& mesh)
{
  const Paint paint = mesh.add_property_map<Vertex, double>("", 0).first;
  for(const Vertex v : mesh.vertices())
    paint[v] = int(v) % 7;
  return paint;
}

void test_paint()
{
  Mesh mesh = test::make_mesh<Mesh>(test::tube(8, 5));
  const Weights weights = make_weights(mesh);
  const Paint paint = make_paint(mesh);
  CHECK(SMC::painted_weights(mesh, weights, paint));
  for(const Edge e : mesh.edges())
    CHECK(are_close(factor(mesh, weights, e),
                    mesh.is_border(e) ? 1 : (paint[mesh.vertex(e, 0)] + paint[mesh.vertex(e, 1)]) / 2));
  CHECK(SMC::painted_weights(mesh, weights, CGAL::Constant_property_map<Vertex, double>(3)));
  for(const Edge e : mesh.edges())
    CHECK(are_close(factor(mesh, weights, e), mesh.is_border(e) ? 1 : 3));

  for(const double bad : {-1., not_a_number, infinity})
  {
    const Weights untouched = make_weights(mesh);
    paint[Vertex(11)] = bad;
    const SMC::Result_status<Mesh> status = SMC::painted_weights(mesh, untouched, paint);
    CHECK(status.code == Status_code::WRONG_PARAMETER && status.vertices == std::vector<Vertex>(1, Vertex(11)));
    for(const Edge e : mesh.edges())
      CHECK(untouched[e] == -1);
  }
}

// Each function multiplies what the one before has left, in any order.
void test_products()
{
  Mesh mesh = test::make_mesh<Mesh>(cup());
  const Weights crease = make_weights(mesh), painted = make_weights(mesh), visible = make_weights(mesh),
                straight = make_weights(mesh), product = make_weights(mesh), other = make_weights(mesh);
  const Paint paint = make_paint(mesh);
  CHECK(SMC::crease_weights(mesh, crease, parameters::smallest_factor(0.3)));
  CHECK(SMC::painted_weights(mesh, painted, paint));
  CHECK(SMC::visibility_weights(mesh, visible, parameters::number_of_rays(16).smallest_factor(0.4)));
  CHECK(SMC::straightness_weights(mesh, straight, parameters::smallest_factor(0.5)));

  CHECK(SMC::crease_weights(mesh, product, parameters::smallest_factor(0.3)));
  CHECK(SMC::visibility_weights(mesh, product, parameters::edge_weight_map(product).number_of_rays(16).smallest_factor(0.4)));
  CHECK(SMC::painted_weights(mesh, product, paint, parameters::edge_weight_map(product)));
  CHECK(SMC::straightness_weights(mesh, product, parameters::edge_weight_map(product).smallest_factor(0.5)));
  CHECK(SMC::painted_weights(mesh, other, paint));
  CHECK(SMC::straightness_weights(mesh, other, parameters::edge_weight_map(other).smallest_factor(0.5)));
  CHECK(SMC::crease_weights(mesh, other, parameters::edge_weight_map(other).smallest_factor(0.3)));
  CHECK(SMC::visibility_weights(mesh, other, parameters::edge_weight_map(other).number_of_rays(16).smallest_factor(0.4)));
  for(const Edge e : mesh.edges())
  {
    const double l = length(mesh, e);
    CHECK(are_close(product[e], l * (crease[e] / l) * (painted[e] / l) * (visible[e] / l) * (straight[e] / l)));
    CHECK(are_close(product[e], other[e]));
  }
}

// An edge that must not be cut stays one, and none becomes one.
void test_extreme_products()
{
  Mesh mesh = test::make_mesh<Mesh>(test::sphere(5, 3));
  const Weights weights = make_weights(mesh);
  for(const double value : {0., 1e308})
  {
    for(const Edge e : mesh.edges())
      weights[e] = int(e) % 2 == 0 ? infinity : 1e307;
    CHECK(SMC::painted_weights(mesh, weights, CGAL::Constant_property_map<Vertex, double>(value),
                               parameters::edge_weight_map(weights)));
    for(const Edge e : mesh.edges())
      CHECK(std::isinf(weights[e]) == (int(e) % 2 == 0) && (weights[e] > 0 || value == 0));
  }
}

void test_refused()
{
  Mesh mesh = test::make_mesh<Mesh>(cup()), empty;
  const Weights weights = make_weights(mesh);
  const auto code = [](const SMC::Result_status<Mesh>& status) { return status.code; };
  const auto look = [&](const auto& np) { return code(SMC::visibility_weights(mesh, weights, np.number_of_rays(4))); };
  for(const double value : {-0.1, 1.1, not_a_number})
  {
    CHECK(code(SMC::crease_weights(mesh, weights, parameters::smallest_convex_factor(value)))
          == Status_code::WRONG_PARAMETER);
    CHECK(code(SMC::straightness_weights(mesh, weights, parameters::smallest_factor(value))) == Status_code::WRONG_PARAMETER);
  }
  for(const double value : {0., not_a_number, infinity})
    CHECK(look(parameters::up_direction(Kernel::Vector_3(0, value, 0))) == Status_code::WRONG_PARAMETER);
  for(const double value : {0., -1., not_a_number})
    CHECK(look(parameters::occlusion_radius(value)) == Status_code::WRONG_PARAMETER);
  CHECK(look(parameters::maximum_running_time(-1.)) == Status_code::STOPPED);
  for(const Edge e : mesh.edges())
    CHECK(weights[e] == -1);
  CHECK(look(parameters::up_direction(Kernel::Vector_3(0, 1e-300, 0)).occlusion_radius(infinity)) == Status_code::OK);
  CHECK(code(SMC::straightness_weights(empty, make_weights(empty))) == Status_code::EMPTY_MESH);
  CHECK(code(SMC::painted_weights(empty, make_weights(empty), make_paint(empty))) == Status_code::EMPTY_MESH);
}

// Numbers and vectors of an exact kernel.
void test_exact_kernel()
{
  const test::Polyhedron mesh = test::make_mesh<test::Polyhedron>(test::sphere(6, 3));
  const auto weights = get(CGAL::dynamic_edge_property_t<double>(), mesh);
  CHECK(SMC::straightness_weights(mesh, weights));
  CHECK(SMC::visibility_weights(mesh, weights, parameters::number_of_rays(4)
                                                 .up_direction(test::Exact_kernel::Vector_3(0, 0, 1))
                                                 .edge_weight_map(weights)));
  for(auto e : edges(mesh))
    CHECK(get(weights, e) > 0);
}

} // namespace weight_factors_test

int main()
{
  using namespace weight_factors_test;
  test_concave_creases();
  test_sky();
  test_occlusion();
  for(const double stretch : {1., 2., 0.4})
    test_straightness(stretch, 1);
  for(const double scale : {1e-200, 1e200})
    test_straightness(1, scale);
  test_without_directions();
  test_paint();
  test_products();
  test_extreme_products();
  test_refused();
  test_exact_kernel();
  return test::exit_status();
}
