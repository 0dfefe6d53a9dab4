// What CGAL's own parameterizer of low distortion costs to compile: the measure of ours.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char** argv)
{
  Mesh mesh;
  if(argc < 2 || !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) return 1;
  const Mesh::Halfedge_index border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const auto status = CGAL::Surface_mesh_parameterization::parameterize(
    mesh, CGAL::Surface_mesh_parameterization::ARAP_parameterizer_3<Mesh>(), border, uv);
  return status == CGAL::Surface_mesh_parameterization::OK ? 0 : 1;
}
