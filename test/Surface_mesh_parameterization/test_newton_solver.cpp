// Newton's method: known optima, the energy never grows, no flips, fixed vertices, the callback;
// what is done between its steps, the relaxation of stars; and what it starts from, Tutte's embedding.

#include "../BGL/check.h"
#include "charts.h"

#include <CGAL/Surface_mesh_parameterization/internal/Chart_parameterizer.h>
#include <CGAL/Surface_mesh_parameterization/internal/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/exact_flips.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/triangle_energy.h>

#include <cmath>
#include <iostream>
#include <limits>

namespace newton_solver_test {

using namespace smp;
using Map = std::vector<Eigen::Vector2d>;

struct Problem
{
  Test_surface surface;
  std::vector<Rest_shape> shapes;
  std::vector<double> weights;
  Map tutte;

  explicit Problem(Test_surface s)
    : surface(std::move(s)), shapes(rest_shapes(surface.chart.triangles(), surface.points)),
      weights(area_weights(shapes))
  {
    const bool is_mapped = tutte_map(surface.chart, surface.points, surface_area(shapes), linear_solvers, tutte);
    CHECK(is_mapped);
    CHECK(count_flips(surface.chart.triangles(), tutte) == 0);
    CHECK(std::abs(chart_area(surface.chart.triangles(), tutte) - surface_area(shapes)) < 1e-12);
  }

  Newton_solver solver(const std::vector<char>& is_fixed = {}) const
  {
    return Newton_solver(surface.chart.triangles(), surface.chart.number_of_vertices(), linear_solvers, is_fixed);
  }
};

template <typename Energy>
void test_descent(const Problem& problem)
{
  Map uv = problem.tutte;
  Newton_solver solver = problem.solver();
  Newton_options options;
  options.maximum_iterations = 1;
  options.decrement = 1e-9;
  double energy = solver.energy<Energy>(problem.shapes, problem.weights, uv);
  for(int i = 0; ; ++i)
  {
    const Newton_result result
      = solver.minimize<Energy>(problem.shapes, problem.weights, uv, options);
    CHECK(result.energy <= energy && result.energy >= Energy::ideal * (1 - 1e-12));
    CHECK(result.energy == solver.energy<Energy>(problem.shapes, problem.weights, uv));
    CHECK(count_flips(problem.surface.chart.triangles(), uv) == 0);
    energy = result.energy;
    if(result.is_converged())
      break;
    CHECK(result.outcome == Newton_outcome::ITERATION_LIMIT && i < 100);
  }
  // Where it ends, the gradient vanishes.
  Newton_system system(problem.surface.chart.triangles(), int(uv.size()), {});
  system.assemble<Energy>(problem.surface.chart.triangles(), problem.shapes, problem.weights, uv,
                          0);
  CHECK(system.gradient().norm() < 1e-3 * energy);
}

// A developable surface has an isometric map.
void test_known_optimum(const Test_surface& surface)
{
  const Problem problem(surface);
  Chart_parameterizer parameterizer(surface.chart, surface.points, problem.shapes, linear_solvers);
  Newton_options options;
  options.decrement = 1e-12;
  Map uv;
  const Newton_result isometric = parameterizer.isometric_map(uv, options);
  CHECK(isometric.is_converged() && std::abs(isometric.energy - 4) < 1e-9);
  const std::vector<Triangle>& triangles = surface.chart.triangles();
  for(const Triangle& t : triangles)
    for(int k = 0; k < 3; ++k)
    {
      const int v = t[k], w = t[(k + 1) % 3];
      const double length = (surface.points[w] - surface.points[v]).norm();
      CHECK(std::abs((uv[w] - uv[v]).norm() - length) < 1e-5 * length);
    }
  const Newton_result conformal = parameterizer.conformal_map(uv, options);
  CHECK(conformal.is_converged() && std::abs(conformal.energy - 1) < 1e-9);
  CHECK(std::abs(chart_area(triangles, uv) - surface_area(problem.shapes)) < 1e-12);
  CHECK(count_flips(triangles, uv) == 0);
}

void test_fixed_vertices(const Problem& problem, CGAL::Random& random)
{
  Map uv = problem.tutte;
  std::vector<char> is_fixed(uv.size(), 0);
  for(char& f : is_fixed)
    f = random.get_int(0, 4) == 0;
  Newton_solver solver = problem.solver(is_fixed);
  const Newton_result result
    = solver.minimize<MIPS_energy>(problem.shapes, problem.weights, uv, Newton_options());
  CHECK(result.is_converged() && count_flips(problem.surface.chart.triangles(), uv) == 0);
  for(std::size_t v = 0; v < uv.size(); ++v)
    CHECK(!is_fixed[v] || uv[v] == problem.tutte[v]);

  is_fixed.assign(uv.size(), 1);
  Newton_solver idle = problem.solver(is_fixed);
  const Map before = uv;
  const Newton_result none
    = idle.minimize<MIPS_energy>(problem.shapes, problem.weights, uv, Newton_options());
  CHECK(none.is_converged() && none.iterations == 0 && uv == before);
  CHECK(none.energy == result.energy);
}

void test_callback(const Problem& problem)
{
  Map uv = problem.tutte;
  Newton_solver solver = problem.solver();
  Newton_options options;
  std::vector<Newton_state> states;
  options.stop = [&](const Newton_state& state)
  {
    states.push_back(state);
    return states.size() == 3;
  };
  const Newton_result result
    = solver.minimize<MIPS_energy>(problem.shapes, problem.weights, uv, options);
  CHECK(result.outcome == Newton_outcome::STOPPED && !result.is_converged() && states.size() == 3);
  const auto energy_of = [&](const Map& map)
  { return solver.energy<MIPS_energy>(problem.shapes, problem.weights, map); };
  CHECK(std::abs(states[0].energy - energy_of(problem.tutte)) < 1e-12 * states[0].energy);
  CHECK(states[1].energy < states[0].energy && states[2].energy < states[1].energy);
  CHECK(states[0].iteration == 1 && states[0].decrement > 0);
  // The step that was found is not taken.
  CHECK(std::abs(energy_of(uv) - result.energy) < 1e-12 * result.energy);
}

// A map with a flip is refused.
void test_invalid_start(const Problem& problem)
{
  Map uv = problem.tutte;
  for(Eigen::Vector2d& u : uv)
    u.x() = -u.x();
  Newton_solver solver = problem.solver();
  const Newton_result result
    = solver.minimize<MIPS_energy>(problem.shapes, problem.weights, uv, Newton_options());
  CHECK(result.outcome == Newton_outcome::FAILED && result.iterations == 0);
}

// A vertex that was moved to the edge of its star is moved back, little else is, and the gradient is that of the new map.
template <typename Energy>
void test_relaxation(const Problem& problem, CGAL::Random& random)
{
  const std::vector<Triangle>& triangles = problem.surface.chart.triangles();
  Map best = problem.tutte;
  Newton_solver solver = problem.solver();
  Newton_options options;
  options.decrement = 1e-9;
  solver.minimize<Energy>(problem.shapes, problem.weights, best, options);
  const auto energy_of = [&](const Map& map) { return solver.energy<Energy>(problem.shapes, problem.weights, map); };

  const Triangle& bad = triangles[random.get_int(0, int(triangles.size()))];
  Map uv = best;
  const Eigen::Vector2d middle = (uv[bad[1]] + uv[bad[2]]) / 2;
  for(double t = 0.999; uv[bad[0]] == best[bad[0]]; t *= 0.9)
  {
    uv[bad[0]] += t * (middle - uv[bad[0]]);
    if(!std::isfinite(energy_of(uv)))
      uv[bad[0]] = best[bad[0]];
  }
  const double before = energy_of(uv), threshold = 1e-6 * energy_of(best);
  const Map moved = uv;
  Newton_system system(triangles, int(uv.size()), {}), fresh = system;
  system.assemble<Energy>(triangles, problem.shapes, problem.weights, uv, 0);
  const Weighted_triangles sum{triangles, problem.shapes, problem.weights};
  const double gain = Star_relaxation(Execution::PARALLEL).relax<Energy>(sum, threshold, system, uv);
  CHECK(gain > 0.5 * (before - energy_of(best)));
  CHECK(std::abs(before - energy_of(uv) - gain) < 1e-10 * before);
  CHECK(count_flips(triangles, uv) == 0);
  fresh.assemble<Energy>(triangles, problem.shapes, problem.weights, uv, 0);
  CHECK((system.gradient() - fresh.gradient()).norm() < 1e-9 * (1 + fresh.gradient().norm()));

  Map still = moved; // where nothing is worth it
  fresh.assemble<Energy>(triangles, problem.shapes, problem.weights, still, 0);
  const double none = Star_relaxation(Execution::SEQUENTIAL)
                        .relax<Energy>(sum, std::numeric_limits<double>::infinity(), fresh, still);
  CHECK(none == 0 && still == moved);
}

} // namespace newton_solver_test

int main()
{
  using namespace newton_solver_test;
  CGAL::Random random(11);
  std::cout << "seed " << random.get_seed() << std::endl;
  for(int i = 0; i < 10; ++i)
  {
    const Problem problem(make_hills(8 + i, 17 - i, random, i % 2 == 1));
    test_descent<MIPS_energy>(problem);
    test_descent<Symmetric_Dirichlet_energy>(problem);
    test_fixed_vertices(problem, random);
    test_callback(problem);
    test_invalid_start(problem);
    test_relaxation<MIPS_energy>(problem, random);
    test_relaxation<Symmetric_Dirichlet_energy>(problem, random);
  }
  test_descent<MIPS_energy>(Problem(make_cut_sphere(8)));
  test_descent<Symmetric_Dirichlet_energy>(Problem(make_cut_sphere(8)));
  test_known_optimum(make_developable(9, 12, random));
  test_known_optimum(make_developable(20, 15, random));
  // Many holes: each is closed by a virtual vertex.
  for(int i = 0; i < 20; ++i)
    Problem(make_hills(random.get_int(5, 30), random.get_int(5, 30), random, true));
  return test::exit_status();
}
