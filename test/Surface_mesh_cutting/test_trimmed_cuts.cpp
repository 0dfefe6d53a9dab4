// Cuts whose maps without overlaps leave some room below a bound: of a path of which a half is too much, less is closed.

#include "../BGL/check.h"
#include "star_shapes.h"

#include <CGAL/Surface_mesh_cutting/internal/detection/first_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Injective_trimmer.h>

#include <CGAL/Surface_mesh_parameterization/internal/bijective/bijective_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <memory>
#include <vector>

namespace trimmed_cuts_test {

using namespace CGAL::Surface_mesh_cutting::internal;
using CGAL::Surface_mesh_parameterization::internal::default_solvers;


// A surface, and the cut along a path on it.
struct Cut_surface
{
  const Indexed_mesh mesh;
  const Problem problem{mesh, CGAL::Surface_mesh_parameterization::internal::rest_shapes(mesh.triangles(), mesh.points()),
                        unconstrained(mesh), {}, Initial_cut(Cut(mesh.number_of_edges(), 0)), true};
  const std::vector<int> path = path_to_farthest_vertex(mesh, 0, 2);
  Cutting_parameters parameters;
  Run_control control{[] { return true; }, {}};
  Phase_clock clock;

  explicit Cut_surface(CGAL::Random& random) : mesh(test::random_star_shape(12, random))
  {
    parameters.do_bijective = true;
    parameters.linear_solvers = std::make_shared<Solvers>(default_solvers());
  }

  Context context() { return {parameters, control, clock}; }

  // Without so many edges at the front and at the back of the path.
  Injective_cut without(std::size_t front, std::size_t back)
  {
    const std::vector<int> edges(path.begin() + front, path.end() - back);
    Injective_cut result{make_cut(mesh, edges), {}, {}, {}};
    result.ends = ends_and_forks(mesh, result.cut);
    Incremental_parameterization map(mesh, problem.shapes, mapping_policy(parameters), control);
    CHECK(map.initialize(result.cut), "a map");
    result.chart = map.chart();
    result.map.energy = final_map(problem, map.state(), context(), result.map.uv).energy;
    return result;
  }

  // The less distorted one.
  double energy_without_either(std::size_t size)
  { return (std::min)(without(size, 0).map.energy, without(0, size).map.energy); }
};

void test_trimming(CGAL::Random& random)
{
  Cut_surface surface(random);
  const Injective_cut given = surface.without(0, 0);
  const std::size_t half = surface.path.size() / 2, quarter = surface.path.size() / 4;
  const double bound = (surface.energy_without_either(half) + surface.energy_without_either(quarter)) / 2;
  Injective_cut trimmed = given;
  Injective_trimmer(surface.problem, surface.context()).trim(Objective(bound, 0), trimmed);
  CHECK(cut_length(surface.mesh, trimmed.cut) < cut_length(surface.mesh, given.cut), "nothing was closed");
  CHECK(trimmed.map.energy <= bound, "the bound");
  for(int e = 0; e < surface.mesh.number_of_edges(); ++e)
    CHECK(given.cut[e] || !trimmed.cut[e], "an edge that was not cut");
  std::vector<int> ends = trimmed.ends;
  std::sort(ends.begin(), ends.end());
  CHECK(ends == ends_and_forks(surface.mesh, trimmed.cut), "the ends");
  CHECK(CGAL::Surface_mesh_parameterization::internal::is_bijective(trimmed.chart, trimmed.map.uv), "overlaps");

  // At its own energy, nothing can go.
  Injective_cut kept = given;
  Injective_trimmer(surface.problem, surface.context()).trim(Objective(given.map.energy, 0), kept);
  CHECK(kept.cut == given.cut && kept.map.energy == given.map.energy, "closed above the bound");
}

} // namespace trimmed_cuts_test

int main()
{
  using namespace trimmed_cuts_test;
  CGAL::Random random(3);
  std::cout << "seed " << random.get_seed() << std::endl;
  for(int i = 0; i < 8; ++i)
    test_trimming(random);
  return test::exit_status();
}
