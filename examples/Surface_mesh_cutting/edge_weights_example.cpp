#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh_cutting/crease_weights.h>
#include <CGAL/Surface_mesh_cutting/greedy_cut.h>
#include <CGAL/Surface_mesh_cutting/painted_weights.h>
#include <CGAL/Surface_mesh_cutting/visibility_weights.h>

#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double>        Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>   Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
typedef boost::graph_traits<Mesh>::edge_descriptor   edge_descriptor;

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

  // Somebody has painted the foremost fifth: cuts are five times as expensive there.
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  auto paint = mesh.add_property_map<vertex_descriptor, double>("v:paint", 1).first;
  for(vertex_descriptor v : vertices(mesh))
    if(mesh.point(v).x() > 0.8 * box.xmax() + 0.2 * box.xmin())
      paint[v] = 5;

  // Each of these functions multiplies the weights that the one before has left.
  auto weight = mesh.add_property_map<edge_descriptor, double>("e:weight", 0).first;
  const auto product = CGAL::parameters::edge_weight_map(weight);
  const bool is_weighed
    = SMC::painted_weights(mesh, weight, paint)
      && SMC::crease_weights(mesh, weight, product.smallest_factor(0.2).smallest_convex_factor(0.6)) // concave before convex
      && SMC::visibility_weights(mesh, weight, product.smallest_factor(0.2).up_direction(Kernel::Vector_3(0, 1, 0))); // not on top
  if(!is_weighed)
    return EXIT_FAILURE;

  auto is_cut = mesh.add_property_map<edge_descriptor, bool>("e:is_cut", false).first;
  const auto cost = [&]
  {
    double sum = 0;
    for(edge_descriptor e : edges(mesh))
      sum += is_cut[e] ? weight[e] : 0;
    return sum;
  };
  const auto shortest = SMC::greedy_cut(mesh, is_cut);
  const double cost_of_shortest = cost();
  const auto cheapest = SMC::greedy_cut(mesh, is_cut, CGAL::parameters::edge_weight_map(weight));
  if(!shortest || !cheapest)
    return EXIT_FAILURE;
  std::cout << "without weights: length " << shortest.cut_length << ", cost " << cost_of_shortest << "\n"
            << "with weights:    length " << cheapest.cut_length << ", cost " << cost() << std::endl;
  return cost() < cost_of_shortest ? EXIT_SUCCESS : EXIT_FAILURE;
}
