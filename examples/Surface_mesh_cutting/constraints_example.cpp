#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh_cutting/crease_weights.h>
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
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off");
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double middle = 0.5 * (box.xmin() + box.xmax()), front = 0.9 * box.xmax() + 0.1 * box.xmin();
  const auto x = [&](edge_descriptor e, int end) { return mesh.point(mesh.vertex(e, end)).x(); };
  const auto is_in_front_half = [&](halfedge_descriptor h)
  {
    return mesh.point(mesh.target(h)).x() + mesh.point(mesh.target(mesh.next(h))).x()
             + mesh.point(mesh.source(h)).x() > 3 * middle;
  };

  // The surface falls into a front and a back, and nothing is cut at the foremost tenth.
  auto must_be_cut = mesh.add_property_map<edge_descriptor, bool>("e:must_be_cut", false).first;
  auto must_not_be_cut = mesh.add_property_map<edge_descriptor, bool>("e:must_not_be_cut", false).first;
  for(edge_descriptor e : edges(mesh))
  {
    must_be_cut[e] = !mesh.is_border(e)
                     && is_in_front_half(mesh.halfedge(e, 0)) != is_in_front_half(mesh.halfedge(e, 1));
    must_not_be_cut[e] = x(e, 0) > front && x(e, 1) > front;
  }

  // Creases are cheaper than other edges.
  auto weight = mesh.add_property_map<edge_descriptor, double>("e:weight", 0).first;
  SMC::crease_weights(mesh, weight);

  auto is_cut = mesh.add_property_map<edge_descriptor, bool>("e:is_cut", false).first;
  auto uv = mesh.add_property_map<halfedge_descriptor, Kernel::Point_2>("h:uv").first;
  const auto result = SMC::unwrap(mesh, is_cut, uv,
                                  CGAL::parameters::edge_is_constrained_map(must_be_cut)
                                    .edge_is_forbidden_map(must_not_be_cut)
                                    .edge_weight_map(weight));
  if(!result)
  {
    // With Status_code::INFEASIBLE_CONSTRAINTS, the status holds the edges or vertices in conflict.
    std::cerr << result.status.message << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "a cut of " << result.cut_length / result.bounding_box_diagonal
            << " bounding box diagonals, mean energy " << result.average_distortion << std::endl;
  return EXIT_SUCCESS;
}
