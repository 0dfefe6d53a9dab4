#ifndef UNWRAP_HALFEDGE_ARRAYS_H
#define UNWRAP_HALFEDGE_ARRAYS_H

#include "Mesh.h"

#include <CGAL/Surface_mesh_cutting/internal/surface/Halfedge_arrays.h>

// The halfedges of faces, by their numbers.
CGAL::Surface_mesh_cutting::internal::Halfedge_arrays halfedge_arrays(const Mesh& mesh);

#endif // UNWRAP_HALFEDGE_ARRAYS_H
