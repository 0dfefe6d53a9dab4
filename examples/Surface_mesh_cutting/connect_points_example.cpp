#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_cutting/connect_points.h>
#include <CGAL/Surface_mesh_cutting/is_cut_to_disks.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double>        Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>   Mesh;
typedef boost::graph_traits<Mesh>::edge_descriptor   edge_descriptor;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;

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

  // The extreme vertices in the directions of the axes.
  std::vector<vertex_descriptor> points;
  for(int axis = 0; axis < 3; ++axis)
  {
    const auto extremes = std::minmax_element(vertices(mesh).begin(), vertices(mesh).end(),
      [&](vertex_descriptor v, vertex_descriptor w) { return mesh.point(v)[axis] < mesh.point(w)[axis]; });
    points.push_back(*extremes.first);
    points.push_back(*extremes.second);
  }

  auto is_cut = mesh.add_property_map<edge_descriptor, bool>("e:is_cut", false).first;
  const std::pair<const char*, SMC::Connection> methods[]
    = {{"greedy", SMC::Connection::GREEDY}, {"shortest", SMC::Connection::EXACT}};
  for(const auto& method : methods)
  {
    const SMC::Connection_result<Mesh> result
      = SMC::connect_points(mesh, points, is_cut, CGAL::parameters::connection(method.second));
    if(!result)
    {
      std::cerr << result.status.message << std::endl;
      return EXIT_FAILURE;
    }
    std::cout << method.first << ": length " << result.length << ", " << result.number_of_auxiliary_points
              << " auxiliary points" << (result.is_optimal ? ", proven shortest" : "") << std::endl;
  }
  return SMC::is_cut_to_disks(mesh, is_cut) ? EXIT_SUCCESS : EXIT_FAILURE;
}
