#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_cutting/greedy_cut.h>
#include <CGAL/Surface_mesh_cutting/make_seam_mesh.h>

#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double>        Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>   Mesh;
typedef boost::graph_traits<Mesh>::edge_descriptor edge_descriptor;

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

  Mesh::Property_map<edge_descriptor, bool> is_cut
    = mesh.add_property_map<edge_descriptor, bool>("e:is_cut", false).first;
  const SMC::Cut_result<Mesh> result = SMC::greedy_cut(mesh, is_cut);
  if(!result)
  {
    std::cerr << result.status.message << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "a cut through " << result.feature_points.size() << " feature points, "
            << result.cut_length / result.bounding_box_diagonal << " bounding box diagonals long\n";

  // The opened surface, as the parameterizers of CGAL take it.
  const auto seam_mesh = SMC::make_seam_mesh(mesh, is_cut);
  std::cout << seam_mesh.number_of_seam_edges() << " seam edges" << std::endl;
  return EXIT_SUCCESS;
}
