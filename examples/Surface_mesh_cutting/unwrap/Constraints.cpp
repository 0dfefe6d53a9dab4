#include "Constraints.h"

#include "Stop_visitor.h"
#include "constraint_files.h"
#include "outcome.h"
#include "stop_request.h"

#include <CGAL/Surface_mesh_cutting/crease_weights.h>
#include <CGAL/Surface_mesh_cutting/visibility_weights.h>

namespace {

namespace SMC = CGAL::Surface_mesh_cutting;

Vertex find_vertex(const std::string& path, int index, const Mesh& mesh)
{
  if(index >= int(mesh.number_of_vertices()))
    throw Failure(Exit_code::UNREADABLE,
                  path + ": refers to vertex " + std::to_string(index) + ", but there are only "
                    + std::to_string(mesh.number_of_vertices()) + " (all counted from 0)");
  return Vertex(Mesh::size_type(index));
}

Edge find_edge(const std::string& path, Vertex_pair pair, const Mesh& mesh)
{
  const Halfedge h = mesh.halfedge(find_vertex(path, pair.source, mesh), find_vertex(path, pair.target, mesh));
  if(h == Mesh::null_halfedge())
    throw Failure(Exit_code::UNSUPPORTED,
                  path + ": there is no edge between vertices " + std::to_string(pair.source) + " and "
                    + std::to_string(pair.target),
                  {Witness::Kind::EDGES, {pair.source, pair.target}});
  return mesh.edge(h);
}

void mark_edges(const std::string& option, const std::string& path, const Mesh& mesh,
                Mesh::Property_map<Edge, bool> is_marked, std::vector<std::string>& warnings)
{
  if(path.empty())
    return;
  const Selection selection = read_selection(path);
  for(const Vertex_pair& pair : selection.edges)
    is_marked[find_edge(path, pair, mesh)] = true;
  if(selection.edges.empty())
    warnings.push_back(option + ": no edge is selected in " + path);
}

void mark_vertices(const std::string& option, const std::string& path, const Mesh& mesh,
                   Mesh::Property_map<Vertex, bool> is_marked, std::vector<std::string>& warnings)
{
  if(path.empty())
    return;
  const Selection selection = read_selection(path);
  for(const int v : selection.vertices)
    is_marked[find_vertex(path, v, mesh)] = true;
  if(selection.vertices.empty())
    warnings.push_back(option + ": no vertex is selected in " + path);
}

// The lengths, or what a file gives instead for some of the edges.
void read_weights(const std::string& path, const Mesh& mesh, Mesh::Property_map<Edge, double> weights)
{
  for(const Edge e : mesh.edges())
    weights[e] = CGAL::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  for(const Edge_weight& given : read_edge_weights(path))
    weights[find_edge(path, given.edge, mesh)] = given.weight;
}

void weigh_by_visibility(const Mesh& mesh, Mesh::Property_map<Edge, double> weights)
{
  constexpr int number_of_rays = 64;
  constexpr double smallest_factor = 0.2;
  SMC::visibility_weights<CGAL::Parallel_if_available_tag>(mesh, weights, number_of_rays, smallest_factor,
                                                           CGAL::parameters::visitor(Stop_visitor()));
}

} // namespace

Constraints read_constraints(const Options& options, Mesh& mesh)
{
  Constraints constraints;
  constraints.must_be_cut = mesh.add_property_map<Edge, bool>("e:must_be_cut", false).first;
  constraints.must_not_be_cut = mesh.add_property_map<Edge, bool>("e:must_not_be_cut", false).first;
  constraints.is_initially_cut = mesh.add_property_map<Edge, bool>("e:is_initially_cut", false).first;
  constraints.is_terminal = mesh.add_property_map<Vertex, bool>("v:is_terminal", false).first;
  mark_edges("--must-cut", options.must_cut, mesh, constraints.must_be_cut, constraints.warnings);
  mark_edges("--never-cut", options.never_cut, mesh, constraints.must_not_be_cut, constraints.warnings);
  mark_edges("--initial-cut", options.initial_cut, mesh, constraints.is_initially_cut, constraints.warnings);
  mark_vertices("--terminals", options.terminals, mesh, constraints.is_terminal, constraints.warnings);
  end_if_stop_is_requested();
  if(options.edge_weights.empty())
    return constraints;

  constraints.weights = mesh.add_property_map<Edge, double>("e:weight", 0).first;
  if(options.edge_weights == "crease")
    SMC::crease_weights(mesh, *constraints.weights);
  else if(options.edge_weights == "visibility")
    weigh_by_visibility(mesh, *constraints.weights);
  else
    read_weights(options.edge_weights, mesh, *constraints.weights);
  end_if_stop_is_requested();
  return constraints;
}
