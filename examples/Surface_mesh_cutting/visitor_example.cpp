#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_cutting/greedy_cut.h>

#include <functional>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double>        Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>   Mesh;
typedef boost::graph_traits<Mesh>::edge_descriptor edge_descriptor;

namespace SMC = CGAL::Surface_mesh_cutting;

// Shows the progress and ends the run as soon as the candidates are filtered.
struct Impatient_visitor : public SMC::Default_visitor
{
  SMC::Phase phase = SMC::Phase::CANDIDATES;

  bool go_further() const { return phase != SMC::Phase::CONNECT; }

  void progress(SMC::Phase current, double fraction)
  {
    phase = current;
    std::cout << int(100 * fraction) << " %: " << to_string(current) << "\n";
  }
};

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/cow.off");
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(filename, mesh))
  {
    std::cerr << "cannot read " << filename << std::endl;
    return EXIT_FAILURE;
  }

  Mesh::Property_map<edge_descriptor, bool> is_cut
    = mesh.add_property_map<edge_descriptor, bool>("e:is_cut", false).first;
  Impatient_visitor visitor;
  const SMC::Cut_result<Mesh> result
    = SMC::greedy_cut(mesh, is_cut, CGAL::parameters::visitor(std::ref(visitor)));
  std::cout << result.status.message << (result.has_result ? "; the best cut so far is marked" : "") << std::endl;
  return result.status.code == SMC::Status_code::STOPPED ? EXIT_SUCCESS : EXIT_FAILURE;
}
