#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_cutting/reflection_symmetry.h>
#include <CGAL/Surface_mesh_cutting/seam_report.h>
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
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/couplingdown.off");
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Which symmetries does the surface have?
  const SMC::Reflection_symmetry<Mesh> found = SMC::reflection_symmetry(mesh);
  for(const SMC::Reflection_plane& plane : found.planes)
    std::cout << "plane with normal (" << plane.normal[0] << " " << plane.normal[1] << " " << plane.normal[2]
              << ") and offset " << plane.offset << ", " << (plane.is_exact ? "exact" : "of the shape only") << std::endl;
  if(!found)
    std::cout << "no symmetry; the best plane matches " << 100 * found.largest_match << " % of the vertices" << std::endl;

  // The cut has the best of them, if it is exact; otherwise a warning says why not.
  auto is_cut = mesh.add_property_map<edge_descriptor, bool>("e:is_cut", false).first;
  auto uv = mesh.add_property_map<halfedge_descriptor, Kernel::Point_2>("h:uv").first;
  const SMC::Unwrap_result<Mesh> result
    = SMC::unwrap(mesh, is_cut, uv, CGAL::parameters::do_bijective(true).symmetry(SMC::Symmetry::AUTOMATIC)
                                      .seam_smoothness(2)); // seams may get 2 % longer to be straighter
  if(!result)
  {
    std::cerr << result.status.message << std::endl;
    return EXIT_FAILURE;
  }
  for(const auto& warning : result.status.warnings)
    std::cout << "warning: " << warning.message << std::endl;

  const SMC::Seam_report<Mesh> seams = SMC::seam_report(mesh, is_cut, uv);
  if(seams.jaggedness)
    std::cout << "seams turn by " << *seams.jaggedness << " per edge, and " << 100 * *seams.hidden << " % of the light around"
              << " them is blocked" << std::endl;
  std::cout << "charts are as compact as " << seams.compactness << ", where a disk has 1" << std::endl;
  return EXIT_SUCCESS;
}
