#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_cutting/certify_unwrap.h>
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
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/hand.off");
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  auto is_cut = mesh.add_property_map<edge_descriptor, bool>("e:is_cut", false).first;
  auto uv = mesh.add_property_map<halfedge_descriptor, Kernel::Point_2>("h:uv").first;

  // A short cut at which the mean energy stays below the bound, and no two triangles overlap.
  for(double bound : {4.3, 4.1})
  {
    const auto result = SMC::unwrap(mesh, is_cut, uv,
                                    CGAL::parameters::maximum_average_distortion(bound).do_bijective(true));
    // A result that misses the bound is valid nevertheless.
    if(!result && result.status.code != SMC::Status_code::BOUND_NOT_REACHED)
    {
      std::cerr << result.status.message << std::endl;
      return EXIT_FAILURE;
    }
    std::cout << "at most " << bound << ": mean energy " << result.average_distortion << ", a cut of "
              << result.cut_length / result.bounding_box_diagonal << " bounding box diagonals" << std::endl;
  }

  // The same proof that unwrap() itself relies on.
  const auto status = SMC::certify_unwrap(mesh, is_cut, uv, CGAL::parameters::do_bijective(true));
  std::cout << (status ? "certified: one to one" : status.message) << std::endl;
  return status ? EXIT_SUCCESS : EXIT_FAILURE;
}
