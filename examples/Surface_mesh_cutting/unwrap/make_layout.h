#ifndef UNWRAP_MAKE_LAYOUT_H
#define UNWRAP_MAKE_LAYOUT_H

#include "Layout.h"
#include "Polygon_soup.h"
#include "Surface.h"

// The polygons of a soup, without triangles and UVs, and what their file says besides.
Layout layout_without_uvs(const Polygon_soup& soup);

// The layout as it is to be written, with the vertices and polygons of `soup`, from which `surface` was
// read. Where its UV vertices lie, and feature points, are left to the caller.
Layout make_layout(const Surface& surface, Cut_map is_cut, const Polygon_soup& soup);

// Places the UV vertices. Throws a `Failure` if the UVs are not those of a layout cut exactly at the marked edges.
void place_uv_vertices(const Surface& surface, UV_map uvs, Layout& layout);

#endif // UNWRAP_MAKE_LAYOUT_H
