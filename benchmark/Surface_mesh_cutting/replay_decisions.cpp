// Whether deciding early about the candidates decides as full convergence does, with all that the paper does.
//
//   replay_decisions FOLDER|MESH...
//
// On each closed surface of genus 0 (the first component of each mesh), the candidates are found as with `use_published_method` and
// judged one after the other. Before each, a copy of the map is converged with the candidate's slit to 1e-10; then
// the running map decides and goes on. Unlike in the method, disks around other candidates do not bend the slits. One
// line per mesh: candidates, decisions, how many were accepted, how many differ from full convergence, and the largest
// distance of a differing gain from the threshold, relative to it.

#include "mesh_files.h"

#include <CGAL/Surface_mesh_cutting/internal/surface/Indexed_component.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Incremental_parameterization.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/initial_features.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>
#include <random>
#include <string>
#include <vector>

using namespace CGAL::Surface_mesh_cutting::internal;
using namespace CGAL::Surface_mesh_parameterization::internal;
using Surface_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Adapter
  = Mesh_adapter<Surface_mesh, boost::property_map<Surface_mesh, CGAL::vertex_point_t>::const_type>;

struct Decisions
{
  int all = 0, accepted = 0, differing = 0;
  double largest_distance = 0;

  void add(double gain, double threshold, bool is_accepted)
  {
    ++all;
    accepted += is_accepted;
    if(is_accepted == (gain > threshold))
      return;
    ++differing;
    largest_distance = (std::max)(largest_distance, std::abs(gain - threshold) / threshold);
  }
};

Cutting_parameters faithful_parameters()
{
  Cutting_parameters parameters;
  parameters.use_published_method = true;
  parameters.conformal_solver = CGAL::Surface_mesh_cutting::Conformal_solver::KP_NEWTON;
  parameters.linear_solvers = std::make_shared<Solvers>(default_solvers());
  return parameters;
}

// The edges of the shortest path from the cut to the vertex; empty if it is on the cut.
std::vector<int> slit_to(const Indexed_mesh& mesh, const Cut& cut, int v)
{
  Shortest_paths paths(mesh.graph());
  for(int e = 0; e < mesh.number_of_edges(); ++e)
    if(cut[e])
    {
      paths.add_source(mesh.source(mesh.halfedge(e)));
      paths.add_source(mesh.target(mesh.halfedge(e)));
    }
  paths.run([v](int w) { return w != v; });
  std::vector<int> slit;
  paths.path(v, std::back_inserter(slit));
  return slit;
}

// What opening the slit gains, from the state of the map.
double converged_gain(const Indexed_mesh& mesh, const std::vector<Rest_shape>& shapes, const Mapping_policy& policy,
                      const Open_chart& state, const std::vector<int>& slit)
{
  Mapping_policy precise = policy;
  precise.precision = 1e-10;
  Run_control control;
  Incremental_parameterization map(mesh, shapes, precise, control);
  map.restore(state);
  map.open(slit);
  return state.energy - map.energy();
}

Decisions replay(const Indexed_mesh& mesh, const std::vector<Rest_shape>& shapes, const std::vector<Candidate>& candidates,
                 const Cutting_parameters& parameters)
{
  Decisions decisions;
  Candidate_disks disks(mesh);
  const Initial_features initial
    = initialize_features(mesh, unconstrained(mesh), candidates, parameters, disks);
  const Mapping_policy policy = mapping_policy(parameters);
  Run_control control;
  Incremental_parameterization map(mesh, shapes, policy, control);
  if(!map.initialize(make_cut(mesh, initial.cut)))
    return decisions;
  const double threshold = parameters.minimum_distortion_decrease;
  for(int v : initial.queue)
  {
    const std::vector<int> slit = slit_to(mesh, map.cut(), v);
    if(slit.empty())
      continue;
    const double gain = converged_gain(mesh, shapes, policy, map.state(), slit);
    decisions.add(gain, threshold, map.open_if_useful(slit, threshold));
  }
  return decisions;
}

void measure(const std::filesystem::path& file)
{
  Surface_mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file.string(), mesh))
    return;
  const Adapter adapter(mesh, get(CGAL::vertex_point, mesh));
  if(!adapter.status())
    return;
  const Indexed_component component = split_into_components(adapter.mesh()).front();
  if(component.topology.genus() > 0 || component.topology.border_loops > 0)
    return;
  const Indexed_mesh& surface = component.mesh;
  const Cutting_parameters parameters = faithful_parameters();
  const std::vector<Rest_shape> shapes = rest_shapes(surface.triangles(), surface.points());
  const int start = int(std::mt19937(0)() % std::mt19937::result_type(surface.number_of_vertices()));
  Run_control control;
  const std::vector<Candidate> candidates = find_candidates(surface, shapes, start, parameters, control);
  if(candidates.size() < 2)
    return;
  const Decisions d = replay(surface, shapes, candidates, parameters);
  std::cout << file.filename().string() << "," << surface.number_of_faces() << "," << candidates.size() << "," << d.all
            << "," << d.accepted << "," << d.differing << "," << d.largest_distance << std::endl;
}

int main(int argc, char** argv)
{
  std::vector<std::filesystem::path> files;
  for(int i = 1; i < argc; ++i)
    add_files(argv[i], files);
  std::cout << "file,triangles,candidates,decisions,accepted,differing,largest_distance\n";
  for(const std::filesystem::path& file : files)
    measure(file);
  return 0;
}
