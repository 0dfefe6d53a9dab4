// The distortion measures against maps of known distortion and a computation from scratch.

#include "../BGL/check.h"

#include <CGAL/Surface_mesh_parameterization/distortion_measures.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Dense>

#include <cmath>
#include <limits>
#include <map>

namespace distortion_measures_test {

using K = CGAL::Simple_cartesian<double>;
using Point_2 = K::Point_2;
using Point_3 = K::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Polyhedron = CGAL::Polyhedron_3<K>;
namespace SMP = CGAL::Surface_mesh_parameterization;

bool is_close(double a, double b) { return std::abs(a - b) <= 1e-9 * (std::abs(a) + std::abs(b)); }

// A tilted plane, uneven triangles.
template <typename Mesh>
void make_plane(Mesh& mesh, CGAL::Random& random, double size)
{
  CGAL::make_grid(5, 4, mesh, [&](int i, int j) -> Point_3
  {
    const double x = i + random.get_double(-0.2, 0.2), y = j + random.get_double(-0.2, 0.2);
    return Point_3(size * (0.6 * x), size * y, size * (0.8 * x));
  }, true);
}

Eigen::Vector2d plane_coordinates(const Point_3& p) { return Eigen::Vector2d(0.6 * p.x() + 0.8 * p.z(), p.y()); }

// From the definition: the singular values of the Jacobian.
struct Energies { double mips, symmetric_dirichlet, area; };
Energies energies(const Point_3* p, const Point_2* q)
{
  const Eigen::Vector3d a(p[1].x() - p[0].x(), p[1].y() - p[0].y(), p[1].z() - p[0].z());
  const Eigen::Vector3d b(p[2].x() - p[0].x(), p[2].y() - p[0].y(), p[2].z() - p[0].z());
  const Eigen::Vector3d x = a.normalized(), y = a.cross(b).cross(a).normalized();
  Eigen::Matrix2d rest, image;
  rest << a.dot(x), b.dot(x), a.dot(y), b.dot(y);
  image << q[1].x() - q[0].x(), q[2].x() - q[0].x(), q[1].y() - q[0].y(), q[2].y() - q[0].y();
  const Eigen::Vector2d s = Eigen::JacobiSVD<Eigen::Matrix2d>(image * rest.inverse()).singularValues();
  const double squares = s.squaredNorm();
  return {squares / (2 * s[0] * s[1]), squares + 1 / (s[0] * s[0]) + 1 / (s[1] * s[1]), a.cross(b).norm() / 2};
}

template <typename Mesh>
class Test
{
  using Graph_traits = boost::graph_traits<Mesh>;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;

  const Mesh& mesh;
  std::map<halfedge_descriptor, Point_2> uv;
  std::map<face_descriptor, double> face_energy;

  template <typename Map>
  static boost::associative_property_map<Map> pmap(Map& map) { return boost::associative_property_map<Map>(map); }

  double symmetric_dirichlet()
  { return SMP::compute_symmetric_Dirichlet_energy(mesh, pmap(uv), pmap(face_energy)); }
  double mips() { return SMP::compute_MIPS_energy(mesh, pmap(uv), pmap(face_energy)); }
  double scale() { return SMP::best_isometric_scale(mesh, pmap(uv)); }

public:
  explicit Test(const Mesh& mesh) : mesh(mesh) {}

  void known_map(const Eigen::Matrix2d& m, double expected_mips, double expected_symmetric_dirichlet)
  {
    for(halfedge_descriptor h : halfedges(mesh))
    {
      const Eigen::Vector2d p = m * plane_coordinates(get(CGAL::vertex_point, mesh, target(h, mesh)));
      uv[h] = Point_2(p.x(), p.y());
    }
    CHECK(is_close(mips(), expected_mips));
    for(face_descriptor f : faces(mesh))
      CHECK(is_close(face_energy[f], expected_mips));
    CHECK(is_close(symmetric_dirichlet(), expected_symmetric_dirichlet));
    for(face_descriptor f : faces(mesh))
      CHECK(is_close(face_energy[f], expected_symmetric_dirichlet));
  }

  void known_maps()
  {
    Eigen::Matrix2d m;
    m << 0, -1, 1, 0;
    known_map(m, 1, 4);
    CHECK(is_close(scale(), 1));
    known_map(3 * m, 1, 18 + 2 / 9.);
    CHECK(is_close(scale(), 1 / 3.));
    m << 1, 0.7, 0, 1; // a shear
    known_map(m, 1 + 0.49 / 2, 4 + 2 * 0.49);
    CHECK(is_close(scale(), 1));
    m << 2, 0, 0, 0.5;
    known_map(m, (4 + 0.25) / 2, 2 * (4 + 0.25));
    m << -1, 0, 0, 1; // a reflection
    const double infinity = std::numeric_limits<double>::infinity();
    for(auto& h : uv)
      h.second = Point_2(-h.second.x(), h.second.y());
    CHECK(mips() == infinity && symmetric_dirichlet() == infinity);
  }

  void random_map(CGAL::Random& random, double size)
  {
    for(face_descriptor f : faces(mesh)) // each corner has a UV of its own
    {
      Point_2 p[3];
      do
        for(Point_2& q : p)
          q = Point_2(random.get_double(), random.get_double());
      while(CGAL::area(p[0], p[1], p[2]) < 0.05);
      int k = 0;
      for(halfedge_descriptor h : halfedges_around_face(halfedge(f, mesh), mesh))
      {
        uv[h] = Point_2(size * p[k].x(), size * p[k].y());
        ++k;
      }
    }
    std::map<face_descriptor, Energies> expected;
    double sum_mips = 0, sum_symmetric_dirichlet = 0, area = 0;
    for(face_descriptor f : faces(mesh))
    {
      Point_3 p[3];
      Point_2 q[3];
      int k = 0;
      for(halfedge_descriptor h : halfedges_around_face(halfedge(f, mesh), mesh))
      {
        const Point_3& point = get(CGAL::vertex_point, mesh, target(h, mesh));
        p[k] = Point_3(point.x() / size, point.y() / size, point.z() / size);
        q[k++] = Point_2(uv[h].x() / size, uv[h].y() / size);
      }
      expected[f] = energies(p, q);
      area += expected[f].area;
      sum_mips += expected[f].area * expected[f].mips;
      sum_symmetric_dirichlet += expected[f].area * expected[f].symmetric_dirichlet;
    }
    CHECK(is_close(mips(), sum_mips / area));
    for(face_descriptor f : faces(mesh))
      CHECK(std::abs(face_energy[f] / expected[f].mips - 1) < 1e-6);
    const double average = symmetric_dirichlet();
    CHECK(is_close(average, sum_symmetric_dirichlet / area));

    // Vertices, from the one-rings.
    std::map<vertex_descriptor, double> distortion;
    SMP::compute_vertex_distortion(mesh, pmap(face_energy), pmap(distortion));
    for(vertex_descriptor v : vertices(mesh))
    {
      double sum = 0, ring = 0;
      if(halfedge(v, mesh) != Graph_traits::null_halfedge())
        for(halfedge_descriptor h : halfedges_around_target(v, mesh))
          if(!is_border(h, mesh))
          {
            sum += expected[face(h, mesh)].area * face_energy[face(h, mesh)];
            ring += expected[face(h, mesh)].area;
          }
      CHECK(ring > 0 ? is_close(distortion[v], sum / ring) : distortion[v] == 0);
    }

    // No other scale is better.
    const double s = scale();
    const std::map<halfedge_descriptor, Point_2> original = uv;
    const auto energy_at = [&](double t)
    {
      for(auto& h : uv)
        h.second = Point_2(t * original.at(h.first).x(), t * original.at(h.first).y());
      return SMP::compute_symmetric_Dirichlet_energy(mesh, pmap(uv), boost::dummy_property_map());
    };
    const double best = energy_at(s);
    CHECK(best <= average * (1 + 1e-12));
    CHECK(best < energy_at(0.99 * s) && best < energy_at(1.01 * s));
  }
};

} // namespace distortion_measures_test

int main()
{
  using namespace distortion_measures_test;
  CGAL::Random random(5);
  for(double size : {1., 1e200, 1e-200})
  {
    Surface_mesh mesh;
    make_plane(mesh, random, size);
    // Removed elements and an isolated vertex.
    CGAL::Euler::remove_face(halfedge(*std::next(faces(mesh).begin(), 7), mesh), mesh);
    mesh.add_vertex(Point_3(0, 0, 0));
    CHECK(mesh.has_garbage());
    Test<Surface_mesh> test(mesh);
    test.known_maps();
    test.random_map(random, size);
  }
  Polyhedron polyhedron;
  make_plane(polyhedron, random, 1);
  Test<Polyhedron> test(polyhedron);
  test.known_maps();
  test.random_map(random, 1);
  return test::exit_status();
}
