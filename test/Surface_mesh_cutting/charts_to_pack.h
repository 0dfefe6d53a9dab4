// Charts to pack, and what packed charts are checked for.

#ifndef CGAL_TEST_SURFACE_MESH_CUTTING_CHARTS_TO_PACK_H
#define CGAL_TEST_SURFACE_MESH_CUTTING_CHARTS_TO_PACK_H

#include "../BGL/check.h"

#include <CGAL/Surface_mesh_cutting/certify_packing.h>
#include <CGAL/Surface_mesh_cutting/pack_charts.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

using CGAL::Surface_mesh_cutting::Effort;
using CGAL::Surface_mesh_cutting::Status_code;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using UV_map = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
using Cut_map = Mesh::Property_map<Mesh::Edge_index, bool>;
namespace parameters = CGAL::parameters;

// Charts without any cut: each a part of the mesh. Their UVs are their points.
struct Charts
{
  Mesh mesh;
  UV_map uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  Cut_map is_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:cut", false).first;

  // A polygon that sees its whole border from `center`.
  void add(const std::vector<Kernel::Point_2>& polygon, const Kernel::Point_2& center)
  {
    std::vector<Mesh::Vertex_index> vertices;
    for(const Kernel::Point_2& p : polygon)
      vertices.push_back(mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), 0)));
    const Mesh::Vertex_index middle = mesh.add_vertex(Kernel::Point_3(center.x(), center.y(), 0));
    for(std::size_t i = 0; i < vertices.size(); ++i)
      mesh.add_face(vertices[i], vertices[(i + 1) % vertices.size()], middle);
    put_uvs();
  }

  void add_triangles(const std::vector<Kernel::Point_2>& points, const std::vector<std::array<int, 3> >& triangles)
  {
    std::vector<Mesh::Vertex_index> vertices;
    for(const Kernel::Point_2& p : points)
      vertices.push_back(mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), 0)));
    for(const auto& t : triangles)
      mesh.add_face(vertices[std::size_t(t[0])], vertices[std::size_t(t[1])], vertices[std::size_t(t[2])]);
    put_uvs();
  }

  void put_uvs()
  {
    for(const Mesh::Halfedge_index h : mesh.halfedges())
    {
      const Kernel::Point_3& p = mesh.point(mesh.target(h));
      uv[h] = Kernel::Point_2(p.x(), p.y());
    }
  }
};

// With property maps of its own.
inline Charts copy_of(const Charts& charts)
{
  Charts copy;
  copy.mesh = charts.mesh;
  copy.uv = copy.mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  copy.is_cut = copy.mesh.add_property_map<Mesh::Edge_index, bool>("e:cut").first;
  return copy;
}

inline double area_of(const Charts& charts)
{
  double area = 0;
  for(const auto f : charts.mesh.faces())
  {
    const auto h = charts.mesh.halfedge(f);
    area += CGAL::area(charts.uv[h], charts.uv[charts.mesh.next(h)], charts.uv[charts.mesh.prev(h)]);
  }
  return area;
}

inline Charts random_stars(CGAL::Random& random, int number)
{
  Charts charts;
  for(int i = 0; i < number; ++i)
  {
    const double size = std::exp(random.get_double(-1.5, 1));
    const int corners = random.get_int(3, 24);
    const Kernel::Point_2 center(random.get_double(0, 5), random.get_double(0, 5));
    std::vector<Kernel::Point_2> polygon;
    for(int k = 0; k < corners; ++k)
    {
      const double angle = 2 * CGAL_PI * k / corners, radius = size * random.get_double(0.3, 1);
      polygon.emplace_back(center.x() + radius * std::cos(angle), center.y() + radius * std::sin(angle));
    }
    charts.add(polygon, center);
  }
  return charts;
}

// From the definition: all pairs of border edges, in exact arithmetic. Each part has to be on one of the pages.
inline void check_distances(const Charts& charts, double texels, int texture_size, int number_of_pages = 1)
{
  using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const auto exact = [](const Kernel::Point_2& p) { return Exact::Point_2(p.x(), p.y()); };
  const Mesh& mesh = charts.mesh;
  auto part = mesh.number_of_faces() > 0 ? std::vector<int>(mesh.number_of_vertices(), -1) : std::vector<int>();
  int parts = 0;
  for(const auto v : mesh.vertices()) // by flooding
  {
    if(part[v] >= 0)
      continue;
    std::vector<Mesh::Vertex_index> stack(1, v);
    part[v] = parts;
    while(!stack.empty())
    {
      const Mesh::Vertex_index u = stack.back();
      stack.pop_back();
      for(const auto h : halfedges_around_target(u, mesh))
        if(part[source(h, mesh)] < 0)
        {
          part[source(h, mesh)] = parts;
          stack.push_back(source(h, mesh));
        }
    }
    ++parts;
  }
  std::vector<std::pair<int, Exact::Segment_2> > borders;
  for(const auto h : mesh.halfedges())
    if(!mesh.is_border(h) && mesh.is_border(mesh.opposite(h)))
      borders.emplace_back(part[target(h, mesh)],
                           Exact::Segment_2(exact(charts.uv[mesh.prev(h)]), exact(charts.uv[h])));
  std::vector<Kernel::Vector_2> corners(std::size_t(parts), Kernel::Vector_2(-1, -1)); // of the pages of parts
  for(const auto h : mesh.halfedges())
    if(Kernel::Vector_2& corner = corners[std::size_t(part[target(h, mesh)])]; !mesh.is_border(h) && corner.x() < 0)
    {
      const Kernel::Point_2 middle = CGAL::centroid(charts.uv[h], charts.uv[mesh.next(h)], charts.uv[mesh.prev(h)]);
      corner = Kernel::Vector_2(std::floor(middle.x()), std::floor(middle.y()));
      CHECK(corner.x() >= 0 && corner.x() < 10 && corner.y() >= 0 && corner.x() + 10 * corner.y() < number_of_pages);
    }
  const CGAL::Exact_rational least = CGAL::Exact_rational(texels) * texels, size = texture_size;
  for(std::size_t i = 0; i < borders.size(); ++i)
  {
    const Kernel::Vector_2& corner = corners[std::size_t(borders[i].first)];
    for(const Exact::Point_2& p : {borders[i].second.source(), borders[i].second.target()})
      for(const CGAL::Exact_rational& coordinate : {CGAL::Exact_rational(p.x() - corner.x()), CGAL::Exact_rational(p.y() - corner.y())})
        CHECK(coordinate * size >= texels && (1 - coordinate) * size >= texels);
    for(std::size_t j = 0; j < i; ++j)
      if(borders[i].first != borders[j].first)
        CHECK(CGAL::squared_distance(borders[i].second, borders[j].second) * size * size >= least);
  }
}

// Every triangle is similar to what it was, by the same factor, and not mirrored.
inline void check_similarity(const Charts& charts, double scale)
{
  for(const auto f : charts.mesh.faces())
  {
    const auto h = charts.mesh.halfedge(f), n = charts.mesh.next(h);
    const auto former = [&](Mesh::Halfedge_index i)
    {
      const Kernel::Point_3& p = charts.mesh.point(charts.mesh.target(i));
      return Kernel::Point_2(p.x(), p.y());
    };
    const Kernel::Vector_2 a = former(n) - former(h), b = charts.uv[n] - charts.uv[h];
    CHECK(std::abs(std::sqrt(b * b) - scale * std::sqrt(a * a)) < 1e-12);
    const auto p = charts.mesh.prev(h);
    CHECK(CGAL::orientation(charts.uv[h], charts.uv[n], charts.uv[p]) == CGAL::LEFT_TURN);
  }
}

#endif // CGAL_TEST_SURFACE_MESH_CUTTING_CHARTS_TO_PACK_H
