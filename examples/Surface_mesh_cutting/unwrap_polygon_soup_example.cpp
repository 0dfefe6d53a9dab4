#include <CGAL/Simple_cartesian.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Surface_mesh_cutting/certify_unwrapped_polygon_soup.h>
#include <CGAL/Surface_mesh_cutting/unwrap_polygon_soup.h>

#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;

namespace SMC = CGAL::Surface_mesh_cutting;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/quads_to_stitch.off");
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t> > polygons;
  if(!CGAL::IO::read_polygon_soup(filename, points, polygons))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  std::vector<std::vector<Kernel::Point_2> > uvs; // of the corners of each polygon
  const SMC::Unwrap_soup_result result = SMC::unwrap_polygon_soup(points, polygons, uvs, CGAL::parameters::do_weld_points(true));
  if(!result)
  {
    std::cerr << result.status.message << std::endl;
    return EXIT_FAILURE;
  }

  for(const SMC::Interpretation& reading : result.interpreted)
    if(reading.kind == SMC::Interpretation_kind::WELDED_VERTICES)
      std::cout << reading.count() << " points count as a former one at the same place" << std::endl;
  std::cout << polygons.size() << " polygons in " << result.components << " parts, mean energy "
            << result.average_distortion << std::endl;

  const auto certificate
    = SMC::certify_unwrapped_polygon_soup(points, polygons, uvs, CGAL::parameters::do_weld_points(true));
  return certificate ? EXIT_SUCCESS : EXIT_FAILURE;
}
