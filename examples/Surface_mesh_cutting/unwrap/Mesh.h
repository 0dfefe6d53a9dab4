// The mesh on which the library runs.

#ifndef UNWRAP_MESH_H
#define UNWRAP_MESH_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;
using Face = Mesh::Face_index;
using Cut_map = Mesh::Property_map<Edge, bool>;
using UV_map = Mesh::Property_map<Halfedge, Kernel::Point_2>; // of the corner at the target

#endif // UNWRAP_MESH_H
