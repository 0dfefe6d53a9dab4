#include "make_mesh.h"

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>

#include <algorithm>
#include <cstddef>

namespace {

using CGAL::Surface_mesh_cutting::internal::Polygons;
using CGAL::Surface_mesh_cutting::internal::Soup_surface;
using namespace CGAL::Surface_mesh_parameterization::internal;

constexpr Execution execution = execution_of<CGAL::Parallel_if_available_tag>();

Halfedge opposite_of(Halfedge h) { return Halfedge(Mesh::size_type(h) ^ 1); }

Mesh::size_type number_of_edges(const Soup_surface& surface)
{
  const auto borders = std::count(surface.opposites.begin(), surface.opposites.end(), -1);
  return Mesh::size_type((surface.opposites.size() + std::size_t(borders)) / 2);
}

// Border halfedges get their targets from the face across.
void link_face(const Soup_surface& surface, int f, const std::vector<Halfedge>& halfedges, Mesh& mesh)
{
  const Polygons& polygons = surface.polygons;
  const int begin = polygons.begin(f), end = polygons.end(f);
  mesh.set_halfedge(Face(Mesh::size_type(f)), halfedges[std::size_t(polygons.size(f) > 3 ? begin : end - 1)]);
  for(int c = begin; c < end; ++c)
  {
    const Halfedge h = halfedges[std::size_t(c)];
    const std::size_t next = std::size_t(polygons.next(f, c));
    mesh.set_target(h, Vertex(Mesh::size_type(polygons.vertices[next])));
    if(surface.opposites[std::size_t(c)] < 0)
      mesh.set_target(opposite_of(h), Vertex(Mesh::size_type(polygons.vertices[std::size_t(c)])));
    mesh.set_face(h, Face(Mesh::size_type(f)));
    mesh.set_next(h, halfedges[next]);
  }
}

// Turns around the vertex, through its faces.
void link_border(Halfedge border, Mesh& mesh)
{
  Halfedge h = mesh.opposite(border);
  while(!mesh.is_border(h))
    h = mesh.opposite(mesh.prev(h));
  mesh.set_next(border, h);
}

} // namespace

std::vector<Halfedge> number_halfedges(const Soup_surface& surface)
{
  const Polygons& polygons = surface.polygons;
  std::vector<Halfedge> halfedges(polygons.vertices.size());
  Mesh::size_type next = 0;
  for(int p = 0; p < polygons.number(); ++p)
    for(int c = polygons.begin(p); c < polygons.end(p); ++c)
      if(polygons.vertices[std::size_t(c)] < polygons.vertices[std::size_t(polygons.next(p, c))])
      {
        halfedges[std::size_t(c)] = Halfedge(next);
        next += 2;
      }
  for(int p = 0; p < polygons.number(); ++p)
    for(int c = polygons.begin(p); c < polygons.end(p); ++c)
    {
      const std::size_t side = std::size_t(polygons.previous(p, c)); // the last one first
      if(halfedges[side] != Mesh::null_halfedge())
        continue;
      const int o = surface.opposites[side];
      halfedges[side] = opposite_of(o < 0 ? Halfedge(next) : halfedges[std::size_t(o)]);
      next += o < 0 ? 2 : 0;
    }
  return halfedges;
}

Mesh make_mesh(const Soup_surface& surface, const std::vector<Halfedge>& halfedges)
{
  Mesh mesh;
  mesh.resize(Mesh::size_type(surface.points.size()), number_of_edges(surface),
              Mesh::size_type(surface.polygons.number()));
  execute_blocks(execution, int(surface.points.size()), [&](int begin, int end)
  {
    for(int v = begin; v < end; ++v)
    {
      const CGAL::Surface_mesh_cutting::internal::Point& p = surface.points[std::size_t(v)];
      mesh.point(Vertex(Mesh::size_type(v))) = Kernel::Point_3(p.x(), p.y(), p.z());
    }
  });
  execute_blocks(execution, surface.polygons.number(), [&](int begin, int end)
  {
    for(int f = begin; f < end; ++f)
      link_face(surface, f, halfedges, mesh);
  });
  for(const Halfedge h : mesh.halfedges())
  {
    if(mesh.is_border(h))
      link_border(h, mesh);
    if(mesh.is_border(h) || mesh.halfedge(mesh.target(h)) == Mesh::null_halfedge())
      mesh.set_halfedge(mesh.target(h), h); // by that on a border, Surface_mesh knows its border vertices
  }
  return mesh;
}
