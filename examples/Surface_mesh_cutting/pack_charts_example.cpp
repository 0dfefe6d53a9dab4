#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_cutting/certify_packing.h>
#include <CGAL/Surface_mesh_cutting/pack_charts.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double>        Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>   Mesh;
typedef boost::graph_traits<Mesh>::edge_descriptor     edge_descriptor;
typedef boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;

namespace SMC = CGAL::Surface_mesh_cutting;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/joint.off");
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  auto is_cut = mesh.add_property_map<edge_descriptor, bool>("e:is_cut", false).first;
  auto uv = mesh.add_property_map<halfedge_descriptor, Kernel::Point_2>("h:uv").first;

  const auto result = SMC::unwrap(mesh, is_cut, uv, CGAL::parameters::do_bijective(true));
  if(!result)
  {
    std::cerr << result.status.message << std::endl;
    return EXIT_FAILURE;
  }

  // For a texture of 2048 by 2048 texels, with 4 of them between charts.
  const auto np = CGAL::parameters::margin(4).texture_size(2048).do_bijective(true);
  const auto packing = SMC::pack_charts(mesh, is_cut, uv, np);
  if(!packing)
  {
    std::cerr << packing.status.message << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << packing.number_of_charts << " chart(s) fill " << 100 * packing.fill << " % of the unit square; a unit of "
            << "length is " << packing.scale << " long there" << std::endl;

  const auto status = SMC::certify_packing(mesh, is_cut, uv, np);
  std::cout << (status ? "certified: no overlaps, and apart by the margin" : status.message) << std::endl;
  return status ? EXIT_SUCCESS : EXIT_FAILURE;
}
