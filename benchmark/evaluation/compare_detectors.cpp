// Compares detectors of feature points (paper, Section 4.2): each detects, the points are connected in
// the same ways, and the opened surface is mapped by the same method. Prints CSV, one line per mesh,
// detector and way to connect; times are processor seconds.
//
//   compare_detectors [--detectors NAME,...] [--connect NAME,...] MESH...
//
// Detectors: seamster (the rival), candidates (ours before filtering), faithful (the paper's), ours (the
// package's default).
// Connections: mst, sph, greedy (by the minimum spanning tree), greedy_sph (by the shortest path
// heuristic), best. Default: all detectors, best.

#include "../Surface_mesh_cutting/Profiler.h"
#include "seamster.h"
#include "Surface.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_cutting/detect_feature_points.h>
#include <CGAL/Surface_mesh_cutting/internal/connection/connect_terminals.h>
#include <CGAL/Surface_mesh_cutting/internal/mapping/Incremental_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <random>
#include <sstream>

namespace Steiner = CGAL::internal::Steiner_tree;

const std::vector<std::string> all_detectors = {"seamster", "candidates", "faithful", "ours"};
const std::map<std::string, Steiner::Method> connections = {
  {"mst", Steiner::Method::metric_closure},
  {"sph", Steiner::Method::shortest_path_heuristic},
  {"greedy", Steiner::Method::greedy_auxiliary_points},
  {"greedy_sph", Steiner::Method::greedy_auxiliary_points_and_shortest_paths},
  {"best", Steiner::Method::exact}};

struct Options
{
  std::vector<std::string> detectors = all_detectors;
  std::vector<std::string> connections = {"best"};
  std::vector<std::string> meshes;
};

double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

std::vector<std::string> split(const std::string& names)
{
  std::vector<std::string> result;
  std::istringstream in(names);
  for(std::string name; std::getline(in, name, ',');)
    result.push_back(name);
  return result;
}

Options read_options(int argc, char** argv)
{
  Options options;
  for(int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if(word == "--detectors" && i + 1 < argc)
      options.detectors = split(argv[++i]);
    else if(word == "--connect" && i + 1 < argc)
      options.connections = split(argv[++i]);
    else
      options.meshes.push_back(word);
  }
  return options;
}

// From the same start as the package with its default seed.
Detection candidates(const Surface& surface)
{
  const int start = int(std::mt19937(0)() % std::mt19937::result_type(surface.mesh.number_of_vertices()));
  Internal::Cutting_parameters parameters;
  parameters.use_published_method = true;
  parameters.conformal_solver = SMC::Conformal_solver::KP_NEWTON;
  parameters.linear_solvers = std::make_shared<SMP::Solvers>(SMP::default_solvers());
  Internal::Run_control control;
  Detection detection;
  for(const Internal::Candidate& c
      : Internal::find_candidates(surface.mesh, surface.shapes, start, parameters, control))
    detection.features.push_back(c.vertex);
  return detection;
}

Detection detect_by_package(const Mesh& mesh, bool is_faithful)
{
  Profiler profiler;
  std::vector<Mesh::Vertex_index> vertices;
  const auto result = SMC::detect_feature_points(mesh, std::back_inserter(vertices),
                                                 CGAL::parameters::use_published_method(is_faithful)
                                                   .visitor(std::ref(profiler)));
  Detection detection;
  detection.failure = result.status.message;
  detection.filter_seconds = profiler.profile.cpu_seconds.filter;
  for(Mesh::Vertex_index v : vertices)
    detection.features.push_back(int(v));
  return detection;
}

Detection detect(const std::string& detector, const Mesh& mesh, const Surface& surface)
{
  const double start = cpu_seconds();
  Detection detection = detector == "seamster"   ? Seamster(surface)()
                      : detector == "candidates" ? candidates(surface)
                                                 : detect_by_package(mesh, detector == "faithful");
  detection.seconds = cpu_seconds() - start - detection.filter_seconds;
  if(detection.failure.empty() && detection.features.empty())
    detection.failure = "no features";
  else if(detection.features.size() == 1) // a cut needs two ends
  {
    Internal::Shortest_paths paths(surface.mesh.graph());
    detection.features.push_back(Internal::farthest_vertex(surface.mesh, paths, detection.features.front(), {}));
  }
  return detection;
}

// Connects, maps, and prints the rest of the line.
void evaluate(const Surface& surface, const std::vector<int>& features, const std::string& connection)
{
  const Internal::Indexed_mesh& mesh = surface.mesh;
  const double diagonal = Internal::bounding_box_diagonal(mesh), start = cpu_seconds();
  Steiner::Options options;
  options.method = connections.at(connection);
  options.minimum_length_decrease = 0.01 * diagonal; // Table 1
  const Internal::Connected_cut connected = Internal::connect_terminals(
    mesh, Internal::unconstrained(mesh), features, options, CGAL::internal::Graph_kernel::Execution::SEQUENTIAL,
    [] { return true; });
  const double connect_seconds = cpu_seconds() - start;
  Internal::Run_control control;
  const SMP::Solvers linear_solvers = SMP::default_solvers();
  Internal::Incremental_parameterization map(mesh, surface.shapes, Internal::Mapping_policy(linear_solvers), control);
  const bool is_mapped = connected.has_cut() && map.initialize(connected.cut);
  std::cout << (is_mapped ? "done" : "no map") << ',' << connected.number_of_auxiliary_points << ','
            << Internal::cut_length(mesh, connected.cut) / diagonal << ',' << map.energy() << ',' << connect_seconds
            << std::endl;
}

void compare(const std::string& file, const Options& options)
{
  const std::string name = std::filesystem::path(file).filename().string();
  Mesh mesh;
  Surface surface;
  const std::string obstacle = CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh)
                             ? make_surface(mesh, surface) : "unreadable";
  if(!obstacle.empty())
  {
    std::cout << name << ",0,none,0,0,0,none,\"" << obstacle << "\",0,0,0,0" << std::endl;
    return;
  }
  for(const std::string& detector : options.detectors)
  {
    const Detection detection = detect(detector, mesh, surface);
    for(const std::string& connection : options.connections)
    {
      std::cout << name << ',' << surface.mesh.number_of_faces() << ',' << detector << ','
                << detection.features.size() << ',' << detection.seconds << ',' << detection.filter_seconds << ',' << connection << ',';
      if(detection.failure.empty())
        evaluate(surface, detection.features, connection);
      else
        std::cout << '"' << detection.failure << "\",0,0,0,0" << std::endl;
    }
  }
}

int refuse(const std::string& name)
{
  std::cerr << "unknown detector or connection: " << name << std::endl;
  return EXIT_FAILURE;
}

int main(int argc, char** argv)
{
  const Options options = read_options(argc, argv);
  for(const std::string& name : options.detectors)
    if(std::find(all_detectors.begin(), all_detectors.end(), name) == all_detectors.end())
      return refuse(name);
  for(const std::string& name : options.connections)
    if(connections.count(name) == 0)
      return refuse(name);
  std::cout << "mesh,faces,detector,features,detect_seconds,filter_seconds,connection,status,branches,L,E,connect_seconds"
            << std::endl;
  for(const std::string& file : options.meshes)
    compare(file, options);
  return EXIT_SUCCESS;
}
