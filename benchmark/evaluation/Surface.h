#ifndef EVALUATION_SURFACE_H
#define EVALUATION_SURFACE_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_cutting/internal/detection/candidates.h>
#include <CGAL/Surface_mesh_cutting/internal/surface/Topology.h>
#include <CGAL/Surface_mesh_cutting/internal/input/Mesh_adapter.h>

#include <string>
#include <utility>
#include <vector>

namespace SMC = CGAL::Surface_mesh_cutting;
namespace Internal = CGAL::Surface_mesh_cutting::internal;
namespace SMP = CGAL::Surface_mesh_parameterization::internal;

typedef CGAL::Simple_cartesian<double>      Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

// What all detectors work on: a closed connected surface of genus 0, in arrays. Vertices have the
// indices of the mesh that was read.
struct Surface
{
  Internal::Indexed_mesh mesh;
  std::vector<SMP::Rest_shape> shapes;
};

// What a detector found, or why it found nothing; processor seconds, those for filtering apart.
struct Detection
{
  std::string failure;
  std::vector<int> features;
  double seconds = 0, filter_seconds = 0;
};

// Empty if the detectors can work on the mesh; otherwise why they cannot.
inline std::string make_surface(const Mesh& mesh, Surface& surface)
{
  typedef boost::property_map<Mesh, CGAL::vertex_point_t>::const_type Point_map;
  const Internal::Mesh_adapter<Mesh, Point_map> adapter(mesh, get(CGAL::vertex_point, mesh));
  if(!adapter.status())
    return adapter.status().finding.message;
  surface.mesh = adapter.mesh();
  for(int v = 0; v < surface.mesh.number_of_vertices(); ++v)
    if(surface.mesh.is_isolated(v))
      return "isolated vertex";
  const Internal::Corner_table chart = Internal::make_chart(surface.mesh, Internal::Cut(surface.mesh.number_of_edges(), 0));
  const Internal::Connected_parts parts(chart.opposites());
  const auto topology = Internal::topologies(chart, parts).front();
  if(parts.number != 1 || topology.genus() != 0 || topology.border_loops != 0)
    return "not a closed connected surface of genus 0";
  surface.shapes = SMP::rest_shapes(surface.mesh.triangles(), surface.mesh.points());
  return "";
}

#endif // EVALUATION_SURFACE_H
