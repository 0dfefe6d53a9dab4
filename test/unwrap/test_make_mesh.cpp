// Meshes of random soups against those that CGAL::Euler::add_faces() makes of their faces one by one.

#undef NDEBUG
#include "make_mesh.h"

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <CGAL/Random.h>

#ifndef CGAL_SEPARATE_IMPLEMENTATION
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/read_soup.h>
#endif

#include <cassert>
#include <cstddef>
#include <iostream>
#include <vector>

using CGAL::Surface_mesh_cutting::internal::Point;
using CGAL::Surface_mesh_cutting::internal::Polygons;
using CGAL::Surface_mesh_cutting::internal::Soup_surface;

constexpr auto execution = CGAL::Surface_mesh_parameterization::internal::execution_of<CGAL::Parallel_if_available_tag>();

// The fewer points, the more polygons meet at each of them.
Soup_surface random_surface(CGAL::Random& random)
{
  std::vector<Point> points(std::size_t(random.get_int(4, 40)));
  for(Point& p : points)
    p = Point(random.get_double(), random.get_double(), random.get_double());
  Polygons polygons;
  const int largest_size = random.get_int(3, 6);
  for(int f = random.get_int(1, 60); f > 0; --f)
  {
    for(int k = random.get_int(3, largest_size + 1); k > 0; --k)
      polygons.vertices.push_back(random.get_int(0, int(points.size())));
    polygons.close();
  }
  return CGAL::Surface_mesh_cutting::internal::read_soup(
    points, polygons, {CGAL::Surface_mesh_cutting::internal::Welding::ON, 0, {}}, execution);
}

Mesh add_one_by_one(const Soup_surface& surface)
{
  Mesh mesh;
  for(const Point& p : surface.points)
    mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
  std::vector<std::vector<Vertex> > faces;
  for(int f = 0; f < surface.polygons.number(); ++f)
  {
    faces.emplace_back();
    for(int c = surface.polygons.begin(f); c < surface.polygons.end(f); ++c)
      faces.back().push_back(Vertex(Mesh::size_type(surface.polygons.vertices[std::size_t(c)])));
  }
  CGAL::Euler::add_faces(faces, mesh);
  return mesh;
}

void test(const Soup_surface& surface)
{
  const std::vector<Halfedge> halfedges = number_halfedges(surface);
  const Mesh mesh = make_mesh(surface, halfedges), expected = add_one_by_one(surface);
  assert(mesh.is_valid());
  assert(mesh.number_of_vertices() == expected.number_of_vertices());
  assert(mesh.number_of_halfedges() == expected.number_of_halfedges());
  assert(mesh.number_of_faces() == expected.number_of_faces());
  for(const Vertex v : expected.vertices())
  {
    assert(mesh.point(v) == expected.point(v));
    assert(mesh.is_isolated(v) == expected.is_isolated(v));
    if(mesh.is_isolated(v))
      continue;
    bool is_on_border = false;
    for(const Halfedge h : expected.halfedges_around_target(expected.halfedge(v)))
      is_on_border = is_on_border || expected.is_border(h);
    assert(mesh.is_border(mesh.halfedge(v)) == is_on_border);
  }
  for(const Halfedge h : expected.halfedges())
  {
    assert(mesh.target(h) == expected.target(h));
    assert(mesh.face(h) == expected.face(h));
    assert(mesh.next(h) == expected.next(h));
    assert(mesh.prev(h) == expected.prev(h));
  }
  for(const Face f : expected.faces())
  {
    const bool is_triangle = surface.polygons.size(int(f)) == 3;
    assert(mesh.halfedge(f) == (is_triangle ? expected.halfedge(f) : expected.next(expected.halfedge(f))));
    assert(mesh.halfedge(f) == (is_triangle ? halfedges[std::size_t(surface.polygons.end(int(f)) - 1)]
                                            : halfedges[std::size_t(surface.polygons.begin(int(f)))]));
  }
}

int main()
{
  CGAL::Random random(20261126);
  std::cout << "seed " << random.get_seed() << std::endl;
  for(int i = 0; i < 2000; ++i)
    test(random_surface(random));
  return 0;
}
