#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_cutting/greedy_cut.h>

#include <algorithm>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double>        Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>   Mesh;
typedef boost::graph_traits<Mesh>::edge_descriptor edge_descriptor;

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

  // The components are treated at the same time by the threads of oneTBB.
  auto is_cut = mesh.add_property_map<edge_descriptor, bool>("e:is_cut", false).first;
  CGAL::Real_timer parallel_timer, sequential_timer;
  parallel_timer.start();
  const auto parallel = SMC::greedy_cut<CGAL::Parallel_if_available_tag>(mesh, is_cut);
  parallel_timer.stop();
  auto is_cut_by_one_thread = mesh.add_property_map<edge_descriptor, bool>("e:is_cut_by_one_thread", false).first;
  sequential_timer.start();
  const auto sequential = SMC::greedy_cut(mesh, is_cut_by_one_thread);
  sequential_timer.stop();
  if(!parallel || !sequential)
  {
    std::cerr << parallel.status.message << sequential.status.message << std::endl;
    return EXIT_FAILURE;
  }

  // Every bit is the same.
  const bool is_same = std::all_of(edges(mesh).begin(), edges(mesh).end(), [&](edge_descriptor e)
                                   { return is_cut[e] == is_cut_by_one_thread[e]; });
  std::cout << parallel.components << " components: " << parallel_timer.time() << " s instead of "
            << sequential_timer.time() << " s, " << (is_same ? "the same" : "another") << " cut" << std::endl;
  return is_same ? EXIT_SUCCESS : EXIT_FAILURE;
}
