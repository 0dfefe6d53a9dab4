// Energies and the best scale of maps as they are against exact arithmetic, on surfaces with triangles of any height.

#include "../BGL/check.h"
#include "charts.h"

#include <CGAL/Surface_mesh_parameterization/internal/energy/Map_measures.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Random.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

namespace map_measures_test {

using namespace smp;
using Number = CGAL::Exact_rational;

template <typename Vector>
Number dot(const Vector& origin, const Vector& a, const Vector& b)
{
  Number sum = 0;
  for(Eigen::Index i = 0; i < origin.size(); ++i)
    sum += (Number(a[i]) - Number(origin[i])) * (Number(b[i]) - Number(origin[i]));
  return sum;
}

// The square of twice the area.
template <typename Vector>
Number squared_area(const std::vector<Vector>& p)
{
  const Number d = dot(p[0], p[1], p[2]);
  return dot(p[0], p[1], p[1]) * dot(p[0], p[2], p[2]) - d * d;
}

// The squared norm of the affine map, from the cotangents of the angles [PP93].
template <typename From, typename To>
double squared_norm(const std::vector<From>& from, const std::vector<To>& to)
{
  Number sum = 0;
  for(int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum += dot(from[i], from[j], from[k]) * dot(to[j], to[k], to[k]);
  }
  return CGAL::to_double(Number(sum / squared_area(from)));
}

// Sums over the faces that have an area.
struct Exact_measures
{
  double area = 0, stretch = 0, compression = 0, maximum = 0;

  Exact_measures(const std::vector<Triangle>& surface, const std::vector<Eigen::Vector3d>& points,
                 const std::vector<Triangle>& chart, const std::vector<Eigen::Vector2d>& uv)
  {
    for(std::size_t f = 0; f < surface.size(); ++f)
    {
      std::vector<Eigen::Vector3d> p;
      std::vector<Eigen::Vector2d> u;
      for(int k = 0; k < 3; ++k)
      {
        p.push_back(points[surface[f][k]]);
        u.push_back(uv[chart[f][k]]);
      }
      if(squared_area(p) == 0)
        continue;
      const double face_area = 0.5 * std::sqrt(CGAL::to_double(squared_area(p)));
      const double norm = squared_norm(p, u), norm_of_inverse = squared_norm(u, p);
      area += face_area;
      stretch += face_area * norm;
      compression += face_area * norm_of_inverse;
      maximum = (std::max)(maximum, norm + norm_of_inverse);
    }
  }

  double average() const { return (stretch + compression) / area; }
};

bool are_close(double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); }

// A grid of random places in the plane and in space. Some points of the surface are moved to an edge up to `height` of
// its length, which makes caps; with `height` 0, faces without area.
void test_caps(int n, double height, CGAL::Random& random)
{
  const auto jitter = [&] { return random.get_double(-0.3, 0.3) / n; };
  Test_surface grid = make_grid_surface(n, n, random,
    [&](double x, double y) { return Eigen::Vector3d(x + jitter(), y + jitter(), jitter()); },
    [](int, int) { return false; });
  std::vector<Eigen::Vector2d> uv;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
      uv.emplace_back(double(i) / n + 0.5 * jitter(), double(j) / n + 0.5 * jitter());
  const std::vector<Triangle>& triangles = grid.chart.triangles();
  std::vector<char> is_moved(grid.points.size(), 0);
  for(std::size_t t = 0; t < triangles.size(); t += 5)
  {
    const Triangle& v = triangles[t];
    if(is_moved[v[0]] || is_moved[v[1]] || is_moved[v[2]])
      continue;
    for(int k : v)
      is_moved[k] = 1;
    // Coordinates of few bits, so that a height of 0 is one.
    for(int k : {0, 1})
      for(double& x : grid.points[v[k]])
        x = std::ldexp(std::round(std::ldexp(x, 20)), -20);
    const Eigen::Vector3d &a = grid.points[v[0]], &b = grid.points[v[1]];
    const Eigen::Vector3d across = (b - a).cross(Eigen::Vector3d::UnitZ());
    grid.points[v[2]] = 0.5 * (a + b) + height * across;
  }

  const Map_measures measures(triangles, grid.points, triangles);
  const Exact_measures expected(triangles, grid.points, triangles, uv);
  const Map_measures::Energies found = measures.energies(uv);
  CHECK(are_close(found.average, expected.average()));
  CHECK(are_close(found.maximum, expected.maximum));
  CHECK(measures.has_thickened_faces() == (height < minimal_height));
  CHECK(height < minimal_height ? found.average_of_others < found.average || height == 0
                                : found.average_of_others == found.average);
  const double scale = measures.best_scale(uv);
  CHECK(are_close(scale, std::pow(expected.compression / expected.stretch, 0.25)));
  std::vector<Eigen::Vector2d> scaled = uv;
  for(Eigen::Vector2d& u : scaled)
    u *= scale;
  for(double factor : {0.9, 1.1})
  {
    std::vector<Eigen::Vector2d> other = scaled;
    for(Eigen::Vector2d& u : other)
      u *= factor;
    CHECK(measures.energies(scaled).average < measures.energies(other).average);
  }
}

// The surface has no area at all.
void test_no_area()
{
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  const std::vector<Eigen::Vector3d> points = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  const std::vector<Eigen::Vector2d> uv = {{0, 0}, {1, 0}, {0, 1}};
  const Map_measures measures(triangles, points, triangles);
  CHECK(measures.best_scale(uv) == 1 && measures.has_thickened_faces());
}

} // namespace map_measures_test

int main()
{
  using namespace map_measures_test;
  CGAL::Random random(23);
  std::cout << "seed " << random.get_seed() << std::endl;
  for(int i = 0; i < 8; ++i)
    for(double height : {1e-1, 1e-3, 2e-7, 5e-8, 1e-9, 1e-11, 1e-13, 0.})
      test_caps(random.get_int(3, 12), height, random);
  test_no_area();
  return test::exit_status();
}
