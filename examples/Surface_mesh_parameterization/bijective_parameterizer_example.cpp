#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Surface_mesh_parameterization/Bijective_symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/distortion_measures.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace SMP = CGAL::Surface_mesh_parameterization;

typedef CGAL::Simple_cartesian<double>                            Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>                       Surface_mesh;
typedef boost::graph_traits<Surface_mesh>::vertex_descriptor      vertex_descriptor;
typedef boost::graph_traits<Surface_mesh>::halfedge_descriptor    halfedge_descriptor;
typedef Surface_mesh::Property_map<vertex_descriptor, Kernel::Point_2> UV_map;

// A ramp with one and a half turns: laid flat, its two ends lie on top of each other.
Surface_mesh make_ramp()
{
  Surface_mesh mesh;
  const int length = 90, width = 6;
  for(int i = 0; i <= length; ++i)
    for(int j = 0; j <= width; ++j) {
      const double angle = 3 * CGAL_PI * i / length, radius = 2 + double(j) / width;
      mesh.add_vertex(Kernel::Point_3(radius * std::cos(angle), radius * std::sin(angle), 0.2 * angle));
    }
  for(int i = 0; i < length; ++i)
    for(int j = 0; j < width; ++j) {
      const vertex_descriptor a(i * (width + 1) + j), b(a + 1), c(a + width + 1), d(c + 1);
      mesh.add_face(a, b, d);
      mesh.add_face(a, d, c);
    }
  return mesh;
}

// Maps the mesh and prints how much it is distorted.
template <typename Parameterizer>
bool flatten(Surface_mesh& mesh, const char* name)
{
  UV_map uv_map = mesh.add_property_map<vertex_descriptor, Kernel::Point_2>("v:uv").first;
  const halfedge_descriptor border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  const SMP::Error_code error = SMP::parameterize(mesh, Parameterizer(), border, uv_map);
  if(error != SMP::OK) {
    std::cerr << "Error: no parameterization, code " << error << std::endl;
    return false;
  }
  const auto halfedge_uv_map = boost::make_function_property_map<halfedge_descriptor>(
    [&](halfedge_descriptor h) { return get(uv_map, target(h, mesh)); });
  std::cout << name << ": "
            << SMP::compute_symmetric_Dirichlet_energy(mesh, halfedge_uv_map, boost::dummy_property_map())
            << " (without distortion: 4)" << std::endl;
  return true;
}

int main()
{
  Surface_mesh mesh = make_ramp();
  const bool is_flat
    = flatten<SMP::Symmetric_Dirichlet_parameterizer_3<Surface_mesh> >(mesh, "overlapping")
   && flatten<SMP::Bijective_symmetric_Dirichlet_parameterizer_3<Surface_mesh> >(mesh, "one to one");
  return is_flat ? EXIT_SUCCESS : EXIT_FAILURE;
}
