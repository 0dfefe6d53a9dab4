#include "Constraints.h"

#include "constraint_files.h"
#include "known_edges.h"
#include "named_elements.h"
#include "stop_request.h"
#include "weigh_edges.h"

namespace {

void mark_edges(const std::string& option, const std::string& path, const Named_elements& names,
                Mesh::Property_map<Edge, bool> is_marked, std::vector<std::string>& warnings)
{
  if(path.empty())
    return;
  const Selection selection = read_selection(path);
  for(const Vertex_pair& pair : selection.edges)
    for(const Edge e : names.find_edges(path, pair))
      is_marked[e] = true;
  if(selection.edges.empty())
    warnings.push_back(option + ": no edge is selected in " + path);
}

void mark_vertices(const std::string& option, const std::string& path, const Named_elements& names,
                   Mesh::Property_map<Vertex, bool> is_marked, std::vector<std::string>& warnings)
{
  if(path.empty())
    return;
  const Selection selection = read_selection(path);
  for(const int v : selection.vertices)
    for(const Vertex copy : names.find_vertices(path, v))
      is_marked[copy] = true;
  if(selection.vertices.empty())
    warnings.push_back(option + ": no vertex is selected in " + path);
}

} // namespace

Constraints read_constraints(const Options& options, const Polygon_soup& soup, Surface& surface)
{
  Mesh& mesh = surface.mesh;
  const Named_elements names(soup, surface);
  Constraints constraints;
  constraints.must_be_cut = mesh.add_property_map<Edge, bool>("e:must_be_cut", false).first;
  constraints.must_not_be_cut = mesh.add_property_map<Edge, bool>("e:must_not_be_cut", false).first;
  constraints.is_initially_cut = mesh.add_property_map<Edge, bool>("e:is_initially_cut", false).first;
  constraints.is_terminal = mesh.add_property_map<Vertex, bool>("v:is_terminal", false).first;
  for(const std::string& word : options.must_cut)
    if(is_word_for_edges(word))
      mark_known_edges("--must-cut", word, soup, surface, constraints.must_be_cut, constraints.warnings);
    else
      mark_edges("--must-cut", word, names, constraints.must_be_cut, constraints.warnings);
  mark_edges("--never-cut", options.never_cut, names, constraints.must_not_be_cut, constraints.warnings);
  if(options.initial_cut == seams_of_input)
    mark_known_edges("--initial-cut", seams_of_input, soup, surface, constraints.is_initially_cut, constraints.warnings);
  else
    mark_edges("--initial-cut", options.initial_cut, names, constraints.is_initially_cut, constraints.warnings);
  mark_vertices("--terminals", options.terminals, names, constraints.is_terminal, constraints.warnings);
  end_if_stop_is_requested();
  if(options.edge_weights.empty())
    return constraints;

  constraints.weights = mesh.add_property_map<Edge, double>("e:weight", 0).first;
  weigh_edges(options.edge_weights, soup, surface, *constraints.weights);
  return constraints;
}
