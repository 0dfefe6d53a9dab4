// A mesh of polygons whose neighbors are known.

#ifndef UNWRAP_MAKE_MESH_H
#define UNWRAP_MAKE_MESH_H

#include "Mesh.h"

#include <CGAL/Surface_mesh_cutting/internal/soup/Soup_surface.h>

#include <vector>

// The halfedge of each side. Those from a lower vertex to a higher one are the first of their edges. Edges are in the order
// in which the polygons meet these sides; behind them are those that have no such side.
std::vector<Halfedge> number_halfedges(const CGAL::Surface_mesh_cutting::internal::Soup_surface& surface);

// Vertices and faces have the numbers that they have in `surface`, halfedges those in `halfedges`. The first halfedge of a
// triangle leads to its first corner, that of a larger polygon from there, since many programs triangulate from the first
// corner in the file.
Mesh make_mesh(const CGAL::Surface_mesh_cutting::internal::Soup_surface& surface,
               const std::vector<Halfedge>& halfedges);

#endif // UNWRAP_MAKE_MESH_H
