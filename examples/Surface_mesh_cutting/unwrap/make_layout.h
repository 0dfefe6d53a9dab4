#ifndef UNWRAP_MAKE_LAYOUT_H
#define UNWRAP_MAKE_LAYOUT_H

#include "Layout.h"
#include "Mesh.h"
#include "Polygon_soup.h"

// The layout as it is to be written, with the vertices and triangles of `soup`, of which `mesh` was
// made. Feature points and distortions are left to the caller.
// Throws a `Failure` if the UVs are not those of a layout cut exactly at the marked edges.
Layout make_layout(const Mesh& mesh, Cut_map is_cut, UV_map uvs, const Polygon_soup& soup);

#endif // UNWRAP_MAKE_LAYOUT_H
