// How much of the view from outside an edge of a surface is in.

#ifndef SURFACE_MESH_CUTTING_BENCHMARK_SEEN_SHARE_H
#define SURFACE_MESH_CUTTING_BENCHMARK_SEEN_SHARE_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#if CGAL_VERSION_NR < 1060000000
#include <CGAL/AABB_traits.h>
#else
#include <CGAL/AABB_traits_3.h>
#endif
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/number_type_config.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

// By the rays of a Fibonacci lattice, one for each of about as many equal parts of the sphere. Where the package looks
// along random directions, these are the same for all edges and evenly spread.
class Seen_share
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Vector_3 = Kernel::Vector_3;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
#if CGAL_VERSION_NR < 1060000000
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive> >;
#else
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive> >;
#endif

public:
  // Seen from all around, or from the hemisphere around `up`. Keeps a reference to the mesh.
  Seen_share(const Mesh& mesh, std::optional<Vector_3> up)
    : m_mesh(mesh), m_up(std::move(up)), m_tree(faces(mesh).first, faces(mesh).second, mesh),
      m_outside(CGAL::is_closed(mesh) && CGAL::Polygon_mesh_processing::volume(mesh) < 0 ? -1 : 1)
  {
    constexpr int number_of_directions = 600;
    const double golden_angle = CGAL_PI * (3 - std::sqrt(5.));
    for(int i = 0; i < number_of_directions; ++i)
    {
      const double z = 1 - (2 * i + 1.) / number_of_directions, radius = std::sqrt(1 - z * z);
      m_directions.emplace_back(radius * std::cos(golden_angle * i), radius * std::sin(golden_angle * i), z);
    }
    m_tree.build();
  }

  // Of the directions above the horizon, weighted by the cosine of their angle with its axis, those from which the
  // middle of the edge is seen. The horizon is that of the edge where it is seen from all around.
  double operator()(Mesh::Edge_index e) const
  {
    namespace PMP = CGAL::Polygon_mesh_processing;
    const auto h = m_mesh.halfedge(e);
    Vector_3 normal = CGAL::NULL_VECTOR;
    for(const auto side : {h, m_mesh.opposite(h)})
      if(!m_mesh.is_border(side))
        normal = normal + m_outside * PMP::compute_face_normal(m_mesh.face(side), m_mesh);
    normal = normal / std::sqrt(normal.squared_length());
    const auto origin = CGAL::midpoint(m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h))) +
                        1e-3 * PMP::edge_length(h, m_mesh) * normal;
    const Vector_3& axis = m_up ? *m_up : normal;
    double seen = 0, all = 0;
    for(const Vector_3& direction : m_directions)
    {
      const double cosine = direction * axis;
      if(cosine <= 0)
        continue;
      all += cosine;
      if(direction * normal > 0 && !m_tree.do_intersect(Kernel::Ray_3(origin, direction)))
        seen += cosine;
    }
    return seen / all;
  }

private:
  const Mesh& m_mesh;
  const std::optional<Vector_3> m_up; // of length 1
  Tree m_tree;
  const int m_outside; // the sign of the side to which the normals of faces point
  std::vector<Vector_3> m_directions;
};

#endif // SURFACE_MESH_CUTTING_BENCHMARK_SEEN_SHARE_H
