#include "Surface.h"

#include "outcome.h"

#include <CGAL/Surface_mesh_cutting/internal/indexed_functions.h>
#include <CGAL/Surface_mesh_cutting/internal/soup/name_of_interpretation.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/container/small_vector.hpp>

#ifndef CGAL_SURFACE_MESH_CUTTING_USE_LIBRARY
#include <CGAL/Surface_mesh_cutting/internal/indexed_functions/read_soup.h>
#endif

#include <algorithm>

namespace {

namespace SMC = CGAL::Surface_mesh_cutting;

SMC::internal::Soup_surface read(const Polygon_soup& soup, bool do_weld)
{
  std::vector<SMC::internal::Point> points;
  points.reserve(soup.points.size());
  for(const Polygon_soup::Point& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  SMC::internal::Polygons polygons;
  polygons.vertices = soup.corners;
  polygons.ends.assign(soup.polygon_ends.begin(), soup.polygon_ends.end());
  return SMC::internal::read_soup(points, polygons, do_weld);
}

Mesh make_mesh(const SMC::internal::Soup_surface& surface)
{
  Mesh mesh;
  mesh.reserve(Mesh::size_type(surface.points.size()),
               Mesh::size_type(surface.points.size() + surface.polygon_origins.size()),
               Mesh::size_type(surface.polygon_origins.size()));
  for(const SMC::internal::Point& p : surface.points)
    mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));

  std::vector<boost::container::small_vector<Vertex, 4> > faces(surface.polygon_origins.size());
  for(int f = 0; f < surface.polygons.number(); ++f)
    for(int c = surface.polygons.begin(f); c < surface.polygons.end(f); ++c)
      faces[std::size_t(f)].push_back(Vertex(Mesh::size_type(surface.polygons.vertices[std::size_t(c)])));
  CGAL::Euler::add_faces(faces, mesh);
  for(const Halfedge h : mesh.halfedges())
    if(mesh.is_border(h))
      mesh.set_halfedge(mesh.target(h), h); // by which Surface_mesh knows its border vertices
  return mesh;
}

Interpretation translate(const SMC::Interpretation& finding)
{
  Interpretation result = {SMC::internal::name_of(finding.kind), {}, {}};
  result.elements.assign(finding.vertices.begin(), finding.vertices.end());
  result.elements.insert(result.elements.end(), finding.polygons.begin(), finding.polygons.end());
  for(const auto& edge : finding.edges)
    result.edges.emplace_back(int(edge[0]), int(edge[1]));
  return result;
}

// Makes the library see the first corner of the file first, from which many programs triangulate polygons.
void set_first_corners(const std::vector<Halfedge>& halfedges, const SMC::internal::Polygons& polygons, Mesh& mesh)
{
  for(int f = 0; f < polygons.number(); ++f)
    if(polygons.size(f) > 3)
      mesh.set_halfedge(Face(Mesh::size_type(f)), mesh.next(halfedges[std::size_t(polygons.begin(f))]));
}

// The halfedge that leads to each corner of the polygons.
std::vector<Halfedge> halfedges_of_corners(const SMC::internal::Polygons& polygons, const Mesh& mesh)
{
  std::vector<Halfedge> result;
  result.reserve(polygons.vertices.size());
  for(int f = 0; f < polygons.number(); ++f)
  {
    Halfedge h = mesh.halfedge(Face(Mesh::size_type(f)));
    while(int(mesh.target(h)) != polygons.vertices[std::size_t(polygons.begin(f))])
      h = mesh.next(h);
    for(int k = 0; k < polygons.size(f); ++k, h = mesh.next(h))
      result.push_back(h);
  }
  return result;
}

} // namespace

Surface read_surface(const Polygon_soup& soup, bool do_weld)
{
  const SMC::internal::Soup_surface read_as = read(soup, do_weld);
  if(read_as.polygons.number() == 0)
    throw Failure(Exit_code::UNSUPPORTED, "no face is part of a surface: each uses a vertex twice or has fewer than three");

  Surface surface;
  surface.mesh = make_mesh(read_as);
  surface.vertices = read_as.origins;
  surface.polygons = read_as.polygon_origins;
  const std::vector<Halfedge> halfedges = halfedges_of_corners(read_as.polygons, surface.mesh);
  set_first_corners(halfedges, read_as.polygons, surface.mesh);
  surface.corners.assign(surface.mesh.num_halfedges(), -1);
  surface.halfedges.reserve(read_as.corners.size());
  for(std::size_t c = 0; c < read_as.corners.size(); ++c)
  {
    const Halfedge h = halfedges[std::size_t((std::max)(read_as.corners[c], 0))]; // away from the surface, any
    surface.halfedges.push_back(h);
    if(read_as.is_on_surface[c])
      surface.corners[h] = int(c);
  }
  for(const SMC::Interpretation& finding : read_as.findings)
    surface.interpreted.push_back(translate(finding));
  return surface;
}
