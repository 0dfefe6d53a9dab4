#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_cutting/pack_charts.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include <fstream>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double>        Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>   Mesh;
typedef boost::graph_traits<Mesh>::edge_descriptor     edge_descriptor;
typedef boost::graph_traits<Mesh>::face_descriptor     face_descriptor;
typedef boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
typedef boost::graph_traits<Mesh>::vertex_descriptor   vertex_descriptor;

namespace SMC = CGAL::Surface_mesh_cutting;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off");
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto is_cut = mesh.add_property_map<edge_descriptor, bool>("e:is_cut", false).first;
  auto uv = mesh.add_property_map<halfedge_descriptor, Kernel::Point_2>("h:uv").first;
  // For a texture: no two triangles overlap, and all charts lie in the unit square.
  const auto result = SMC::unwrap(mesh, is_cut, uv, CGAL::parameters::do_bijective(true));
  if(!result.has_result)
  {
    std::cerr << result.status.message << std::endl;
    return EXIT_FAILURE;
  }
  const auto packing = SMC::pack_charts(mesh, is_cut, uv);
  if(!packing.has_result)
  {
    std::cerr << packing.status.message << std::endl;
    return EXIT_FAILURE;
  }

  // A texture coordinate for each corner: the one of a halfedge belongs to its target.
  std::ofstream out("unwrapped.obj");
  out.precision(17);
  for(vertex_descriptor v : vertices(mesh))
    out << "v " << mesh.point(v) << "\n";
  std::size_t corner = 0;
  for(face_descriptor f : faces(mesh))
    for(halfedge_descriptor h : halfedges_around_face(halfedge(f, mesh), mesh))
      out << "vt " << uv[h] << "\n";
  for(face_descriptor f : faces(mesh))
  {
    out << "f";
    for(halfedge_descriptor h : halfedges_around_face(halfedge(f, mesh), mesh))
      out << " " << mesh.target(h) + 1 << "/" << ++corner;
    out << "\n";
  }
  std::cout << "a cut of " << result.cut_length / result.bounding_box_diagonal
            << " bounding box diagonals, mean energy " << result.average_distortion << std::endl;
  return out ? EXIT_SUCCESS : EXIT_FAILURE;
}
