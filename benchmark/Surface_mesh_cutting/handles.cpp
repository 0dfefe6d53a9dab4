// Handle loops: their length against those of an exhaustive search, and times.
//
//   handles [FOLDER [MESH_FILE...]]
//
// For each mesh with handles, or each of those named, one line: the length of the loops over the
// bounding box diagonal; the same without tolerance (on meshes of up to 5000 vertices), and the ratio; the time; and, for genus up to 5, the time on
// the mesh divided evenly into at least 100,000 triangles.

#include "mesh_files.h"

#include <CGAL/Surface_mesh_cutting/cut_handles.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/lengths.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace SMC = CGAL::Surface_mesh_cutting;
using namespace CGAL::Surface_mesh_cutting::internal;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Adapter
  = Mesh_adapter<Surface_mesh, boost::property_map<Surface_mesh, CGAL::vertex_point_t>::const_type>;

// Keeps the vertices where they are, and puts new ones in the middles of the edges.
struct Midpoint_mask
{
  const Surface_mesh& mesh;

  void edge_node(Surface_mesh::Halfedge_index h, Kernel::Point_3& p) const
  { p = CGAL::midpoint(mesh.point(source(h, mesh)), mesh.point(target(h, mesh))); }
  void vertex_node(Surface_mesh::Vertex_index v, Kernel::Point_3& p) const { p = mesh.point(v); }
  void border_node(Surface_mesh::Halfedge_index h, Kernel::Point_3& on_edge,
                   Kernel::Point_3& on_vertex) const
  {
    edge_node(h, on_edge);
    vertex_node(target(h, mesh), on_vertex);
  }
};

Surface_mesh subdivided(Surface_mesh mesh, std::size_t number_of_faces)
{
  while(num_faces(mesh) < number_of_faces)
    CGAL::Subdivision_method_3::PTQ(mesh, Midpoint_mask{mesh});
  return mesh;
}

// The greedy choice with a shortest loop in each step.
double exhaustive_length(const Indexed_mesh& mesh)
{
  return cut_length(mesh, cut_handles(mesh, unconstrained(mesh), always_go_further, 0.).cut);
}

double seconds_to_cut(const Surface_mesh& mesh, SMC::Handles_result<Surface_mesh>& result)
{
  CGAL::Real_timer timer;
  timer.start();
  result = SMC::cut_handles(mesh, get(CGAL::dynamic_edge_property_t<bool>(), mesh));
  return timer.time();
}

void measure(const std::filesystem::path& file)
{
  Surface_mesh mesh;
  SMC::Handles_result<Surface_mesh> result;
  if(!CGAL::IO::read_polygon_mesh(file.string(), mesh))
    return;
  const double seconds = seconds_to_cut(mesh, result);
  if(!result || result.loops.empty())
    return;
  const std::size_t genus = result.loops.size();
  const Adapter adapter(mesh, get(CGAL::vertex_point, mesh));
  const double diagonal = adapter.to_original_scale(bounding_box_diagonal(adapter.mesh()));
  std::cout << file.filename().string() << "," << num_vertices(mesh) << "," << num_faces(mesh)
            << "," << genus << "," << result.length / diagonal << ",";
  if(num_vertices(mesh) <= 5000)
  {
    const double best = adapter.to_original_scale(exhaustive_length(adapter.mesh()));
    std::cout << best / diagonal << "," << result.length / best;
  }
  else
    std::cout << ",";
  std::cout << "," << seconds << ",";
  if(genus <= 5)
  {
    const Surface_mesh fine = subdivided(mesh, 100000);
    const double fine_seconds = seconds_to_cut(fine, result);
    std::cout << num_faces(fine) << "," << fine_seconds;
  }
  else
    std::cout << ",";
  std::cout << std::endl;
}

int main(int argc, char** argv)
{
  std::cout << "file,vertices,faces,genus,length,exhaustive_length,ratio,seconds,"
               "subdivided_faces,subdivided_seconds\n";
  for(const std::filesystem::path& file : mesh_files(argc, argv))
    measure(file);
  return EXIT_SUCCESS;
}
