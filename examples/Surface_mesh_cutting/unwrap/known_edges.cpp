#include "known_edges.h"

#include "Mesh_parts.h"
#include "option_values.h"
#include "options.h"
#include "outcome.h"
#include "uv_seams.h"

#include <CGAL/Polygon_mesh_processing/detect_features.h>

#include <optional>

namespace {

// The angle of angle:DEGREES; none for another word.
std::optional<double> parse_angle(const std::string& word)
{
  const std::string prefix = "angle:";
  if(word.compare(0, prefix.size(), prefix) != 0)
    return std::nullopt;
  return parse_number<double>("--must-cut angle", word.substr(prefix.size()), 0, 180);
}

// `text` tells what two faces must share, or there is a border between them.
template <typename Text>
void mark_borders(const Polygon_soup& soup, const Surface& surface, const Text& text, Mesh::Property_map<Edge, bool> is_marked)
{
  const Mesh& mesh = surface.mesh;
  const Mesh_parts parts = find_parts(soup.obj_statements, soup.number_of_polygons());
  const auto text_at = [&](Halfedge h)
  { return text(parts.parts[std::size_t(parts.polygon_parts[std::size_t(surface.polygons[mesh.face(h)])])]); };
  for(const Edge e : mesh.edges())
    if(!mesh.is_border(e) && text_at(mesh.halfedge(e, 0)) != text_at(mesh.halfedge(e, 1)))
      is_marked[e] = true;
}

void check_kind(const std::string& option, const std::string& word, const Polygon_soup& soup, Data_kind kind)
{
  if(soup.kinds.count(kind) == 0)
    throw Failure(Exit_code::UNSUPPORTED, option + " " + word + ": the input has no " + word + " (OBJ, glTF)");
}

} // namespace

bool is_word_for_edges(const std::string& word)
{
  return word == seams_of_input || word == "materials" || word == "groups" || parse_angle(word);
}

void mark_hard_edges(const Mesh& mesh, double angle, Mesh::Property_map<Edge, bool> is_marked)
{
  constexpr double rounding = 1e-6; // degrees
  CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, angle - rounding, is_marked);
  for(const Edge e : mesh.edges()) // these are no edges at which anything bends
    if(mesh.is_border(e) || mesh.point(mesh.vertex(e, 0)) == mesh.point(mesh.vertex(e, 1)))
      is_marked[e] = false;
}

void mark_known_edges(const std::string& option, const std::string& word, const Polygon_soup& soup, Surface& surface,
                      Mesh::Property_map<Edge, bool> is_marked, std::vector<std::string>& warnings)
{
  const Mesh::Property_map<Edge, bool> is_known = surface.mesh.add_property_map<Edge, bool>("", false).first;
  if(word == seams_of_input)
    for(const Edge e : uv_seams(option, soup, surface))
      is_known[e] = true;
  else if(word == "materials")
  {
    check_kind(option, word, soup, Data_kind::MATERIALS);
    mark_borders(soup, surface, [](const Mesh_parts::Part& part) { return part.material; }, is_known);
  }
  else if(word == "groups")
  {
    check_kind(option, word, soup, Data_kind::GROUPS);
    mark_borders(soup, surface, [](const Mesh_parts::Part& part) { return part.name; }, is_known);
  }
  else
    mark_hard_edges(surface.mesh, parse_angle(word).value(), is_known);

  bool has_edges = false;
  for(const Edge e : surface.mesh.edges())
    if(is_known[e])
      has_edges = is_marked[e] = true;
  if(!has_edges)
    warnings.push_back(option + ": " + (word == seams_of_input ? "the texture coordinates of the input have no seam"
                                                               : "there is no edge of the kind " + word));
}
