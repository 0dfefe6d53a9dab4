// Meshes of all types to test with.

#ifndef TEST_MESHES_H
#define TEST_MESHES_H

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <vector>

namespace test {

using Inexact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Exact_kernel>;
using Linear_cell_complex = CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<
  2, 3, CGAL::Linear_cell_complex_traits<3, Inexact_kernel> >::type;

struct Soup
{
  std::vector<std::array<double, 3> > points;
  std::vector<std::vector<std::size_t> > faces;

  void scale(double factor)
  {
    for(std::array<double, 3>& p : points)
      for(double& x : p)
        x *= factor;
  }

  // Side by side.
  void add(const Soup& other)
  {
    const std::size_t first = points.size();
    for(std::array<double, 3> p : other.points)
    {
      p[2] += 10;
      points.push_back(p);
    }
    for(std::vector<std::size_t> f : other.faces)
    {
      for(std::size_t& v : f)
        v += first;
      faces.push_back(f);
    }
  }
};

// m by n squares, halved; closed in none, one or both directions.
inline Soup quads(int m, int n, bool is_closed_m, bool is_closed_n)
{
  Soup soup;
  const int rows = m + !is_closed_m, columns = n + !is_closed_n;
  for(int i = 0; i < rows; ++i)
    for(int j = 0; j < columns; ++j)
    {
      const double a = 2 * CGAL_PI * i / m, b = 2 * CGAL_PI * j / n;
      if(is_closed_m && is_closed_n)
        soup.points.push_back({(3 + std::cos(b)) * std::cos(a), (3 + std::cos(b)) * std::sin(a), std::sin(b)});
      else if(is_closed_m)
        soup.points.push_back({std::cos(a), std::sin(a), double(j)});
      else
        soup.points.push_back({double(i), double(j), 0.1 * i * j});
    }
  for(int i = 0; i < m; ++i)
    for(int j = 0; j < n; ++j)
    {
      const std::size_t a = i * columns + j, b = (i + 1) % rows * columns + j;
      const std::size_t c = (i + 1) % rows * columns + (j + 1) % columns, d = i * columns + (j + 1) % columns;
      soup.faces.push_back({a, b, c});
      soup.faces.push_back({a, c, d});
    }
  return soup;
}

inline Soup torus(int m, int n) { return quads(m, n, true, true); }
inline Soup tube(int m, int n) { return quads(m, n, true, false); }
inline Soup patch(int m, int n) { return quads(m, n, false, false); }

// A tube with both ends closed by a fan.
inline Soup sphere(int m, int n)
{
  Soup soup = tube(m, n);
  const std::size_t low = soup.points.size(), high = low + 1;
  soup.points.push_back({0, 0, -1});
  soup.points.push_back({0, 0, n + 1.});
  for(int i = 0; i < m; ++i)
  {
    const std::size_t a = i * (n + 1), b = (i + 1) % m * (n + 1);
    soup.faces.push_back({b, a, low});
    soup.faces.push_back({a + n, b + n, high});
  }
  return soup;
}

// A sphere with bumps: `n` rings, smooth, no two parts alike.
inline Soup bumpy_sphere(int n)
{
  Soup soup = sphere(2 * n, n);
  for(std::array<double, 3>& p : soup.points)
  {
    const double polar = CGAL_PI * (p[2] + 1) / (n + 2), around = std::atan2(p[1], p[0]);
    const double radius = 1 + 0.5 * std::sin(3 * polar) * std::cos(2 * around) + 0.3 * std::cos(5 * polar);
    p = {radius * std::sin(polar) * std::cos(around), radius * std::sin(polar) * std::sin(around),
         1.5 * radius * std::cos(polar)};
  }
  return soup;
}

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

#endif // TEST_MESHES_H
