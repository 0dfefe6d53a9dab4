#include "surface_numbers.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <utility>
#include <vector>

namespace {

int number_of_components(const Mesh& mesh)
{
  std::vector<int> component_of_face(mesh.number_of_faces());
  return int(CGAL::Polygon_mesh_processing::connected_components(
    mesh, boost::make_iterator_property_map(component_of_face.begin(), get(boost::face_index, mesh))));
}

int number_of_borders(const Mesh& mesh)
{
  std::vector<char> is_met(mesh.number_of_halfedges(), 0);
  int number = 0;
  for(const Halfedge first : mesh.halfedges())
  {
    if(!mesh.is_border(first) || is_met[first])
      continue;
    ++number;
    for(Halfedge h = first; !std::exchange(is_met[h], char(1)); h = mesh.next(h)) {}
  }
  return number;
}

} // namespace

void tell_numbers(const Mesh& mesh, Outcome& outcome)
{
  const int components = number_of_components(mesh), borders = number_of_borders(mesh);
  const int characteristic = int(mesh.number_of_vertices()) - int(mesh.number_of_edges()) + int(mesh.number_of_faces());
  outcome.components = components;
  outcome.borders = borders;
  outcome.genus = (2 * components - borders - characteristic) / 2; // Euler's formula
}
