#ifndef TEST_CHARTS_H
#define TEST_CHARTS_H

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers.h>

#include <CGAL/Random.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace smp = CGAL::Surface_mesh_parameterization::internal;

// The built-in ones.
inline const smp::Solvers linear_solvers = smp::default_solvers();

// A chart over points, for tests.
struct Test_surface
{
  smp::Corner_table chart;
  std::vector<Eigen::Vector3d> points;
};

// Edges that occur once are border.
inline smp::Corner_table make_chart(const std::vector<smp::Triangle>& triangles, int number_of_vertices)
{
  std::map<std::pair<int, int>, int> halfedges;
  for(int t = 0; t < int(triangles.size()); ++t)
    for(int k = 0; k < 3; ++k)
      halfedges[{triangles[t][k], triangles[t][(k + 1) % 3]}] = 3 * t + k;
  std::vector<int> opposites(3 * triangles.size(), -1);
  for(const auto& h : halfedges)
  {
    const auto o = halfedges.find({h.first.second, h.first.first});
    if(o != halfedges.end())
      opposites[h.second] = o->second;
  }
  return smp::Corner_table(triangles, opposites, number_of_vertices);
}

// m times n squares, each cut along one of its diagonals at random; those for which `is_hole(i, j)`
// are left out. `place(x, y)` gives the point for a position in the unit square.
template <typename Place, typename IsHole>
Test_surface make_grid_surface(int m, int n, CGAL::Random& random, const Place& place,
                       const IsHole& is_hole)
{
  std::vector<smp::Triangle> triangles;
  Test_surface surface;
  for(int i = 0; i <= m; ++i)
    for(int j = 0; j <= n; ++j)
      surface.points.push_back(place(double(i) / m, double(j) / n));
  for(int i = 0; i < m; ++i)
    for(int j = 0; j < n; ++j)
    {
      if(is_hole(i, j))
        continue;
      const int a = i * (n + 1) + j, b = a + n + 1;
      if(random.get_bool())
      {
        triangles.push_back({a, b, b + 1});
        triangles.push_back({a, b + 1, a + 1});
      }
      else
      {
        triangles.push_back({a, b, a + 1});
        triangles.push_back({a + 1, b, b + 1});
      }
    }
  surface.chart = make_chart(triangles, int(surface.points.size()));
  return surface;
}

// A hilly disk; with holes if asked for, squares that do not touch each other.
inline Test_surface make_hills(int m, int n, CGAL::Random& random, bool has_holes = false)
{
  const double p = random.get_double(3, 9), q = random.get_double(3, 9);
  const double height = random.get_double(0.1, 0.6);
  return make_grid_surface(m, n, random,
    [&](double x, double y)
    { return Eigen::Vector3d(x, y, height * std::sin(p * x) * std::cos(q * y)); },
    [&](int i, int j)
    {
      return has_holes && i % 3 == 1 && j % 3 == 1 && i + 1 < m && j + 1 < n
          && random.get_int(0, 3) == 0;
    });
}

// A strip of a cylinder: it can be unrolled without distortion.
inline Test_surface make_developable(int m, int n, CGAL::Random& random)
{
  return make_grid_surface(m, n, random,
    [](double x, double y)
    { return Eigen::Vector3d(std::cos(4 * x) / 4, std::sin(4 * x) / 4, y); },
    [](int, int) { return false; });
}

// A sphere of n rings, opened along a meridian from pole to pole.
inline Test_surface make_cut_sphere(int n)
{
  std::vector<smp::Triangle> triangles;
  Test_surface surface;
  const int m = 2 * n, south = m * n, north = south + 1;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < m; ++j)
    {
      const double z = -1 + 2 * (i + 0.5) / n, r = std::sqrt(1 - z * z);
      const double angle = 2 * EIGEN_PI * j / m;
      surface.points.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
  surface.points.emplace_back(0, 0, -1);
  surface.points.emplace_back(0, 0, 1);
  for(int j = 0; j < m; ++j)
  {
    const int k = (j + 1) % m;
    triangles.push_back({south, k, j});
    for(int i = 0; i + 1 < n; ++i)
    {
      triangles.push_back({i * m + j, i * m + k, (i + 1) * m + k});
      triangles.push_back({i * m + j, (i + 1) * m + k, (i + 1) * m + j});
    }
    triangles.push_back({(n - 1) * m + j, (n - 1) * m + k, north});
  }
  surface.chart = make_chart(triangles, int(surface.points.size()));
  std::vector<int> meridian;
  for(int h = 0; h < 3 * int(triangles.size()); ++h)
  {
    const int s = surface.chart.source(h), t = surface.chart.target(h);
    const bool is_on_meridian = (s == south && t == 0) || (t == north && s == (n - 1) * m)
                             || (s < south && t == s + m && s % m == 0);
    if(is_on_meridian)
      meridian.push_back(h);
  }
  surface.chart.open(meridian);
  for(int v = north + 1; v < surface.chart.number_of_vertices(); ++v)
  {
    const Eigen::Vector3d p = surface.points[surface.chart.origins()[v]];
    surface.points.push_back(p);
  }
  return surface;
}

#endif // TEST_CHARTS_H
