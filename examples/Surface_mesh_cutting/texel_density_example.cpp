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
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/bones.off");
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  auto is_cut = mesh.add_property_map<edge_descriptor, bool>("e:is_cut", false).first;
  auto uv = mesh.add_property_map<halfedge_descriptor, Kernel::Point_2>("h:uv").first;
  const auto result = SMC::unwrap(mesh, is_cut, uv, CGAL::parameters::do_bijective(true).effort(SMC::Effort::FAST));
  if(!result)
  {
    std::cerr << result.status.message << std::endl;
    return EXIT_FAILURE;
  }

  // The layout has the scale of the surface. All charts get 1000 texels per bounding box diagonal, on pages of 512 x 512.
  const double density = 1000 / result.bounding_box_diagonal;
  const auto np = CGAL::parameters::texels_per_unit(density).texture_size(512).margin(4)
                    .effort(SMC::Effort::FAST);
  const auto packing = SMC::pack_charts(mesh, is_cut, uv, np);
  if(!packing)
  {
    std::cerr << packing.status.message << std::endl; // for example, a chart is larger than a page
    return EXIT_FAILURE;
  }
  // Page i is the unit square moved by i % 10 to the right and i / 10 up; UDIM numbers it 1001 + i.
  const std::size_t number_of_pages = packing.page_fills.size();
  for(std::size_t i = 0; i < number_of_pages; ++i)
    std::cout << "tile " << 1001 + i << " is filled to " << 100 * packing.page_fills[i] << " %" << std::endl;

  const auto status = SMC::certify_packing(mesh, is_cut, uv, np);
  std::cout << (status ? "certified: apart by the margin on each page" : status.message) << std::endl;
  return status ? EXIT_SUCCESS : EXIT_FAILURE;
}
