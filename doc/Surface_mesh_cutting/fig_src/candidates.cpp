// The two paths along which the method opens a surface and the candidates that they yield, for the
// figure of the user manual: writes PREFIX.first.obj and PREFIX.second.obj.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/candidates.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers.h>

#include <fstream>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace engine = CGAL::Surface_mesh_parameterization::internal;
namespace internal = CGAL::Surface_mesh_cutting::internal;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Vertex_point_map = boost::property_map<Mesh, CGAL::vertex_point_t>::const_type;

void write(const std::string& file, const Mesh& mesh, const internal::Indexed_mesh& flat,
           const std::vector<int>& path, const std::vector<int>& points)
{
  std::ofstream out(file);
  out.precision(17);
  for(Mesh::Vertex_index v : vertices(mesh))
    out << "v " << mesh.point(v) << "\n";
  for(int e : path)
    out << "l " << flat.source(flat.halfedge(e)) + 1 << " " << flat.target(flat.halfedge(e)) + 1 << "\n";
  for(int v : points)
    out << "p " << v + 1 << "\n";
}

int main(int argc, char** argv)
{
  Mesh mesh;
  if(argc != 3 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh))
  {
    std::cerr << "usage: candidates MESH PREFIX" << std::endl;
    return EXIT_FAILURE;
  }
  const internal::Mesh_adapter<Mesh, Vertex_point_map> adapter(mesh, get(CGAL::vertex_point, mesh));
  const internal::Indexed_mesh& flat = adapter.mesh();
  const auto shapes
    = engine::rest_shapes(flat.triangles(), flat.points());
  internal::Cutting_parameters parameters;
  parameters.linear_solvers = std::make_shared<engine::Solvers>(engine::default_solvers());
  internal::Run_control control;
  const auto maximizers = [&](const std::vector<int>& path)
  {
    return internal::local_maximizers(
      flat, internal::proxy_distortion(flat, shapes, internal::make_cut(flat, path), parameters, control));
  };

  // The first start of `Feature_detector`.
  std::mt19937 engine(parameters.random_seed);
  const int start = int(engine() % std::mt19937::result_type(flat.number_of_vertices()));
  const std::vector<int> first = internal::path_to_farthest_vertex(flat, start, parameters.number_of_sweeps());
  const std::vector<int> first_points = maximizers(first);
  const std::vector<int> second = internal::second_cut(flat, start, first, first_points, parameters, control);
  const std::string prefix = argv[2];
  write(prefix + ".first.obj", mesh, flat, first, first_points);
  write(prefix + ".second.obj", mesh, flat, second, maximizers(second));
  return EXIT_SUCCESS;
}
