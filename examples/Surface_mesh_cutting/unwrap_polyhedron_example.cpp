#include <CGAL/Simple_cartesian.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_cutting/certify_unwrap.h>
#include <CGAL/Surface_mesh_cutting/unwrap.h>

#include <boost/property_map/property_map.hpp>

#include <iostream>
#include <string>
#include <unordered_map>

typedef CGAL::Simple_cartesian<double>  Kernel;
typedef CGAL::Polyhedron_3<Kernel>      Polyhedron;
typedef boost::graph_traits<Polyhedron>::edge_descriptor     edge_descriptor;
typedef boost::graph_traits<Polyhedron>::halfedge_descriptor halfedge_descriptor;

namespace SMC = CGAL::Surface_mesh_cutting;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off");
  Polyhedron polyhedron;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(filename, polyhedron))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  std::unordered_map<edge_descriptor, bool> edges;
  std::unordered_map<halfedge_descriptor, Kernel::Point_2> uvs;
  boost::associative_property_map<std::unordered_map<edge_descriptor, bool> > is_cut(edges);
  boost::associative_property_map<std::unordered_map<halfedge_descriptor, Kernel::Point_2> > uv(uvs);

  const SMC::Unwrap_result<Polyhedron> result = SMC::unwrap(polyhedron, is_cut, uv);
  if(!result)
  {
    std::cerr << result.status.message << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "mean symmetric Dirichlet energy " << result.average_distortion << " (4: no distortion)\n";

  // The same proof that unwrap() itself relies on.
  const SMC::Result_status<Polyhedron> status = SMC::certify_unwrap(polyhedron, is_cut, uv);
  std::cout << (status ? "certified: disks, without a flip" : status.message) << std::endl;
  return status ? EXIT_SUCCESS : EXIT_FAILURE;
}
