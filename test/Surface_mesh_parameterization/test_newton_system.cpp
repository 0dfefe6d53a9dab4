// The sparse system against a dense assembly, with fixed vertices; the flip barrier against
// bisection.

#include "../BGL/check.h"
#include "charts.h"

#include <CGAL/Surface_mesh_parameterization/internal/chart/exact_flips.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_solver.h>

#include <Eigen/LU>

#include <cmath>
#include <iostream>
#include <limits>
#include <vector>

namespace newton_system_test {

using namespace smp;

// A flip-free map near that of the hills' shadow.
std::vector<Eigen::Vector2d> shaken_shadow(const Test_surface& surface, CGAL::Random& random)
{
  double amount = 0.05;
  while(true)
  {
    std::vector<Eigen::Vector2d> uv;
    for(const Eigen::Vector3d& p : surface.points)
    {
      const Eigen::Vector2d shift(random.get_double(-1, 1), random.get_double(-1, 1));
      uv.push_back(p.head<2>() + amount * shift);
    }
    if(count_flips(surface.chart.triangles(), uv) == 0)
      return uv;
    amount *= 0.8;
  }
}

template <typename Energy>
void test_assembly(const Test_surface& surface, CGAL::Random& random, bool has_fixed)
{
  const std::vector<Triangle>& triangles = surface.chart.triangles();
  const int n = surface.chart.number_of_vertices();
  const std::vector<Eigen::Vector2d> uv = shaken_shadow(surface, random);
  const std::vector<Rest_shape> shapes = rest_shapes(triangles, surface.points);
  const std::vector<double> weights = area_weights(shapes);
  std::vector<char> is_fixed(has_fixed ? n : 0, 0);
  for(char& f : is_fixed)
    f = random.get_int(0, 3) == 0;

  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(2 * n);
  double energy = 0;
  std::vector<char> is_used(n, 0);
  for(std::size_t f = 0; f < triangles.size(); ++f)
  {
    const Triangle& t = triangles[f];
    Triangle_terms terms;
    triangle_terms<Energy>(shapes[f], uv[t[0]], uv[t[1]], uv[t[2]], terms);
    energy += weights[f] * terms.value;
    for(int k = 0; k < 3; ++k)
    {
      const int v = 2 * t[k], w = 2 * t[(k + 1) % 3];
      is_used[t[k]] = 1;
      gradient.segment<2>(v) += weights[f] * terms.gradient[k];
      hessian.block<2, 2>(v, v) += weights[f] * terms.diagonal[k];
      hessian.block<2, 2>(v, w) += weights[f] * terms.mixed[k];
      hessian.block<2, 2>(w, v) += weights[f] * terms.mixed[k].transpose();
    }
  }

  Newton_system system(triangles, n, is_fixed);
  for(int repetition = 0; repetition < 2; ++repetition) // nothing is left over from the first
  {
    constexpr double shift = 1e-3;
    const double e = system.assemble<Energy>(triangles, shapes, weights, uv, shift);
    CHECK(std::abs(e - energy) <= 1e-13 * energy);
    const Eigen::MatrixXd found
      = Eigen::MatrixXd(system.hessian()).selfadjointView<Eigen::Upper>();
    int unknowns = 0;
    for(int v = 0; v < n; ++v)
    {
      const int p = system.unknown(v);
      CHECK((p >= 0) == (is_used[v] && !(has_fixed && is_fixed[v])));
      if(p < 0)
      {
        CHECK(system.decrement(v) == 0);
        continue;
      }
      unknowns += 2;
      const Eigen::Vector2d g = system.gradient().segment<2>(p);
      const double decrement = g.dot(Eigen::Matrix2d(found.block<2, 2>(p, p)).inverse() * g);
      CHECK(std::abs(system.decrement(v) - decrement) <= 1e-9 * (decrement + 1e-9 * energy));
      const Eigen::Vector2d difference
        = system.gradient().segment<2>(p) - gradient.segment<2>(2 * v);
      CHECK(difference.norm() <= 1e-12 * gradient.norm());
      for(int w = 0; w < n; ++w)
      {
        const int q = system.unknown(w);
        if(q < 0)
          continue;
        Eigen::Matrix2d expected = hessian.block<2, 2>(2 * v, 2 * w);
        if(v == w)
          expected.diagonal() *= 1 + shift;
        const Eigen::Matrix2d block = found.block<2, 2>(p, q);
        CHECK((block - expected).norm() <= 1e-12 * hessian.norm());
      }
    }
    CHECK(unknowns == system.number_of_unknowns());
  }
}

// The first degenerate triangle found by stepping and bisection.
void test_barrier(const Test_surface& surface, CGAL::Random& random)
{
  const std::vector<Triangle>& triangles = surface.chart.triangles();
  const std::vector<Eigen::Vector2d> uv = shaken_shadow(surface, random);
  std::vector<Eigen::Vector2d> direction;
  for(std::size_t v = 0; v < uv.size(); ++v)
    direction.emplace_back(random.get_double(-1, 1), random.get_double(-1, 1));
  const double step = step_to_first_flip(triangles, uv, direction);
  const auto is_positive = [&](double t)
  {
    std::vector<Eigen::Vector2d> moved = uv;
    for(std::size_t v = 0; v < uv.size(); ++v)
      moved[v] += t * direction[v];
    return smallest_area(triangles, moved) > 0;
  };
  double low = 0, high = 1e-3;
  while(is_positive(high))
  {
    low = high;
    high *= 1.01;
    CHECK(high < 1e3);
  }
  while(high - low > 1e-13 * high && 0.5 * (low + high) != low && 0.5 * (low + high) != high)
    (is_positive(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
  CHECK(std::abs(step - low) <= 1e-8 * low);
}

void test_roots()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(smallest_positive_root(1, 1, 1) == infinity);
  CHECK(smallest_positive_root(1, 1, 0) == infinity);
  CHECK(smallest_positive_root(1, 0, 0) == infinity);
  CHECK(smallest_positive_root(1, -1, 0) == 1);
  CHECK(smallest_positive_root(2, -3, 1) == 1);
  CHECK(smallest_positive_root(1, 0, -1) == 1);
  CHECK(smallest_positive_root(1, -2, 1) == 1);
  CHECK(std::abs(smallest_positive_root(1e-20, -1, 1) - 1e-20) < 1e-30); // no cancellation
}

} // namespace newton_system_test

int main()
{
  using namespace newton_system_test;
  CGAL::Random random(7);
  std::cout << "seed " << random.get_seed() << std::endl;
  for(int i = 0; i < 6; ++i)
  {
    const Test_surface surface = make_hills(6, 7, random, i % 2 == 1);
    test_assembly<MIPS_energy>(surface, random, i < 3);
    test_assembly<Symmetric_Dirichlet_energy>(surface, random, i >= 3);
    for(int j = 0; j < 20; ++j)
      test_barrier(surface, random);
  }
  test_roots();
  return test::exit_status();
}
