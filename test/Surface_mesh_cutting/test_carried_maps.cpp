// Maps that go from one cut to the next: an opened cut keeps them as they are, a closed one leads to the map that starting
// anew does, and no triangle flips.

#include "../BGL/check.h"
#include "star_shapes.h"

#include <CGAL/Surface_mesh_cutting/internal/context/Run_control.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/first_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Incremental_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <vector>

namespace carried_maps_test {

namespace SMC = CGAL::Surface_mesh_cutting::internal;
namespace SMP = CGAL::Surface_mesh_parameterization::internal;

constexpr double precision = 1e-8;

struct Problem
{
  const SMC::Indexed_mesh mesh;
  const std::vector<SMP::Rest_shape> shapes = SMP::rest_shapes(mesh.triangles(), mesh.points());
  const std::vector<int> path = SMC::path_to_farthest_vertex(mesh, 0, 2);
  const SMP::Solvers linear_solvers = SMP::default_solvers();
  SMC::Run_control control;

  Problem(int size, CGAL::Random& random) : mesh(test::random_star_shape(size, random)) {}

  SMC::Incremental_parameterization map() { return {mesh, shapes, SMC::Mapping_policy(linear_solvers), control}; }

  // Along the first edges of the path.
  SMC::Cut cut(std::size_t size) const
  { return SMC::make_cut(mesh, std::vector<int>(path.begin(), path.begin() + (std::min)(size, path.size()))); }

  SMC::Open_chart mapped(const SMC::Cut& cut)
  {
    SMC::Incremental_parameterization fresh = map();
    CHECK(fresh.initialize(cut, std::numeric_limits<double>::infinity(), precision), "a map from nothing");
    return fresh.state();
  }
};

SMC::Open_chart unmapped(const SMC::Indexed_mesh& mesh, const SMC::Cut& cut)
{
  SMC::Open_chart chart;
  chart.cut = cut;
  chart.chart = SMC::make_chart(mesh, cut);
  return chart;
}

void test_opened_cut(Problem& problem)
{
  const SMC::Open_chart former = problem.mapped(problem.cut(problem.path.size() / 2));
  SMC::Open_chart next = unmapped(problem.mesh, problem.cut(problem.path.size()));
  CHECK(SMC::carry_over(problem.mesh, former, next), "an opened cut has a map");
  for(int c = 0; c < 3 * problem.mesh.number_of_faces(); ++c)
    CHECK(next.uv[next.chart.source(c)] == former.uv[former.chart.source(c)], "opening moves nothing");
}

// Returns whether the map could be carried over.
bool test_closed_cut(Problem& problem, std::size_t size)
{
  const SMC::Open_chart former = problem.mapped(problem.cut(problem.path.size()));
  SMC::Open_chart next = unmapped(problem.mesh, problem.cut(size));
  const bool is_carried = SMC::carry_over(problem.mesh, former, next);
  if(is_carried)
    CHECK(SMP::count_flips(next.chart.triangles(), next.uv) == 0, "no flip is left");
  return is_carried;
}

// However the cut changes, the map is that which starting anew finds.
void test_energies(Problem& problem, CGAL::Random& random)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  SMC::Incremental_parameterization map = problem.map();
  for(int i = 0; i < 6; ++i)
  {
    const SMC::Cut cut = problem.cut(std::size_t(random.get_int(2, int(problem.path.size()) + 1)));
    CHECK(map.initialize(cut, infinity, precision), "a map from the former one");
    const double expected = problem.mapped(cut).energy;
    CHECK(map.cut() == cut && map.chart().triangles() == SMC::make_chart(problem.mesh, cut).triangles(), "the chart");
    CHECK(SMP::count_flips(map.chart().triangles(), map.uv()) == 0, "no flips");
    CHECK(std::abs(map.energy() - expected) < 1e-5 * expected, "the energy of the map from nothing");

    // A bound between is decided rightly.
    const SMC::Open_chart kept = map.state();
    CHECK(map.initialize(cut, expected * (1 + 1e-3), precision), "below the bound");
    CHECK(!map.initialize(problem.cut(1 + problem.path.size() / 3), 0.5 * SMP::Symmetric_Dirichlet_energy::ideal, precision),
          "above the bound");
    map.restore(kept);
  }
}

} // namespace carried_maps_test

int main()
{
  using namespace carried_maps_test;
  CGAL::Random random(5);
  std::cout << "seed " << random.get_seed() << std::endl;
  int carried = 0, trials = 0;
  for(int i = 0; i < 12; ++i)
  {
    Problem problem(i % 3 == 0 ? 24 : 14, random);
    test_opened_cut(problem);
    for(std::size_t closed = 1; closed + 2 <= problem.path.size(); closed *= 2, ++trials)
      carried += test_closed_cut(problem, problem.path.size() - closed);
    test_energies(problem, random);
  }
  std::cout << carried << " of " << trials << " maps were carried over a closed cut" << std::endl;
  CHECK(carried > 0, "closed cuts have maps, too");
  return test::exit_status();
}
