// Meshes from soups.

#ifndef SURFACE_MESHES_H
#define SURFACE_MESHES_H

#include "soups.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <vector>

namespace test {

using Surface_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

template <typename Mesh>
Mesh make_mesh(const Soup& soup)
{
  using Point = typename boost::property_traits<typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type;
  std::vector<Point> points;
  for(const std::array<double, 3>& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, soup.faces, mesh);
  return mesh;
}

// The same with removed vertices, edges and faces before and after those that stay.
inline Surface_mesh make_mesh_with_garbage(const Soup& soup)
{
  Soup more = patch(2, 2);
  const std::size_t faces_before = more.faces.size(), points_before = more.points.size();
  more.add(soup);
  more.add(patch(1, 2));
  Surface_mesh mesh = make_mesh<Surface_mesh>(more);
  for(std::size_t f = 0; f < more.faces.size(); ++f)
    if(f < faces_before || f >= faces_before + soup.faces.size())
      CGAL::Euler::remove_face(mesh.halfedge(Surface_mesh::Face_index(Surface_mesh::size_type(f))), mesh);
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    mesh.point(Surface_mesh::Vertex_index(Surface_mesh::size_type(points_before + v)))
      = Surface_mesh::Point(soup.points[v][0], soup.points[v][1], soup.points[v][2]);
  return mesh;
}

} // namespace test

#endif // SURFACE_MESHES_H
