// Maps rounded to few bits: what the repair calls free of flips is, exactly, and it fails rarely where there is room.

#include "../BGL/check.h"
#include "charts.h"

#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Rounding_repair.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Random.h>

#include <cmath>
#include <iostream>
#include <vector>

namespace rounding_repair_test {

using namespace smp;

int exact_flips(const std::vector<Triangle>& triangles, const std::vector<Eigen::Vector2d>& uv)
{
  using Number = CGAL::Exact_rational;
  int flips = 0;
  for(const Triangle& t : triangles)
  {
    const Number x(uv[t[0]].x()), y(uv[t[0]].y());
    flips += !((Number(uv[t[1]].x()) - x) * (Number(uv[t[2]].y()) - y)
               > (Number(uv[t[1]].y()) - y) * (Number(uv[t[2]].x()) - x));
  }
  return flips;
}

struct Counts
{
  int maps = 0, rounded_flips = 0, repaired = 0;
};

// A grid whose vertices were moved one after the other, each within its star; the smaller `distance`, the thinner may
// triangles be, in spacings of the grid.
Test_surface random_map(int n, double distance, CGAL::Random& random, std::vector<Eigen::Vector2d>& uv)
{
  Test_surface grid = make_grid_surface(n, n, random, [](double x, double y) { return Eigen::Vector3d(x, y, 0); },
                                [](int, int) { return false; });
  uv.clear();
  for(const Eigen::Vector3d& p : grid.points)
    uv.push_back(p.head<2>());
  const std::vector<Triangle>& triangles = grid.chart.triangles();
  for(std::size_t v = 0; v < uv.size(); ++v)
  {
    const Eigen::Vector2d former = uv[v];
    uv[v] += Eigen::Vector2d(random.get_double(-1, 1), random.get_double(-1, 1)) / n;
    for(const Triangle& t : triangles)
      if((t[0] == int(v) || t[1] == int(v) || t[2] == int(v)) &&
         doubled_area(uv[t[0]], uv[t[1]], uv[t[2]]) < distance / (n * n))
      {
        uv[v] = former;
        break;
      }
  }
  return grid;
}

// The rounding keeps multiples of `step` spacings of the grid; with `has_fixed`, some vertices are neither rounded nor
// moved.
void test_grid(double step, bool has_fixed, CGAL::Random& random, Counts& counts)
{
  const int n = random.get_int(4, 16);
  const double unit = step / n;
  const auto round = [unit](const Eigen::Vector2d& u)
  { return Eigen::Vector2d(unit * std::round(u.x() / unit), unit * std::round(u.y() / unit)); };
  std::vector<Eigen::Vector2d> uv;
  const Test_surface surface = random_map(n, 0.001, random, uv);
  const std::vector<Triangle>& triangles = surface.chart.triangles();
  CHECK(exact_flips(triangles, uv) == 0);

  const int number_of_vertices = int(uv.size());
  const int number_of_rounded = has_fixed ? number_of_vertices - n : number_of_vertices;
  std::vector<char> is_fixed;
  if(has_fixed)
  {
    is_fixed.assign(number_of_rounded, 0);
    is_fixed.resize(number_of_vertices, 1);
  }
  std::vector<Eigen::Vector2d> naive = uv, result = uv;
  for(int v = 0; v < number_of_rounded; ++v)
    naive[v] = round(uv[v]);
  const bool is_repaired = Rounding_repair(triangles, number_of_vertices, round, number_of_rounded, is_fixed)(result);
  CHECK(is_repaired == (exact_flips(triangles, result) == 0));
  CHECK(exact_flips(triangles, naive) > 0 || result == naive);
  for(int v = 0; v < number_of_vertices; ++v)
    CHECK(v < number_of_rounded ? round(result[v]) == result[v] : result[v] == uv[v]);
  ++counts.maps;
  counts.rounded_flips += exact_flips(triangles, naive) > 0;
  counts.repaired += exact_flips(triangles, naive) > 0 && is_repaired;
}

// Nothing can be repaired where all is rounded to one point.
void test_hopeless(CGAL::Random& random)
{
  std::vector<Eigen::Vector2d> uv;
  const Test_surface surface = random_map(4, 0.01, random, uv);
  const auto round = [](const Eigen::Vector2d&) { return Eigen::Vector2d(1, 1); };
  CHECK(!Rounding_repair(surface.chart.triangles(), int(uv.size()), round, int(uv.size()), {})(uv));
}

} // namespace rounding_repair_test

int main()
{
  using namespace rounding_repair_test;
  CGAL::Random random(31);
  std::cout << "seed " << random.get_seed() << std::endl;
  for(bool has_fixed : {false, true})
    for(double step : {0x1p-2, 0x1p-3, 0x1p-4, 0x1p-6})
    {
      Counts counts;
      for(int i = 0; i < 100; ++i)
        test_grid(step, has_fixed, random, counts);
      std::cout << "step " << step << ": " << counts.rounded_flips << " of " << counts.maps << " maps flip, "
                << counts.repaired << " of them repaired" << std::endl;
      CHECK(counts.rounded_flips > 0);
      CHECK(counts.repaired >= (step > 0x1p-3 ? 0.8 : 0.97) * counts.rounded_flips);
    }
  test_hopeless(random);
  return test::exit_status();
}
