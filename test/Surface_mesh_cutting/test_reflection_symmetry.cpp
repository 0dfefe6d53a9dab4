// Planes of symmetry: of figures made by code, moved, renumbered, with noise, and with other triangulations; none of a figure
// without symmetry; several of a box.

#include "../BGL/check.h"
#include "surface_meshes.h"
#include "symmetric_figures.h"

#include <CGAL/Surface_mesh_cutting/reflection_symmetry.h>

#include <CGAL/Random.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

namespace reflection_symmetry_test {

namespace SMC = CGAL::Surface_mesh_cutting;
using test::Diagonals;
using test::Soup;
using test::Surface_mesh;
using Result = SMC::Reflection_symmetry<Surface_mesh>;
using Vector = Eigen::Vector3d;

double degrees_between(const SMC::Reflection_plane& plane, const Vector& normal)
{
  const Vector n(plane.normal[0], plane.normal[1], plane.normal[2]);
  return std::atan2(n.cross(normal).norm(), std::abs(n.dot(normal))) * 180 / CGAL_PI;
}

// A figure of the size of about 5, of which it knows the plane.
struct Moved
{
  Soup soup;
  Vector normal = Vector::UnitY();
  double scale = 1;
  Vector shift = Vector::Zero();

  Moved(Soup figure, CGAL::Random& random) : soup(std::move(figure))
  {
    const Eigen::Matrix3d rotation = Eigen::Quaterniond(random.get_double(-1, 1), random.get_double(-1, 1),
                                                        random.get_double(-1, 1), random.get_double(-1, 1))
                                       .normalized().toRotationMatrix();
    scale = std::exp(random.get_double(-5, 5));
    shift = scale * Vector(random.get_double(-9, 9), random.get_double(-9, 9), random.get_double(-9, 9));
    test::move(rotation, scale, shift, soup);
    test::renumber(random, soup);
    normal = rotation * normal;
  }

  bool is_at(const SMC::Reflection_plane& plane, double degrees, double distance) const
  {
    const Vector n(plane.normal[0], plane.normal[1], plane.normal[2]);
    return degrees_between(plane, normal) < degrees && std::abs(n.norm() - 1) < 1e-12 &&
           std::abs(n.dot(shift) - plane.offset) < distance * scale;
  }
};

// Whether the images are an involution that maps edges to edges.
bool is_involution(const Surface_mesh& mesh, const Result& r)
{
  for(const auto v : mesh.vertices())
    if(r.images[v] == Surface_mesh::null_vertex() || r.images[r.images[v]] != v)
      return false;
  return std::all_of(mesh.edges_begin(), mesh.edges_end(), [&](Surface_mesh::Edge_index e)
                     { return mesh.halfedge(r.images[mesh.vertex(e, 0)], r.images[mesh.vertex(e, 1)]).is_valid(); });
}

void test_exact(CGAL::Random& random)
{
  for(const Diagonals diagonals : {Diagonals::MIRRORED, Diagonals::NONE})
  {
    const Moved figure(test::figure(16, 12, diagonals), random);
    const Surface_mesh mesh = test::make_mesh<Surface_mesh>(figure.soup);
    const Result r = SMC::reflection_symmetry(mesh);
    CHECK(r.status && r && r.planes.size() == 1);
    CHECK(figure.is_at(r.planes.front(), 1e-5, 1e-6));
    CHECK(r.planes.front().is_exact && r.planes.front().matched == 1 && r.largest_match == 1);
    CHECK(is_involution(mesh, r));
  }
}

// The edges tell, though no vertex is in its place.
void test_noise(CGAL::Random& random)
{
  Moved figure(test::figure(16, 12, Diagonals::MIRRORED), random);
  test::add_noise(0.002 * figure.scale, random, figure.soup);
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(figure.soup);
  const Result r = SMC::reflection_symmetry(mesh);
  CHECK(r && r.planes.front().is_exact && figure.is_at(r.planes.front(), 0.1, 0.002));
  CHECK(is_involution(mesh, r));
}

int number_of_images(const Surface_mesh& mesh, const Result& r)
{
  return int(std::count_if(mesh.vertices_begin(), mesh.vertices_end(), [&](Surface_mesh::Vertex_index v)
                           { return r.images[v] != Surface_mesh::null_vertex() && r.images[r.images[v]] == v; }));
}

// Vertices are mirrored, the diagonals of quadrangles are not: all of them, or one.
void test_other_diagonals(CGAL::Random& random)
{
  const Moved figure(test::figure(16, 12, Diagonals::PARALLEL), random);
  Soup soup = test::figure(16, 12, Diagonals::MIRRORED);
  auto &one = soup.faces[10], &other = soup.faces[11]; // the triangles of a quadrangle
  const std::size_t d = other[2];
  other = {one[1], one[2], d};
  one = {one[0], one[1], d};
  for(const Soup& each : {figure.soup, soup})
  {
    const Surface_mesh mesh = test::make_mesh<Surface_mesh>(each);
    const Result r = SMC::reflection_symmetry(mesh);
    CHECK(r && r.planes.front().is_exact && number_of_images(mesh, r) == int(mesh.number_of_vertices()));
    CHECK(!is_involution(mesh, r)); // of edges
  }
  CHECK(figure.is_at(SMC::reflection_symmetry(test::make_mesh<Surface_mesh>(figure.soup)).planes.front(), 1e-5, 1e-6));
}

// The shape is symmetric, its vertices are not: one face is divided, and then all of one half.
void test_other_vertices(CGAL::Random& random)
{
  Soup soup = test::figure(32, 24, Diagonals::MIRRORED);
  const std::size_t number = soup.faces.size();
  std::size_t first = 10;
  for(const std::size_t last : {std::size_t(11), number / 2})
  {
    for(std::size_t f = first; f < last; ++f)
    {
      const auto face = soup.faces[f];
      std::array<double, 3> middle = {{0, 0, 0}};
      for(const std::size_t v : face)
        for(std::size_t i = 0; i < 3; ++i)
          middle[i] += soup.points[v][i] / 3;
      soup.points.push_back(middle);
      for(std::size_t i = 1; i < 3; ++i)
        soup.faces.push_back({face[i], face[(i + 1) % 3], soup.points.size() - 1});
      soup.faces[f][2] = soup.points.size() - 1;
    }
    first = last;
    const Moved figure(soup, random);
    const Surface_mesh mesh = test::make_mesh<Surface_mesh>(figure.soup);
    const Result r = SMC::reflection_symmetry(mesh);
    CHECK(r && !r.planes.front().is_exact && figure.is_at(r.planes.front(), 0.1, 0.005));
    CHECK(r.images.size() == mesh.number_of_vertices() && number_of_images(mesh, r) < int(mesh.number_of_vertices()));
    CHECK(number_of_images(mesh, r) > int(mesh.number_of_vertices()) / 2);
  }
}

void test_none(CGAL::Random& random)
{
  const Moved figure(test::figure(16, 12, Diagonals::MIRRORED, false), random);
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(figure.soup);
  const Result r = SMC::reflection_symmetry(mesh);
  CHECK(r.status && !r && r.images.empty() && r.largest_match < 0.98 && r.largest_match > 0);
}

// Axes, at a plane off the origin.
void test_axes()
{
  Soup soup = test::figure(16, 12, Diagonals::MIRRORED);
  test::move(Eigen::Matrix3d::Identity(), 1, Vector(1, 7, 3), soup);
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(soup);
  const auto at = [&](SMC::Symmetry axis) { return SMC::reflection_symmetry(mesh, CGAL::parameters::symmetry(axis)); };
  const Result y = at(SMC::Symmetry::Y);
  CHECK(y && y.planes.size() == 1 && y.planes.front().is_exact && std::abs(y.planes.front().offset - 7) < 1e-9);
  CHECK(!at(SMC::Symmetry::X) && !at(SMC::Symmetry::Z) && at(SMC::Symmetry::X).status);
  CHECK(!at(SMC::Symmetry::NONE) && at(SMC::Symmetry::NONE).largest_match == 0);
}

// A box with three different sides has three planes; the first one divides its shortest side.
void test_box()
{
  Surface_mesh mesh;
  CGAL::make_hexahedron(Surface_mesh::Point(0, 0, 0), Surface_mesh::Point(3, 0, 0), Surface_mesh::Point(3, 2, 0),
                        Surface_mesh::Point(0, 2, 0), Surface_mesh::Point(0, 2, 1), Surface_mesh::Point(0, 0, 1),
                        Surface_mesh::Point(3, 0, 1), Surface_mesh::Point(3, 2, 1), mesh);
  const Result r = SMC::reflection_symmetry(mesh);
  CHECK(r && r.planes.size() == 3);
  const Vector axes[] = {Vector::UnitZ(), Vector::UnitY(), Vector::UnitX()};
  for(std::size_t i = 0; i < r.planes.size() && i < 3; ++i)
    CHECK(r.planes[i].is_exact && degrees_between(r.planes[i], axes[i]) < 1e-6 &&
          std::abs(r.planes[i].offset - 0.5 * double(i + 1)) < 1e-9);
}

void test_two_parts(CGAL::Random& random)
{
  Soup soup = test::figure(10, 8, Diagonals::MIRRORED, false), other = soup;
  test::move(Eigen::Matrix3d::Identity(), 1, Vector(0, 6, 0), soup);
  test::move(Vector(1, -1, 1).asDiagonal(), 1, Vector(0, -6, -10), other); // `add()` shifts it back
  for(auto& face : other.faces)
    std::reverse(face.begin(), face.end());
  soup.add(other);
  const Moved pair(soup, random);
  const Surface_mesh mesh = test::make_mesh<Surface_mesh>(pair.soup);
  const Result r = SMC::reflection_symmetry(mesh);
  CHECK(r && r.planes.front().is_exact && pair.is_at(r.planes.front(), 1e-5, 1e-5) && is_involution(mesh, r));
}

void test_refusals()
{
  Surface_mesh mesh;
  CHECK(SMC::reflection_symmetry(mesh).status.code == SMC::Status_code::EMPTY_MESH);
  // No area, in which there would be a plane.
  const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0}), c = mesh.add_vertex({2, 0, 0});
  mesh.add_face(a, b, c);
  CHECK(SMC::reflection_symmetry(mesh).status && !SMC::reflection_symmetry(mesh));
}

} // namespace reflection_symmetry_test

int main(int argc, char** argv)
{
  using namespace reflection_symmetry_test;
  CGAL::Random random(argc > 1 ? unsigned(std::atoi(argv[1])) : 1);
  std::cout << "seed " << random.get_seed() << "\n";
  test_exact(random);
  test_noise(random);
  test_other_diagonals(random);
  test_other_vertices(random);
  test_none(random);
  test_axes();
  test_box();
  test_two_parts(random);
  test_refusals();
  return test::exit_status();
}
