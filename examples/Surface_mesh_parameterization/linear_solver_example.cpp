#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Eigen_solver_traits.h>

#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/distortion_measures.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <Eigen/SparseCholesky>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstdlib>
#include <iostream>
#include <string>

namespace SMP = CGAL::Surface_mesh_parameterization;

typedef CGAL::Simple_cartesian<double>                            Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>                       Surface_mesh;
typedef boost::graph_traits<Surface_mesh>::vertex_descriptor      vertex_descriptor;
typedef boost::graph_traits<Surface_mesh>::halfedge_descriptor    halfedge_descriptor;

// Any direct solver of symmetric positive definite systems will do.
typedef Eigen::SimplicialLLT<Eigen::SparseMatrix<double> >        Cholesky;
typedef CGAL::Eigen_solver_traits<Cholesky>                       Solver_traits;
typedef SMP::MIPS_parameterizer_3<Surface_mesh, Solver_traits>    Parameterizer;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : CGAL::data_file_path("meshes/lion-head.off");
  Surface_mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh)) {
    std::cerr << "Error: cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto uv_map = mesh.add_property_map<vertex_descriptor, Kernel::Point_2>("v:uv").first;
  const halfedge_descriptor border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  const SMP::Error_code error = SMP::parameterize(mesh, Parameterizer(), border, uv_map);
  if(error != SMP::OK) {
    std::cerr << "Error: no parameterization, code " << error << std::endl;
    return EXIT_FAILURE;
  }

  // The measures take the UVs of halfedges.
  const auto halfedge_uv_map = boost::make_function_property_map<halfedge_descriptor>(
    [&](halfedge_descriptor h) { return get(uv_map, target(h, mesh)); });
  std::cout << "MIPS energy: "
            << SMP::compute_MIPS_energy(mesh, halfedge_uv_map, boost::dummy_property_map())
            << std::endl;
  return EXIT_SUCCESS;
}
