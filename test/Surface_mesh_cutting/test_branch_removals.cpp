// Which parts of a cut are proposed to be closed, and what is remembered of those that were tried.

#include "checks.h"
#include "star_shapes.h"

#include <CGAL/Surface_mesh_cutting/internal/connection/Initial_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/first_cut.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Branch_removal_search.h>
#include <CGAL/Surface_mesh_cutting/internal/refinement/Slit_search.h>

#include <CGAL/Surface_mesh_parameterization/internal/energy/Rest_shapes.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/Simplicial_solver.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <limits>
#include <memory>
#include <vector>

namespace {

using namespace CGAL::Surface_mesh_cutting::internal;

using test::check;

constexpr double infinity = std::numeric_limits<double>::infinity();

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
    parameters.linear_solvers
      = std::make_shared<CGAL::Surface_mesh_parameterization::internal::Simplicial_solver_source>();
  }

  Incremental_parameterization map(const Cut& cut) const
  {
    Incremental_parameterization map(mesh, shapes, mapping_policy(parameters), [] { return true; });
    check(map.initialize(cut), "a map");
    return map;
  }

  // The path with a slit, and whether that leaves both ends of the path a branch of their own.
  bool with_slit(int vertex, Cut& cut) const
  {
    const Slit slit = Slit_search(mesh, constraints).slit_to(vertex, cut);
    for(int e : slit.edges)
      cut[e] = 1;
    return slit.tip >= 0 && std::count(cut.begin(), cut.end(), 1) > std::count(path.begin(), path.end(), 1) &&
           leaf_branches(mesh, cut, none).size() == 3;
  }
};

// On a closed surface, a path is one branch, which cannot be closed as a whole; parts of it can.
void test_parts_of_path(const Closed_surface& surface)
{
  const Branch_removal_search search(surface.mesh, surface.constraints);
  const double length = cut_cost(surface.constraints, surface.path);
  const Branch_removal part = search.most_expensive_part(surface.path, {}, surface.none, length / 3);
  check(part.tip >= 0 && part.cost <= length / 3 && part.new_tip == part.last && !part.edges.empty(), "a part of a path");
  check(search.most_expensive_part(surface.path, {}, surface.none, length).tip < 0, "the whole path");
}

// What a branch costs that is out of reach says nothing of another one from the same tip that ends where a slit began
// later. False if the slit to the vertex does not leave such branches.
bool test_shorter_branch(const Closed_surface& surface, int vertex)
{
  Branch_removal_search search(surface.mesh, surface.constraints);
  Cut forked = surface.path;
  if(!surface.with_slit(vertex, forked))
    return false;
  const Incremental_parameterization map = surface.map(forked);
  const auto allowed = [](double) { return 1.; };
  const Branch_removal stub = search.best(map, {}, surface.none, allowed);
  check(stub.tip >= 0 && stub.new_tip < 0, "a whole branch");
  Branch_removal longer = stub; // all of a path
  longer.last = surface.tips.front() == stub.tip ? surface.tips.back() : surface.tips.front();
  search.remember(longer, 2);
  const Branch_removal again = search.best(map, {}, surface.none, allowed);
  check(again.tip == stub.tip && again.edges == stub.edges, "another branch from the same tip was taken for this one");
  search.remember(stub, 2);
  const Branch_removal other = search.best(map, {}, surface.none, allowed);
  check(other.tip != stub.tip || other.edges.size() < stub.edges.size(), "a part that costs too much");
  return true;
}

// Whatever cannot be closed as a whole is tried in halves, down to an edge.
void test_halves(const Closed_surface& surface)
{
  Branch_removal_search search(surface.mesh, surface.constraints);
  const Incremental_parameterization map = surface.map(surface.path);
  std::vector<char> is_kept = surface.none;
  is_kept[surface.tips.front()] = 1;
  std::size_t former_size = 2 * surface.path.size(); // more than there are
  for(;;)
  {
    const Branch_removal part = search.best(map, {}, is_kept, [](double) { return 1.; });
    if(part.tip < 0)
      break;
    check(part.tip == surface.tips.back() && part.edges.size() <= (former_size + 1) / 2, "half of what was refused");
    former_size = part.edges.size();
    search.remember(part, infinity);
  }
  check(former_size == 1, "down to an edge");
}

} // namespace

int main()
{
  CGAL::Random random(5);
  std::cout << "seed " << random.get_seed() << std::endl;
  for(int i = 0; i < 4; ++i)
  {
    const Closed_surface surface(random);
    test_parts_of_path(surface);
    test_halves(surface);
    int number_of_slits = 0;
    for(int k = 0; k < 16; ++k)
      number_of_slits += test_shorter_branch(surface, random.get_int(0, surface.mesh.number_of_vertices()));
    check(number_of_slits > 0, "no slit from the path");
  }
  return test::exit_status();
}
