#include "weigh_edges.h"

#include "Stop_visitor.h"
#include "constraint_files.h"
#include "known_edges.h"
#include "named_elements.h"
#include "outcome.h"
#include "stop_request.h"
#include "surface_numbers.h"
#include "vertex_colors.h"

#include <CGAL/Surface_mesh_cutting/crease_weights.h>
#include <CGAL/Surface_mesh_cutting/painted_weights.h>
#include <CGAL/Surface_mesh_cutting/straightness_weights.h>
#include <CGAL/Surface_mesh_cutting/visibility_weights.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace {

namespace SMC = CGAL::Surface_mesh_cutting;
using Kind = Weight_choice::Kind;
using Weights = Mesh::Property_map<Edge, double>;
using Paint = Mesh::Property_map<Vertex, double>;

constexpr double smallest_factor = 0.2, smallest_visibility_factor = 0.25;

// What is never cut stays so, also where another file has zero.
double product(double weight, double factor)
{
  return std::isinf(weight) || std::isinf(factor) ? std::numeric_limits<double>::infinity() : weight * factor;
}

// `is_first` if the weights are still the lengths: then those of the file are taken to the last digit.
void multiply_by_file(const std::string& path, const Named_elements& names, bool is_first, Weights weights)
{
  const Mesh& mesh = names.surface().mesh;
  for(const Edge_weight& given : read_edge_weights(path))
    for(const Edge e : names.find_edges(path, given.edge))
    {
      const double length = edge_length(mesh, e);
      weights[e] = is_first || !(length > 0) ? given.weight : product(weights[e], given.weight / length);
    }
}

Paint read_paint(const std::string& path, const Named_elements& names, Mesh& mesh)
{
  const Paint paint = mesh.add_property_map<Vertex, double>("", 1).first;
  const Vertex_values values = read_vertex_values(path);
  if(values.is_for_all && int(values.values.size()) != names.number_of_vertices())
    throw Failure(Exit_code::UNREADABLE, path + ": has " + std::to_string(values.values.size()) + " numbers for "
                                           + std::to_string(names.number_of_vertices()) + " vertices");
  for(const Vertex_value& given : values.values)
    for(const Vertex v : names.find_vertices(path, given.vertex))
      paint[v] = given.value;
  return paint;
}

Paint paint_by_color(const Polygon_soup& soup, Surface& surface)
{
  if(soup.colors.empty())
    throw Failure(Exit_code::UNSUPPORTED, "--edge-weights colors: the input has no colors of all vertices "
                                          "(COFF; OBJ with red, green and blue behind the coordinates; PLY with red)");
  if(const std::optional<int> wrong = find_wrong_color(soup))
    throw Failure(Exit_code::UNREADABLE, "the color of vertex " + std::to_string(*wrong) + " is out of range",
                  {Witness::Kind::VERTICES, {*wrong}});
  const Paint paint = surface.mesh.add_property_map<Vertex, double>("", 1).first;
  for(const Vertex v : surface.mesh.vertices())
    paint[v] = smallest_factor + (1 - smallest_factor) * soup.colors[std::size_t(surface.vertices[v])][0];
  return paint;
}

void multiply_by_hardness(Mesh& mesh, Weights weights)
{
  constexpr double hard_angle = 60; // degrees
  const Mesh::Property_map<Edge, bool> is_hard = mesh.add_property_map<Edge, bool>("", false).first;
  mark_hard_edges(mesh, hard_angle, is_hard);
  for(const Edge e : mesh.edges())
    if(is_hard[e])
      weights[e] = product(weights[e], smallest_factor);
}

template <typename NamedParameters>
void multiply_by_visibility(const Mesh& mesh, Weights weights, const NamedParameters& view)
{
  constexpr int number_of_rays = 64;
  SMC::visibility_weights<CGAL::Parallel_if_available_tag>(mesh, weights,
                                                           view.number_of_rays(number_of_rays)
                                                             .smallest_factor(smallest_visibility_factor)
                                                             .edge_weight_map(weights)
                                                             .visitor(Stop_visitor()));
}

void multiply(const Weight_choice& choice, bool is_first, const Polygon_soup& soup, Surface& surface, Weights weights)
{
  Mesh& mesh = surface.mesh;
  constexpr double smallest_convex_factor = 0.6, occlusion_radius = 0.1;
  const auto given = CGAL::parameters::edge_weight_map(weights);
  switch(choice.kind)
  {
    case Kind::CREASE: SMC::crease_weights(mesh, weights, given.smallest_factor(smallest_factor)); break;
    case Kind::CONCAVE:
      SMC::crease_weights(mesh, weights, given.smallest_factor(smallest_factor).smallest_convex_factor(smallest_convex_factor));
      break;
    case Kind::HARD: multiply_by_hardness(mesh, weights); break;
    case Kind::STRAIGHT: SMC::straightness_weights(mesh, weights, given.smallest_factor(smallest_factor)); break;
    case Kind::VISIBILITY: multiply_by_visibility(mesh, weights, CGAL::parameters::random_seed(0)); break;
    case Kind::OCCLUSION:
      multiply_by_visibility(mesh, weights, CGAL::parameters::occlusion_radius(occlusion_radius));
      break;
    case Kind::SKY:
      multiply_by_visibility(mesh, weights, CGAL::parameters::up_direction(
                                              Kernel::Vector_3(choice.up[0], choice.up[1], choice.up[2])));
      break;
    case Kind::COLORS: SMC::painted_weights(mesh, weights, paint_by_color(soup, surface), given); break;
    case Kind::PAINT: SMC::painted_weights(mesh, weights, read_paint(choice.file, Named_elements(soup, surface), mesh), given); break;
    case Kind::EDGES:
      check_is_word_or_file(choice);
      multiply_by_file(choice.file, Named_elements(soup, surface), is_first, weights);
      break;
  }
}

} // namespace

void weigh_edges(const std::vector<Weight_choice>& choices, const Polygon_soup& soup, Surface& surface, Weights weights)
{
  // The lengths as the library measures them.
  SMC::painted_weights(surface.mesh, weights, CGAL::Constant_property_map<Vertex, double>(1));
  for(std::size_t i = 0; i < choices.size(); ++i)
  {
    multiply(choices[i], i == 0, soup, surface, weights);
    end_if_stop_is_requested();
  }
}
