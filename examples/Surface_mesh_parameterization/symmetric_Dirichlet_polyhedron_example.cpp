#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <CGAL/Surface_mesh_parameterization/IO/File_off.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <boost/property_map/property_map.hpp>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <unordered_map>

namespace SMP = CGAL::Surface_mesh_parameterization;

typedef CGAL::Exact_predicates_inexact_constructions_kernel        Kernel;
typedef CGAL::Polyhedron_3<Kernel>                                 Polyhedron;
typedef boost::graph_traits<Polyhedron>::vertex_descriptor         vertex_descriptor;
typedef boost::graph_traits<Polyhedron>::halfedge_descriptor       halfedge_descriptor;
typedef std::unordered_map<vertex_descriptor, Kernel::Point_2>     UVs;
typedef SMP::Symmetric_Dirichlet_parameterizer_3<Polyhedron>       Parameterizer;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/nefertiti.off");
  Polyhedron mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // All borders are free: which one is given does not matter.
  UVs uvs;
  boost::associative_property_map<UVs> uv_map(uvs);
  const halfedge_descriptor border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  const SMP::Error_code error = SMP::parameterize(mesh, Parameterizer(), border, uv_map);
  if(error != SMP::OK) {
    std::cerr << "Error: no parameterization, code " << error << std::endl;
    return EXIT_FAILURE;
  }

  std::ofstream out("flattened.off");
  SMP::IO::output_uvmap_to_off(mesh, border, uv_map, out);
  return EXIT_SUCCESS;
}
