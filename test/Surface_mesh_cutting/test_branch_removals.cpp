// Which parts of a cut are proposed to be closed, and what is remembered of those that were tried.

#include "../BGL/check.h"
#include "star_shapes.h"

#include <CGAL/Surface_mesh_cutting/internal/connection/Initial_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/first_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Branch_removal_search.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <memory>
#include <vector>

namespace branch_removals_test {

using namespace CGAL::Surface_mesh_cutting::internal;
using CGAL::Surface_mesh_parameterization::internal::default_solvers;


// A closed surface, and a path on it.
struct Closed_surface
{
  const Indexed_mesh mesh;
  const Edge_constraints constraints = unconstrained(mesh);
  const std::vector<CGAL::Surface_mesh_parameterization::internal::Rest_shape> shapes
    = CGAL::Surface_mesh_parameterization::internal::rest_shapes(mesh.triangles(), mesh.points());
  const Cut path = make_cut(mesh, path_to_farthest_vertex(mesh, 0, 2));
  const std::vector<int> tips = ends_and_forks(mesh, path);
  const std::vector<char> none = std::vector<char>(mesh.number_of_vertices(), 0);
  Cutting_parameters parameters;

  explicit Closed_surface(CGAL::Random& random) : mesh(test::random_star_shape(8, random))
  {
    parameters.linear_solvers = std::make_shared<Solvers>(default_solvers());
  }

  Incremental_parameterization map(const Cut& cut) const
  {
    Incremental_parameterization map(mesh, shapes, mapping_policy(parameters), [] { return true; });
    CHECK(map.initialize(cut), "a map");
    return map;
  }
};

// On a closed surface, a path is one branch, which cannot be closed as a whole; parts of it can.
void test_parts_of_path(const Closed_surface& surface)
{
  const Branch_removal_search search(surface.mesh, surface.constraints);
  const double length = cut_cost(surface.constraints, surface.path);
  const Branch_removal part = search.most_expensive_part(surface.path, {}, surface.none, length / 3);
  CHECK(part.tip >= 0 && part.cost <= length / 3 && part.new_tip >= 0 && !part.edges.empty(), "a part of a path");
  CHECK(search.most_expensive_part(surface.path, {}, surface.none, length).tip < 0, "the whole path");
}

// Of what costs twice as much as is allowed, half is tried, down to an edge.
void test_halves(const Closed_surface& surface)
{
  Branch_removal_search search(surface.mesh, surface.constraints);
  const Incremental_parameterization map = surface.map(surface.path);
  std::vector<char> is_kept = surface.none;
  is_kept[surface.tips.front()] = 1;
  std::size_t former_size = std::count(surface.path.begin(), surface.path.end(), 1); // all of it must stay
  for(;;)
  {
    const Branch_removal part = search.best(map, {}, is_kept, [](double) { return 1.; });
    if(part.tip < 0)
      break;
    CHECK(part.tip == surface.tips.back() && part.edges.size() <= (former_size + 1) / 2, "half of what was refused");
    former_size = part.edges.size();
    search.remember(part, 2);
  }
  CHECK(former_size == 1, "down to an edge");
}

} // namespace branch_removals_test

int main()
{
  using namespace branch_removals_test;
  CGAL::Random random(5);
  std::cout << "seed " << random.get_seed() << std::endl;
  for(int i = 0; i < 4; ++i)
  {
    const Closed_surface surface(random);
    test_parts_of_path(surface);
    test_halves(surface);
  }
  return test::exit_status();
}
