// The measures of the parameterization benchmark: by hand for one square, from the definitions for random maps, and
// what is refused.

#include "../BGL/check.h"

#include <CGAL/Surface_mesh_cutting/distortion_report.h>

#include <CGAL/boost/graph/generators.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <vector>

namespace distortion_report_test {

namespace SMC = CGAL::Surface_mesh_cutting;
using K = CGAL::Simple_cartesian<double>;
using Point_2 = K::Point_2;
using Point_3 = K::Point_3;
using Surface_mesh = CGAL::Surface_mesh<Point_3>;
using Polyhedron = CGAL::Polyhedron_3<K>;

bool is_close(double a, double b)
{
  return a == b || std::abs(a - b) <= 1e-9 * (1 + std::abs(a) + std::abs(b));
}

template <typename Mesh>
struct Map
{
  using halfedge_descriptor = typename boost::graph_traits<Mesh>::halfedge_descriptor;
  using edge_descriptor = typename boost::graph_traits<Mesh>::edge_descriptor;
  using face_descriptor = typename boost::graph_traits<Mesh>::face_descriptor;

  Mesh mesh;
  std::map<halfedge_descriptor, Point_2> uv;
  std::map<edge_descriptor, bool> is_cut;

  SMC::Distortion_report<Mesh> report()
  {
    for(const edge_descriptor e : edges(mesh))
      is_cut.emplace(e, false);
    return SMC::distortion_report(mesh, boost::make_assoc_property_map(is_cut), boost::make_assoc_property_map(uv));
  }

  template <typename Function>
  void set(Function function)
  {
    for(const halfedge_descriptor h : halfedges(mesh))
      uv[h] = function(get(CGAL::vertex_point, mesh, target(h, mesh)));
  }
};

template <typename Mesh>
void test_by_hand(double size)
{
  Map<Mesh> map;
  CGAL::make_grid(1, 1, map.mesh,
                  [size](int i, int j) { return Point_3(0, size * i, size * j); }, true);
  map.set([size](const Point_3& p) { return Point_2(2 * p.y() / size, 0.5 * p.z() / size); });
  SMC::Distortion_report<Mesh> r = map.report();
  CHECK(r);
  CHECK(is_close(r.largest_area_distortion, 0) && is_close(r.average_area_discrepancy, 0));
  CHECK(is_close(r.largest_singular_value, 2) && is_close(r.smallest_singular_value, 0.5));
  CHECK(is_close(r.largest_angle_distortion, 2.25));
  CHECK(is_close(r.average_angle_discrepancy, 2 * (std::atan(1) - std::atan(0.25))));
  CHECK(is_close(r.symmetric_Dirichlet_energy, 8.5));
  CHECK(is_close(r.resolution / size, 4)); // two units of width are one side of the square
  CHECK(r.proportion_of_flipped_faces == 0 && r.cut_length == 0);
  CHECK(r.overlaps && *r.overlaps == 0);

  map.set([size](const Point_3& p) { return Point_2(-2 * p.y() / size, 0.5 * p.z() / size); });
  r = map.report();
  CHECK(r && r.proportion_of_flipped_faces == 0 && !r.overlaps); // a reflection
  CHECK(is_close(r.symmetric_Dirichlet_energy, 8.5));

  // One triangle twice as large as the other one, on top of each other, along a cut of length sqrt(2).
  for(const auto e : edges(map.mesh))
    map.is_cut[e] = !is_border(e, map.mesh);
  double factor = std::sqrt(2.);
  for(const auto f : faces(map.mesh))
  {
    auto h = halfedge(f, map.mesh);
    const Point_3 &a = get(CGAL::vertex_point, map.mesh, source(h, map.mesh));
    const Point_3 &b = get(CGAL::vertex_point, map.mesh, target(h, map.mesh));
    const Point_3 &c = get(CGAL::vertex_point, map.mesh, target(next(h, map.mesh), map.mesh));
    const K::Vector_3 x = b - a, y = CGAL::cross_product(CGAL::cross_product(x, c - a), x);
    const double length = std::sqrt(x * x);
    map.uv[prev(h, map.mesh)] = Point_2(0, 0);
    map.uv[h] = Point_2(factor * length, 0);
    map.uv[next(h, map.mesh)] = Point_2(factor * ((c - a) * x) / length, factor * ((c - a) * (y / std::sqrt(y * y))));
    factor = 1;
  }
  r = map.report();
  CHECK(r && is_close(r.cut_length, std::sqrt(2.)));
  CHECK(r.overlaps && *r.overlaps > 0);
  CHECK(is_close(r.largest_area_distortion, 1.5 + 2 / 3. - 2 > 4 / 3. + 0.75 - 2 ? 1.5 + 2 / 3. - 2 : 4 / 3. + 0.75 - 2));
  CHECK(is_close(r.average_area_discrepancy, 1 / 3.));
  CHECK(is_close(r.largest_angle_distortion, 0) && std::abs(r.average_angle_discrepancy) < 1e-7);
}

// From the definitions, with the angles by the law of cosines.
struct Expected
{
  double area_distortion = 0, area_discrepancy = 0, smallest = std::numeric_limits<double>::infinity(), largest = 0;
  double flipped = 0, angle_distortion = 0, angle_discrepancy = 0, resolution = 0, energy = 0;
};

double angle(double opposite, double b, double c)
{
  return std::acos((std::max)(-1., (std::min)(1., (b * b + c * c - opposite * opposite) / (2 * b * c))));
}

Expected expected_measures(const std::vector<std::array<Eigen::Vector3d, 3> >& surface,
                           const std::vector<std::array<Eigen::Vector2d, 3> >& image)
{
  double area = 0, image_area = 0;
  Eigen::AlignedBox2d box;
  for(std::size_t f = 0; f < surface.size(); ++f)
  {
    area += (surface[f][1] - surface[f][0]).cross(surface[f][2] - surface[f][0]).norm() / 2;
    Eigen::Matrix2d m;
    m << image[f][1] - image[f][0], image[f][2] - image[f][0];
    image_area += std::abs(m.determinant()) / 2;
    for(const Eigen::Vector2d& p : image[f])
      box.extend(p);
  }
  Expected result;
  int flipped = 0;
  for(std::size_t f = 0; f < surface.size(); ++f)
  {
    const Eigen::Vector3d a = surface[f][1] - surface[f][0], b = surface[f][2] - surface[f][0];
    const Eigen::Vector3d x = a.normalized(), y = a.cross(b).cross(a).normalized();
    Eigen::Matrix2d rest, to;
    rest << a.dot(x), b.dot(x), a.dot(y), b.dot(y);
    to << image[f][1] - image[f][0], image[f][2] - image[f][0];
    const Eigen::Matrix2d jacobian = to * rest.inverse();
    const Eigen::Vector2d raw = Eigen::JacobiSVD<Eigen::Matrix2d>(jacobian).singularValues();
    const Eigen::Vector2d s = std::sqrt(area / image_area) * raw;
    const double share = rest.determinant() / 2 / area, image_share = std::abs(to.determinant()) / 2 / image_area;
    result.area_distortion = (std::max)(result.area_distortion, image_share / share + share / image_share - 2);
    result.area_discrepancy += std::abs(image_share - share);
    result.smallest = (std::min)(result.smallest, s[1]);
    result.largest = (std::max)(result.largest, s[0]);
    flipped += jacobian.determinant() < 0;
    result.angle_distortion = (std::max)(result.angle_distortion, s[0] / s[1] + s[1] / s[0] - 2);
    result.energy += share * (s.squaredNorm() + s.cwiseInverse().squaredNorm());
    result.resolution = (std::max)(result.resolution, box.sizes().maxCoeff() / raw[1]);
    for(int k = 0; k < 3; ++k)
    {
      const auto sides = [k](const auto& t, int i) { return (t[(k + i + 1) % 3] - t[(k + i) % 3]).norm(); };
      result.angle_discrepancy += share * std::abs(angle(sides(surface[f], 1), sides(surface[f], 0), sides(surface[f], 2))
                                                   - angle(sides(image[f], 1), sides(image[f], 0), sides(image[f], 2)));
    }
  }
  result.flipped = double((std::min)(flipped, int(surface.size()) - flipped)) / double(surface.size());
  return result;
}

template <typename Mesh>
void test_random_map(CGAL::Random& random, double size)
{
  Map<Mesh> map;
  CGAL::make_grid(5, 4, map.mesh, [&](int i, int j)
  {
    return Point_3(size * (i + random.get_double(-0.3, 0.3)), size * j, size * random.get_double());
  }, true);
  std::map<Point_3, Point_2> images;
  map.set([&](const Point_3& p)
  {
    return images.emplace(p, Point_2(p.x() / size + random.get_double(-0.4, 0.4),
                                     p.y() / size + random.get_double(-0.4, 0.4))).first->second;
  });
  std::vector<std::array<Eigen::Vector3d, 3> > surface;
  std::vector<std::array<Eigen::Vector2d, 3> > image;
  for(const auto f : faces(map.mesh))
  {
    surface.emplace_back();
    image.emplace_back();
    int k = 0;
    for(const auto h : CGAL::halfedges_around_face(halfedge(f, map.mesh), map.mesh))
    {
      const Point_3& p = get(CGAL::vertex_point, map.mesh, target(h, map.mesh));
      surface.back()[k] = Eigen::Vector3d(p.x(), p.y(), p.z()) / size;
      image.back()[k++] = Eigen::Vector2d(map.uv[h].x(), map.uv[h].y());
    }
  }
  const Expected e = expected_measures(surface, image);
  const SMC::Distortion_report<Mesh> r = map.report();
  CHECK(r);
  CHECK(is_close(r.largest_area_distortion, e.area_distortion));
  CHECK(is_close(r.average_area_discrepancy, e.area_discrepancy));
  CHECK(is_close(r.smallest_singular_value, e.smallest) && is_close(r.largest_singular_value, e.largest));
  CHECK(is_close(r.proportion_of_flipped_faces, e.flipped));
  CHECK(is_close(r.largest_angle_distortion, e.angle_distortion));
  CHECK(is_close(r.average_angle_discrepancy, e.angle_discrepancy));
  CHECK(is_close(r.resolution / size, e.resolution));
  CHECK(is_close(r.symmetric_Dirichlet_energy, e.energy));
  CHECK(r.overlaps.has_value() == std::none_of(image.begin(), image.end(), [](const auto& t)
  {
    Eigen::Matrix2d m;
    m << t[1] - t[0], t[2] - t[0];
    return m.determinant() <= 0;
  }));
}

void test_bad_maps()
{
  Map<Surface_mesh> map;
  CGAL::make_grid(2, 2, map.mesh, [](int i, int j) { return Point_3(i, j, 0); }, true);
  map.set([](const Point_3& p) { return Point_2(p.x(), p.y()); });
  const std::map<Surface_mesh::Halfedge_index, Point_2> good = map.uv;
  const Surface_mesh::Face_index face(3);
  const auto corner = map.mesh.halfedge(face);

  map.uv[corner] = Point_2(std::numeric_limits<double>::quiet_NaN(), 0);
  SMC::Distortion_report<Surface_mesh> r = map.report();
  CHECK(r.status.code == SMC::Status_code::NOT_CERTIFIED);
  CHECK(std::find(r.status.faces.begin(), r.status.faces.end(), face) != r.status.faces.end());
  map.uv = good;
  map.uv[corner] = Point_2(0.9, 0.3); // torn off
  r = map.report();
  CHECK(r.status.code == SMC::Status_code::NOT_CERTIFIED && !r.status.faces.empty());
  map.set([](const Point_3&) { return Point_2(0, 0); });
  CHECK(map.report().status.code == SMC::Status_code::NOT_CERTIFIED);

  // A face of no area on the surface does not count; one of no area in the plane is infinitely distorted.
  map.uv = good;
  const double energy = map.report().symmetric_Dirichlet_energy;
  CHECK(is_close(energy, 4));
  map.set([](const Point_3& p) { return Point_2(p.x() == 1 ? 0 : p.x(), p.y()); });
  r = map.report();
  CHECK(r && r.symmetric_Dirichlet_energy == std::numeric_limits<double>::infinity() && !r.overlaps);
  for(const auto v : map.mesh.vertices())
    if(map.mesh.point(v).x() == 1)
      map.mesh.point(v) = Point_3(0, map.mesh.point(v).y(), 0);
  r = map.report();
  CHECK(r && is_close(r.symmetric_Dirichlet_energy, 4));

  CHECK(Map<Surface_mesh>().report().status.code == SMC::Status_code::EMPTY_MESH);
}

void test_polygons()
{
  Map<Surface_mesh> map;
  CGAL::make_grid(3, 2, map.mesh, [](int i, int j) { return Point_3(i, j, 0); }, false);
  map.set([](const Point_3& p) { return Point_2(3 * p.x(), 3 * p.y()); });
  const SMC::Distortion_report<Surface_mesh> r = map.report();
  CHECK(r && is_close(r.symmetric_Dirichlet_energy, 4) && *r.overlaps == 0);
}

} // namespace distortion_report_test

int main()
{
  using namespace distortion_report_test;
  CGAL::Random random(17);
  std::cout << "seed " << random.get_seed() << std::endl;
  for(const double size : {1., 3., 1e-30, 1e30})
  {
    test_by_hand<Surface_mesh>(size);
    test_by_hand<Polyhedron>(size);
    for(int i = 0; i < 20; ++i)
      test_random_map<Surface_mesh>(random, size);
    test_random_map<Polyhedron>(random, size);
  }
  test_bad_maps();
  test_polygons();
  return test::exit_status();
}
