#include "surface_numbers.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/property_map.h>
#include <CGAL/squared_distance_3.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <utility>
#include <vector>

namespace {

template <typename NamedParameters>
int number_of_parts(const Mesh& mesh, const NamedParameters& np)
{
  std::vector<int> part_of_face(mesh.number_of_faces());
  return int(CGAL::Polygon_mesh_processing::connected_components(
    mesh, boost::make_iterator_property_map(part_of_face.begin(), get(boost::face_index, mesh)), np));
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

int number_of_charts(const Mesh& mesh, Cut_map is_cut)
{
  return number_of_parts(mesh, CGAL::parameters::edge_is_constrained_map(is_cut));
}

double edge_length(const Mesh& mesh, Edge e)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
}

double diagonal_of(const Mesh& mesh)
{
  Eigen::AlignedBox3d box;
  for(const Vertex v : mesh.vertices())
    box.extend(Eigen::Vector3d(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()));
  return box.diagonal().norm();
}

void tell_numbers(const Mesh& mesh, Outcome& outcome)
{
  const int components = number_of_parts(mesh, CGAL::parameters::default_values()), borders = number_of_borders(mesh);
  const int characteristic = int(mesh.number_of_vertices()) - int(mesh.number_of_edges()) + int(mesh.number_of_faces());
  outcome.components = components;
  outcome.borders = borders;
  outcome.genus = (2 * components - borders - characteristic) / 2; // Euler's formula
}
