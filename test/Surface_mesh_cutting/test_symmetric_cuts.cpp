// Cuts of symmetric surfaces: mirrored exactly, valid, and not much longer than others; as usual where there is no symmetry.

#include "../BGL/check.h"
#include "symmetric_figures.h"
#include "valid_unwrap.h"

#include <CGAL/Surface_mesh_cutting/reflection_symmetry.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include <CGAL/Random.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <string>

namespace symmetric_cuts_test {

namespace SMC = CGAL::Surface_mesh_cutting;
using test::Diagonals;
using test::Soup;
using test::Surface_mesh;
using Vertex = Surface_mesh::Vertex_index;
using Edge = Surface_mesh::Edge_index;
using Result = SMC::Unwrap_result<Surface_mesh>;

struct Unwrapped
{
  Surface_mesh mesh;
  Surface_mesh::Property_map<Edge, bool> is_cut, must_be_cut;
  Surface_mesh::Property_map<Surface_mesh::Halfedge_index, test::Point_2> uv;
  Result result;

  explicit Unwrapped(const Soup& soup) : mesh(test::make_mesh<Surface_mesh>(soup))
  {
    is_cut = mesh.add_property_map<Edge, bool>("e:is_cut", false).first;
    must_be_cut = mesh.add_property_map<Edge, bool>("e:must", false).first;
    uv = mesh.add_property_map<Surface_mesh::Halfedge_index, test::Point_2>("h:uv").first;
  }

  void run(SMC::Symmetry symmetry, bool do_bijective = true, double bound = std::numeric_limits<double>::infinity())
  {
    result = SMC::unwrap(mesh, is_cut, uv, CGAL::parameters::symmetry(symmetry).do_bijective(do_bijective)
                                             .maximum_average_distortion(bound).edge_is_constrained_map(must_be_cut));
  }

  // Whether each edge of the cut has one as its image.
  bool is_symmetric(SMC::Symmetry symmetry = SMC::Symmetry::AUTOMATIC) const
  {
    const auto images = SMC::reflection_symmetry(mesh, CGAL::parameters::symmetry(symmetry)).images;
    for(const Edge e : mesh.edges())
      if(is_cut[e])
      {
        const auto image = mesh.halfedge(images[mesh.vertex(e, 0)], images[mesh.vertex(e, 1)]);
        if(!image.is_valid() || !is_cut[mesh.edge(image)])
          return false;
      }
    return true;
  }

  bool has_warning(const std::string& text) const
  {
    for(const auto& warning : result.status.warnings)
      if(warning.message.find(text) != std::string::npos)
        return true;
    return false;
  }
};

void test_figure(CGAL::Random& random, double noise, bool do_bijective, double bound)
{
  Soup soup = test::figure(16, 12, Diagonals::MIRRORED);
  test::add_noise(noise, random, soup);
  test::move(Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix(), 3, {4, 5, 6}, soup);
  test::renumber(random, soup);
  Unwrapped symmetric(soup), usual(soup);
  symmetric.run(SMC::Symmetry::AUTOMATIC, do_bijective, bound);
  usual.run(SMC::Symmetry::NONE, do_bijective, bound);
  CHECK(symmetric.result.status && symmetric.result.symmetry && symmetric.result.symmetry->is_exact);
  CHECK(symmetric.is_symmetric() && test::is_valid_unwrap(symmetric.mesh, symmetric.is_cut, symmetric.uv));
  CHECK(symmetric.result.average_distortion <= bound);
  CHECK(!usual.result.symmetry && !usual.is_symmetric());
  CHECK(symmetric.result.cut_length < 1.5 * usual.result.cut_length);
  if(do_bijective)
    CHECK(symmetric.result.overlaps && *symmetric.result.overlaps == 0);
  std::cout << "length " << symmetric.result.cut_length << ", without symmetry " << usual.result.cut_length << ", energies "
            << symmetric.result.average_distortion << " " << usual.result.average_distortion << "\n";
}

// An edge that must be cut is cut on both sides.
void test_constraint()
{
  Unwrapped figure(test::figure(12, 8, Diagonals::MIRRORED));
  Edge given;
  for(const Edge e : figure.mesh.edges())
    if(figure.mesh.point(figure.mesh.vertex(e, 0)).y() > 1.5)
      given = e;
  figure.must_be_cut[given] = true;
  figure.run(SMC::Symmetry::Y);
  CHECK(figure.result.status && figure.is_cut[given] && figure.is_symmetric());
}

// The diagonals of quadrangles, which are not cut, may lie as they do.
void test_quadrangles()
{
  Unwrapped figure(test::figure(12, 8, Diagonals::NONE));
  figure.run(SMC::Symmetry::AUTOMATIC);
  CHECK(figure.result.status && figure.result.symmetry->is_exact && figure.is_symmetric());
}

// A ring has a hole in each half.
void test_ring()
{
  Soup ring;
  const int m = 16, n = 8; // faces mirrored at y = 0
  for(int i = 0; i < m; ++i)
    for(int j = 0; j < n; ++j)
    {
      const double a = 2 * CGAL_PI * i / m, b = 2 * CGAL_PI * j / n, r = 3 + std::cos(b) + (i % m == 0 ? 0.5 : 0);
      ring.points.push_back({r * std::cos(a), 2 * i == m || i == 0 ? 0 : r * std::sin(a), std::sin(b)});
    }
  for(int i = 0; i < m; ++i)
    for(int j = 0; j < n; ++j)
    {
      const std::size_t a = std::size_t(i * n + j), b = std::size_t((i + 1) % m * n + j);
      const std::size_t c = std::size_t((i + 1) % m * n + (j + 1) % n), d = std::size_t(i * n + (j + 1) % n);
      ring.faces.push_back({a, b, c, d});
    }
  Unwrapped figure(ring);
  figure.run(SMC::Symmetry::Y);
  CHECK(figure.result.status && figure.result.symmetry && figure.result.symmetry->is_exact);
  CHECK(figure.is_symmetric(SMC::Symmetry::Y));
  CHECK(figure.result.genus == 1);
}

void test_no_symmetry()
{
  Unwrapped other(test::figure(16, 12, Diagonals::MIRRORED, false));
  other.run(SMC::Symmetry::AUTOMATIC);
  CHECK(other.result.status && !other.result.symmetry && other.has_warning("98 % are needed"));
  // One face is divided.
  Soup soup = test::figure(16, 12, Diagonals::MIRRORED);
  const auto face = soup.faces.back();
  soup.points.push_back({{0, 0, 0}});
  for(std::size_t i = 0; i < 3; ++i)
  {
    for(const std::size_t v : face)
      soup.points.back()[i] += soup.points[v][i] / 3;
    soup.faces.push_back({face[i], face[(i + 1) % 3], soup.points.size() - 1});
  }
  soup.faces.erase(soup.faces.end() - 4);
  Unwrapped shape(soup);
  shape.run(SMC::Symmetry::AUTOMATIC);
  CHECK(shape.result.status && shape.result.symmetry && !shape.result.symmetry->is_exact);
  CHECK(shape.has_warning("edges are not mirrored"));
  // All planes of a box divide its faces.
  Soup box;
  for(int v = 0; v < 8; ++v)
    box.points.push_back({{v & 1 ? 3. : 0., v & 2 ? 2. : 0., v & 4 ? 1. : 0.}});
  box.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  Unwrapped across(box);
  across.run(SMC::Symmetry::AUTOMATIC);
  CHECK(across.result.status && across.result.symmetry && across.result.symmetry->is_exact);
  CHECK(across.has_warning("crosses faces"));
}

// Vertices of quadrangles are mirrored, their diagonals are not: those are not cut.
void test_other_diagonals()
{
  Unwrapped figure(test::figure(16, 12, Diagonals::PARALLEL));
  figure.run(SMC::Symmetry::AUTOMATIC);
  CHECK(figure.result.status && figure.result.symmetry && figure.result.symmetry->is_exact && figure.is_symmetric());
}

} // namespace symmetric_cuts_test

int main(int argc, char** argv)
{
  using namespace symmetric_cuts_test;
  CGAL::Random random(argc > 1 ? unsigned(std::atoi(argv[1])) : 1);
  std::cout << "seed " << random.get_seed() << "\n";
  const double infinity = std::numeric_limits<double>::infinity();
  test_figure(random, 0, true, infinity);
  test_figure(random, 0, false, 4.15);
  test_figure(random, 0.002, true, 4.15);
  test_constraint();
  test_quadrangles();
  test_other_diagonals();
  test_ring();
  test_no_symmetry();
  return test::exit_status();
}
