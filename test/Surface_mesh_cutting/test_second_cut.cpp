// The paths that open a surface for the search of candidates (paper, Section 3.1.1): the one to the farthest vertex,
// and the second one, in the region far from the first, against a plain implementation.

#include "../BGL/check.h"
#include "star_shapes.h"

#include <CGAL/Surface_mesh_cutting/internal/detection/candidates.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace second_cut_test {

namespace SMC = CGAL::Surface_mesh_cutting::internal;
using test::Indexed_mesh;

// The edges of some faces.
std::vector<char> edges_of(const Indexed_mesh& mesh, const std::set<int>& faces)
{
  std::vector<char> is_edge(mesh.number_of_edges(), 0);
  for(int f : faces)
    for(int h = 3 * f; h < 3 * f + 3; ++h)
      is_edge[mesh.edge(h)] = 1;
  return is_edge;
}

// The faces outside the forbidden region, the connected part of largest area.
std::set<int> largest_part(const Indexed_mesh& mesh, const std::vector<double>& distance, double radius, double& area)
{
  std::vector<int> label(mesh.number_of_faces(), -1);
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    for(int v : mesh.triangles()[f])
      if(distance[v] >= radius)
        label[f] = f;
  for(bool has_changed = true; has_changed;)
  {
    has_changed = false;
    for(int h = 0; h < mesh.number_of_halfedges(); ++h)
    {
      const int f = h / 3, g = mesh.opposite(h) / 3;
      if(label[f] < 0 || label[g] < 0 || label[f] <= label[g])
        continue;
      label[f] = label[g];
      has_changed = true;
    }
  }
  std::vector<double> areas(mesh.number_of_faces(), 0);
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    if(label[f] >= 0)
      areas[label[f]] += mesh.face_area(f);
  const auto largest = std::max_element(areas.begin(), areas.end());
  area = *largest;
  std::set<int> part;
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    if(label[f] == largest - areas.begin())
      part.insert(f);
  return part;
}

// The region of the second cut: at the largest radius of those tried at which the part is large enough.
std::set<int> region(const Indexed_mesh& mesh, const std::vector<int>& first_cut, const std::vector<int>& maximizers,
                     const SMC::Cutting_parameters& parameters)
{
  std::set<int> centers(maximizers.begin(), maximizers.end());
  for(int e : first_cut)
    centers.insert({mesh.source(mesh.halfedge(e)), mesh.target(mesh.halfedge(e))});
  std::vector<double> distance(mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
  for(int c : centers)
  {
    const std::vector<double> from_center = test::distances_by_relaxation(mesh, c);
    for(std::size_t v = 0; v < distance.size(); ++v)
      distance[v] = (std::min)(distance[v], from_center[v]);
  }
  double whole = 0, area = 0;
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    whole += mesh.face_area(f);
  double radius = parameters.forbidden_radius * SMC::average_edge_length(mesh);
  std::set<int> part = largest_part(mesh, distance, radius, area);
  for(; area < parameters.minimum_area_ratio * whole; part = largest_part(mesh, distance, radius, area))
    radius *= 0.9;
  return part;
}

// Whether the edges form a path that starts at `start`.
bool is_path(const Indexed_mesh& mesh, const std::vector<int>& edges, int start)
{
  std::multiset<int> ends;
  for(int e : edges)
    for(int v : {mesh.source(mesh.halfedge(e)), mesh.target(mesh.halfedge(e))})
      ends.insert(v);
  int odd = 0;
  for(int v : std::set<int>(ends.begin(), ends.end()))
    odd += ends.count(v) % 2;
  return odd == 2 && ends.count(start) == 1 && std::set<int>(ends.begin(), ends.end()).size() == edges.size() + 1;
}

// One sweep, from a vertex that the random number chooses in the region, within its edges.
void check_faithful_cut(const Indexed_mesh& mesh, const std::vector<int>& path, const std::set<int>& region,
                        int random_number)
{
  const std::vector<char> is_allowed = edges_of(mesh, region);
  CHECK(std::all_of(path.begin(), path.end(), [&](int e) { return is_allowed[e]; }), "a path within the region");
  const int face = *std::next(region.begin(), random_number % int(region.size()));
  const int start = mesh.triangles()[face][0];
  const std::vector<double> distances = test::distances_by_relaxation(mesh, start, is_allowed);
  double farthest = 0;
  for(double d : distances)
    if(d < std::numeric_limits<double>::infinity())
      farthest = (std::max)(farthest, d);
  const double length = SMC::total_length(mesh, path);
  CHECK(std::abs(length - farthest) <= 1e-12 * length || (path.size() == 2 && length > farthest),
        "the farthest vertex in the region");
  CHECK(path.size() == 2 || is_path(mesh, path, start), "a path from the start");
}

void test_second_cut(CGAL::Random& random)
{
  const Indexed_mesh mesh = test::random_star_shape(random.get_int(6, 10), random);
  const std::vector<int> first = SMC::path_to_farthest_vertex(mesh, random.get_int(0, mesh.number_of_vertices()), 1);
  std::vector<int> maximizers;
  for(int i = random.get_int(0, 5); i > 0; --i)
    maximizers.push_back(random.get_int(0, mesh.number_of_vertices()));
  SMC::Cutting_parameters parameters;
  parameters.use_published_method = true;
  parameters.forbidden_radius = random.get_double(1, 12);
  parameters.minimum_area_ratio = random.get_double(0, 0.6);
  const int random_number = random.get_int(0, 1 << 30);
  SMC::Run_control control;
  const std::vector<int> path = SMC::second_cut(mesh, random_number, first, maximizers, parameters, control);
  check_faithful_cut(mesh, path, region(mesh, first, maximizers, parameters), random_number);
  CHECK(path == SMC::second_cut(mesh, random_number, first, maximizers, parameters, control), "the same twice");

  // Unless the paper is followed, a path is longer than in a tiny region.
  parameters.use_published_method = false;
  const std::vector<int> useful = SMC::second_cut(mesh, random_number, first, maximizers, parameters, control);
  CHECK(SMC::total_length(mesh, useful) >= 0.1 * SMC::total_length(mesh, first), "a path of useful length");
}

// One sweep ends at the vertex farthest from the start, in a region that may be a single face: the edge that extends a
// path of one edge is of the region, too.
void test_paths_in_regions(CGAL::Random& random)
{
  const Indexed_mesh mesh = test::random_star_shape(6, random);
  for(int i = 0; i < 50; ++i)
  {
    const int seed = random.get_int(0, mesh.number_of_faces());
    std::set<int> faces = {seed};
    for(int k = i % 3; k > 0; --k)
      for(int f : std::set<int>(faces))
        for(int h = 3 * f; h < 3 * f + 3; ++h)
          faces.insert(mesh.opposite(h) / 3);
    const int number = random.get_int(0, int(faces.size()));
    const int start = mesh.triangles()[*std::next(faces.begin(), number)][0];
    check_faithful_cut(mesh, SMC::path_to_farthest_vertex(mesh, start, 1, edges_of(mesh, faces)), faces, number);
  }
}

// Nothing may be forbidden where the part has to be the whole surface.
void test_whole_area(CGAL::Random& random)
{
  const Indexed_mesh mesh = test::random_star_shape(random.get_int(6, 16), random);
  for(bool is_faithful : {false, true})
  {
    SMC::Cutting_parameters parameters;
    parameters.use_published_method = is_faithful;
    parameters.minimum_area_ratio = 1;
    int calls = 0;
    SMC::Run_control control([&calls] { return ++calls < 10000; }, {});
    const std::vector<int> first = SMC::path_to_farthest_vertex(mesh, 0, 1);
    CHECK(!SMC::second_cut(mesh, 0, first, {}, parameters, control).empty() && !control.is_stopped(),
          "a second cut where no region is forbidden");
  }
}

} // namespace second_cut_test

int main(int argc, char** argv)
{
  using namespace second_cut_test;
  const unsigned int seed = argc > 1 ? unsigned(std::atoi(argv[1])) : 12;
  std::cout << "seed " << seed << std::endl;
  CGAL::Random random(seed);
  for(int i = 0; i < 60; ++i)
    test_second_cut(random);
  for(int i = 0; i < 10; ++i)
    test_paths_in_regions(random);
  for(int i = 0; i < 20; ++i)
    test_whole_area(random);
  return test::exit_status();
}
