// Factorizations and CPU time of both parameterizers with all linear solvers, as CSV, for the meshes
// of a folder (default: CGAL's data set) that are closed, connected and of genus 0. Each is opened
// along a shortest path between two distant vertices, which makes for the hardest maps there are.

#include <CGAL/Surface_mesh_parameterization/internal/Chart_parameterizer.h>
#include <CGAL/Surface_mesh_parameterization/internal/chart/Mesh_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear_solver/make_solvers.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>

#ifdef CGAL_SURFACE_MESH_CUTTING_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using edge_descriptor = boost::graph_traits<Mesh>::edge_descriptor;
using Edge_map = Mesh::Property_map<edge_descriptor, bool>;
using Vertex_map = Mesh::Property_map<vertex_descriptor, bool>;
using Seam_mesh = CGAL::Seam_mesh<Mesh, Edge_map, Vertex_map>;

// The vertex farthest from `v`, and the path to it; null if the mesh is not connected.
vertex_descriptor farthest(const Mesh& mesh, vertex_descriptor v,
                           std::vector<vertex_descriptor>& predecessors)
{
  const double infinity = (std::numeric_limits<double>::max)();
  std::vector<double> distances(num_vertices(mesh), infinity);
  predecessors.resize(num_vertices(mesh));
  const auto index = get(boost::vertex_index, mesh);
  boost::dijkstra_shortest_paths(mesh, v,
    boost::distance_map(boost::make_iterator_property_map(distances.begin(), index))
    .predecessor_map(boost::make_iterator_property_map(predecessors.begin(), index)));
  const auto it = std::max_element(distances.begin(), distances.end());
  return *it == infinity ? Mesh::null_vertex() : vertex_descriptor(int(it - distances.begin()));
}

// False if the mesh is not of the kind that can be opened along one path.
bool open(Mesh& mesh, Mesh_chart<Seam_mesh>& chart)
{
  const int characteristic = int(num_vertices(mesh)) - int(num_edges(mesh)) + int(num_faces(mesh));
  if(!is_triangle_mesh(mesh) || !is_closed(mesh) || characteristic != 2)
    return false;
  std::vector<vertex_descriptor> predecessors;
  const vertex_descriptor start = farthest(mesh, *vertices(mesh).begin(), predecessors);
  if(start == Mesh::null_vertex())
    return false;
  const vertex_descriptor end = farthest(mesh, start, predecessors);
  Seam_mesh seam(mesh, mesh.add_property_map<edge_descriptor, bool>("", false).first,
                 mesh.add_property_map<vertex_descriptor, bool>("", false).first);
  for(vertex_descriptor v = end; v != start; v = predecessors[v])
    seam.add_seam(v, predecessors[v]);
  const auto h = CGAL::halfedge(end, predecessors[end], mesh).first;
  return chart.read(seam, boost::graph_traits<Seam_mesh>::halfedge_descriptor(h, true)) == OK;
}

template <typename Solve>
void measure(const std::string& prefix, const char* parameterizer, const char* solver,
             const Solvers& linear_solvers, const Mesh_chart<Seam_mesh>& chart, const Solve& solve)
{
  const std::clock_t start = std::clock();
  const std::vector<Rest_shape> shapes = rest_shapes(chart.chart().triangles(), chart.points());
  Chart_parameterizer method(chart.chart(), chart.points(), shapes, linear_solvers);
  std::vector<Eigen::Vector2d> uv;
  const Newton_result result = solve(method, uv);
  const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  std::cout << prefix << ',' << parameterizer << ',' << solver << ',' << result.iterations << ','
            << seconds << ',' << result.energy << ',' << result.is_converged() << std::endl;
}

template <typename Solver>
void measure_both(const std::string& prefix, const char* name, const Solver& solver,
                  const Mesh_chart<Seam_mesh>& chart)
{
  const Solvers linear_solvers = make_solvers(solver);
  measure(prefix, "MIPS", name, linear_solvers, chart, [](auto& method, auto& uv)
          { return method.conformal_map(uv, Newton_options()); });
  measure(prefix, "symmetric Dirichlet", name, linear_solvers, chart, [](auto& method, auto& uv)
          { return method.isometric_map(uv, Newton_options()); });
}

int main(int argc, char* argv[])
{
  const std::string folder = argc > 1 ? argv[1] : CGAL::data_file_path("meshes");
  std::vector<std::filesystem::path> files;
  for(const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::cout << "mesh,triangles,parameterizer,solver,factorizations,cpu_seconds,energy,converged\n";
  for(const std::filesystem::path& file : files)
  {
    Mesh mesh;
    Mesh_chart<Seam_mesh> chart;
    const std::string extension = file.extension().string();
    if((extension != ".off" && extension != ".obj" && extension != ".ply") ||
       !CGAL::IO::read_polygon_mesh(file.string(), mesh) || !open(mesh, chart))
      continue;
    const std::string prefix = file.stem().string() + ',' + std::to_string(num_faces(mesh));
    measure_both(prefix, "supernodal", CGAL::Default(), chart);
#ifdef CGAL_SURFACE_MESH_CUTTING_WITH_CHOLMOD
    using Cholmod = Eigen::CholmodSupernodalLLT<Sparse_matrix, Eigen::Upper>;
    measure_both(prefix, "CHOLMOD", CGAL::Eigen_solver_traits<Cholmod>(), chart);
#endif
  }
  return EXIT_SUCCESS;
}
