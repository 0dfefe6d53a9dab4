// Makes one shape at several sizes: the mesh is subdivided until it is large enough for the largest, then simplified
// from size to size. Writes FOLDER/shape_FACES.ply for each.
//
//   make_sizes FOLDER [MESH [FACES...]]
//
// The defaults are CGAL's cow and sizes from 2,000 to 1,000,000 triangles.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/subdivision_method_3.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double>      Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

namespace SMS = CGAL::Surface_mesh_simplification;

int main(int argc, char** argv)
{
  const std::vector<std::string> words(argv + 1, argv + argc);
  Mesh mesh;
  if(words.empty() ||
     !CGAL::IO::read_polygon_mesh(words.size() > 1 ? words[1] : CGAL::data_file_path("meshes/cow.off"), mesh))
  {
    std::cerr << "usage: " << argv[0] << " FOLDER [MESH [FACES...]]\n";
    return EXIT_FAILURE;
  }
  std::vector<int> sizes = {2000, 5000, 10000, 20000, 50000, 100000, 200000, 500000, 1000000};
  if(words.size() > 2)
    sizes.clear();
  for(std::size_t i = 2; i < words.size(); ++i)
    sizes.push_back(std::atoi(words[i].c_str()));
  std::sort(sizes.begin(), sizes.end(), std::greater<int>());

  while(int(num_faces(mesh)) < sizes.front())
    CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(1));
  for(int size : sizes)
  {
    // An edge collapse takes away two faces. CGAL's own predicate has another name in each of the versions 5 and 6.
    const std::size_t number_of_edges = num_edges(mesh) * std::size_t(size) / num_faces(mesh);
    const auto is_small_enough = [number_of_edges](const auto&, const auto&, std::size_t, std::size_t current) {
      return current < number_of_edges;
    };
    SMS::edge_collapse(mesh, is_small_enough);
    mesh.collect_garbage();
    const std::string file = words[0] + "/shape_" + std::to_string(size) + ".ply";
    if(!CGAL::IO::write_polygon_mesh(file, mesh, CGAL::parameters::stream_precision(17)))
    {
      std::cerr << "cannot write " << file << "\n";
      return EXIT_FAILURE;
    }
    std::cout << file << ": " << num_faces(mesh) << " triangles" << std::endl;
  }
  return EXIT_SUCCESS;
}
