#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_cutting/greedy_cut.h>
#include <CGAL/Surface_mesh_cutting/make_seam_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/distortion_measures.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <boost/property_map/property_map.hpp>

#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double>        Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>   Mesh;
typedef boost::graph_traits<Mesh>::edge_descriptor     edge_descriptor;
typedef boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;

namespace SMC = CGAL::Surface_mesh_cutting;
namespace SMP = CGAL::Surface_mesh_parameterization;

// Maps the opened surface. Neither of the two parameterizers promises that no triangle flips; the energy
// is infinite where one does.
template <typename Parameterizer, typename SeamMesh>
bool flatten(Mesh& mesh, SeamMesh& seam_mesh, const char* name)
{
  auto uv = mesh.add_property_map<halfedge_descriptor, Kernel::Point_2>("h:uv").first;
  const auto border = CGAL::Polygon_mesh_processing::longest_border(seam_mesh).first;
  const SMP::Error_code error = SMP::parameterize(seam_mesh, Parameterizer(), border, uv);
  if(error != SMP::OK)
  {
    std::cerr << name << ": error " << error << std::endl;
    return false;
  }
  // A vertex of the seam mesh is a halfedge of the mesh: spread its UV to all corners there.
  auto corner_uv = mesh.add_property_map<halfedge_descriptor, Kernel::Point_2>("h:corner_uv").first;
  for(halfedge_descriptor h : halfedges(mesh))
    corner_uv[h] = get(uv, target(typename SeamMesh::halfedge_descriptor(h), seam_mesh));
  std::cout << name << ": mean MIPS energy "
            << SMP::compute_MIPS_energy(mesh, corner_uv, boost::dummy_property_map()) << std::endl;
  return true;
}

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
  // Other parameterizers cope with less distortion than the package's own.
  if(const auto result = SMC::greedy_cut(mesh, is_cut, CGAL::parameters::maximum_average_distortion(4.1)); !result)
  {
    std::cerr << result.status.message << std::endl;
    return EXIT_FAILURE;
  }
  auto seam_mesh = SMC::make_seam_mesh(mesh, is_cut);
  typedef decltype(seam_mesh) Seam_mesh;
  const bool is_flat = flatten<SMP::LSCM_parameterizer_3<Seam_mesh> >(mesh, seam_mesh, "LSCM")
                    && flatten<SMP::ARAP_parameterizer_3<Seam_mesh> >(mesh, seam_mesh, "ARAP");
  return is_flat ? EXIT_SUCCESS : EXIT_FAILURE;
}
