#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_cutting/cut_handles.h>

#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double>        Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>   Mesh;
typedef boost::graph_traits<Mesh>::edge_descriptor edge_descriptor;

namespace SMC = CGAL::Surface_mesh_cutting;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto is_cut = mesh.add_property_map<edge_descriptor, bool>("e:is_cut", false).first;
  const SMC::Handles_result<Mesh> result = SMC::cut_handles(mesh, is_cut);
  if(!result)
  {
    std::cerr << result.status.message << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << result.loops.size() << " handles, cut along loops of together " << result.length << "\n";
  for(const auto& loop : result.loops)
    std::cout << "a loop of " << loop.size() << " edges through vertex " << mesh.source(loop.front()) << "\n";
  return EXIT_SUCCESS;
}
