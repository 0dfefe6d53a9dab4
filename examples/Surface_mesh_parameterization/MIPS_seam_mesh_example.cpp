#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Seam_mesh.h>

#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

namespace SMP = CGAL::Surface_mesh_parameterization;

typedef CGAL::Simple_cartesian<double>                                 Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>                            Surface_mesh;
typedef boost::graph_traits<Surface_mesh>::vertex_descriptor           vertex_descriptor;
typedef boost::graph_traits<Surface_mesh>::halfedge_descriptor         halfedge_descriptor;
typedef boost::graph_traits<Surface_mesh>::edge_descriptor             edge_descriptor;

typedef Surface_mesh::Property_map<edge_descriptor, bool>              Edge_seam_map;
typedef Surface_mesh::Property_map<vertex_descriptor, bool>            Vertex_seam_map;
typedef CGAL::Seam_mesh<Surface_mesh, Edge_seam_map, Vertex_seam_map>  Seam_mesh;
typedef Surface_mesh::Property_map<halfedge_descriptor, Kernel::Point_2> UV_map;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/cow.off");
  Surface_mesh surface;
  if(!CGAL::IO::read_polygon_mesh(filename, surface)) {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Shortest paths from some vertex: the one to the farthest vertex becomes the seam.
  const vertex_descriptor first = *vertices(surface).begin();
  auto distance = surface.add_property_map<vertex_descriptor, double>().first;
  auto predecessor = surface.add_property_map<vertex_descriptor, vertex_descriptor>().first;
  boost::dijkstra_shortest_paths(surface, first,
                                 boost::distance_map(distance).predecessor_map(predecessor));
  const auto range = vertices(surface);
  const vertex_descriptor last = *std::max_element(range.begin(), range.end(),
    [&](vertex_descriptor v, vertex_descriptor w) { return get(distance, v) < get(distance, w); });

  Edge_seam_map edge_seam_map = surface.add_property_map<edge_descriptor, bool>("", false).first;
  Vertex_seam_map vertex_seam_map
    = surface.add_property_map<vertex_descriptor, bool>("", false).first;
  Seam_mesh mesh(surface, edge_seam_map, vertex_seam_map);
  for(vertex_descriptor v = last; v != first; v = get(predecessor, v))
    mesh.add_seam(v, get(predecessor, v));

  // The UVs belong to halfedges, as a vertex on the seam has several.
  UV_map uv_map = surface.add_property_map<halfedge_descriptor, Kernel::Point_2>("h:uv").first;
  const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  const SMP::Error_code error
    = SMP::parameterize(mesh, SMP::MIPS_parameterizer_3<Seam_mesh>(), border, uv_map);
  if(error != SMP::OK) {
    std::cerr << "Error: no parameterization, code " << error << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "The seam has " << mesh.number_of_seam_edges() << " edges; its end lies at "
            << get(uv_map, target(border, mesh)) << std::endl;
  return EXIT_SUCCESS;
}
