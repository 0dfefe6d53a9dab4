// The loops along which a surface loses its handles, for a figure of the user manual:
//   handle_loops MESH LOOPS.obj

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_cutting/cut_handles.h>

#include <fstream>
#include <iostream>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char** argv)
{
  Mesh mesh;
  if(argc != 3 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh))
  {
    std::cerr << "usage: handle_loops MESH LOOPS.obj" << std::endl;
    return EXIT_FAILURE;
  }
  auto is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_cut", false).first;
  const auto result = CGAL::Surface_mesh_cutting::cut_handles(mesh, is_cut);
  std::ofstream out(argv[2]);
  out.precision(17);
  for(Mesh::Vertex_index v : vertices(mesh))
    out << "v " << mesh.point(v) << "\n";
  for(const auto& loop : result.loops)
    for(Mesh::Halfedge_index h : loop)
      out << "l " << mesh.source(h) + 1 << " " << mesh.target(h) + 1 << "\n";
  return result ? EXIT_SUCCESS : EXIT_FAILURE;
}
