// The spectral conformal map of flat and developable surfaces is a similarity; damaged maps are
// repaired.

#include "../BGL/check.h"
#include "charts.h"

#include <CGAL/Surface_mesh_parameterization/internal/Spectral_conformal_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/hierarchical_map.h>

#include <cmath>
#include <iostream>
#include <vector>

namespace spectral_conformal_map_test {

using namespace smp;
using Map = std::vector<Eigen::Vector2d>;

double conformal_energy(const Test_surface& surface, const std::vector<Rest_shape>& shapes, Map& uv)
{
  int flips = -1;
  const bool is_mapped = spectral_conformal_map(surface.chart, shapes, linear_solvers, uv, &flips);
  CHECK(is_mapped && flips == count_flips(surface.chart.triangles(), uv));
  CHECK(std::abs(chart_area(surface.chart.triangles(), uv) - surface_area(shapes)) < 1e-10);
  return area_average(shapes, face_energies<MIPS_energy>(shapes, surface.chart.triangles(), uv));
}

void test_developable(const Test_surface& surface)
{
  const std::vector<Rest_shape> shapes = rest_shapes(surface.chart.triangles(), surface.points);
  Map uv, again;
  CHECK(conformal_energy(surface, shapes, uv) < 1 + 1e-6);
  for(const Triangle& t : surface.chart.triangles())
    for(int k = 0; k < 3; ++k)
    {
      const int v = t[k], w = t[(k + 1) % 3];
      const double length = (surface.points[w] - surface.points[v]).norm();
      CHECK(std::abs((uv[w] - uv[v]).norm() - length) < 1e-2 * length);
    }
  conformal_energy(surface, shapes, again);
  CHECK(uv == again);
}

// Vertices thrown about turn triangles over.
void test_repair(const Test_surface& surface, CGAL::Random& random)
{
  const std::vector<Triangle>& triangles = surface.chart.triangles();
  const std::vector<Rest_shape> shapes = rest_shapes(triangles, surface.points);
  Map uv;
  const bool is_mapped = tutte_map(surface.chart, surface.points, surface_area(shapes), linear_solvers, uv);
  CHECK(is_mapped);
  const Map valid = uv;
  bool is_repaired = remove_flips(surface.chart, surface.points, uv);
  CHECK(is_repaired && uv == valid); // nothing to do

  for(std::size_t v = 0; v < uv.size(); ++v)
    if(random.get_int(0, 30) == 0)
      uv[v] += 0.1 * Eigen::Vector2d(random.get_double(-1, 1), random.get_double(-1, 1));
  CHECK(count_flips(triangles, uv) > 0);
  is_repaired = remove_flips(surface.chart, surface.points, uv);
  CHECK(is_repaired && count_flips(triangles, uv) == 0);
  int kept = 0;
  for(std::size_t v = 0; v < uv.size(); ++v)
    kept += uv[v] == valid[v];
  CHECK(2 * kept > int(uv.size()));
}

} // namespace spectral_conformal_map_test

int main()
{
  using namespace spectral_conformal_map_test;
  CGAL::Random random(3);
  std::cout << "seed " << random.get_seed() << std::endl;
  const auto flat = [](double x, double y) { return Eigen::Vector3d(2 * x, y, 0); };
  const auto is_hole = [](int i, int j) { return i % 4 == 2 && j % 4 == 2; };
  for(int i = 0; i < 5; ++i)
  {
    test_developable(make_grid_surface(12 + i, 9, random, flat, is_hole));
    test_developable(make_developable(9 + i, 14, random));
    for(int j = 0; j < 20; ++j)
      test_repair(make_hills(20 + i, 15 + j, random), random);
  }
  const Test_surface sphere = make_cut_sphere(16);
  Map uv;
  CHECK(conformal_energy(sphere, rest_shapes(sphere.chart.triangles(), sphere.points), uv) < 1.1);
  return test::exit_status();
}
