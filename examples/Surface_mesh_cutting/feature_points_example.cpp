#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_cutting/detect_feature_points.h>

#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double>        Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>   Mesh;
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

  // A larger threshold keeps fewer points: each one has to lower the mean energy by more.
  for(double threshold : {0.05, 0.01})
  {
    std::vector<vertex_descriptor> points;
    const SMC::Cut_result<Mesh> result = SMC::detect_feature_points(
      mesh, std::back_inserter(points), CGAL::parameters::minimum_distortion_decrease(threshold));
    if(!result)
    {
      std::cerr << result.status.message << std::endl;
      return EXIT_FAILURE;
    }
    std::cout << threshold << ": " << points.size() << " of " << result.number_of_candidates << " candidates\n";
  }
  return EXIT_SUCCESS;
}
