#include "halfedge_arrays.h"

using CGAL::Surface_mesh_cutting::internal::Halfedge_arrays;

Halfedge_arrays halfedge_arrays(const Mesh& mesh)
{
  Halfedge_arrays arrays;
  const auto face_side = [&](Halfedge h) { return mesh.is_border(h) ? -1 : int(h); };
  for(const Halfedge h : mesh.halfedges())
  {
    const bool is_border = mesh.is_border(h);
    arrays.next.push_back(is_border ? -1 : int(mesh.next(h)));
    arrays.previous.push_back(is_border ? -1 : int(mesh.prev(h)));
    arrays.opposite.push_back(face_side(mesh.opposite(h)));
    arrays.target.push_back(int(mesh.target(h)));
  }
  for(const Vertex v : mesh.vertices())
  {
    const Kernel::Point_3& p = mesh.point(v);
    arrays.points.emplace_back(p.x(), p.y(), p.z());
  }
  return arrays;
}
