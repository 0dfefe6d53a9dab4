#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double>        Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>   Mesh;
typedef boost::graph_traits<Mesh>::edge_descriptor     edge_descriptor;
typedef boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMC = CGAL::Surface_mesh_cutting;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/couplingdown.off");
  Mesh mesh;
  if(!PMP::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Seams of a machine part belong to its sharp edges: all of them are cut.
  auto is_sharp = mesh.add_property_map<edge_descriptor, bool>("e:is_sharp", false).first;
  PMP::detect_sharp_edges(mesh, 60, is_sharp);

  // No chart has a mean energy above 4.1, and 99.9 % of the area has no face above 6. Without the quantile, all faces count.
  auto is_cut = mesh.add_property_map<edge_descriptor, bool>("e:is_cut", false).first;
  auto uv = mesh.add_property_map<halfedge_descriptor, Kernel::Point_2>("h:uv").first;
  const auto result = SMC::unwrap(mesh, is_cut, uv,
                                  CGAL::parameters::edge_is_constrained_map(is_sharp)
                                    .maximum_chart_distortion(4.1)
                                    .maximum_face_distortion(6).face_distortion_quantile(0.999)
                                    .do_bijective(true));
  // With Status_code::BOUND_NOT_REACHED, the result is the best one found, and the status holds the faces above a bound.
  if(!result && result.status.code != SMC::Status_code::BOUND_NOT_REACHED)
  {
    std::cerr << result.status.message << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << (result ? "all bounds are kept" : result.status.message) << std::endl;
  for(const SMC::Chart_distortion& chart : result.charts)
    std::cout << "a chart of " << chart.number_of_faces << " faces: mean energy " << chart.average << ", largest "
              << chart.largest << std::endl;
  for(const auto& [share, energy] : result.distortion_quantiles)
    std::cout << 100 * share << " % of the area: energy at most " << energy << std::endl;
  return EXIT_SUCCESS;
}
