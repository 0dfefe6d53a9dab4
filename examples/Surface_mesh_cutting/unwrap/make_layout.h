#ifndef UNWRAP_MAKE_LAYOUT_H
#define UNWRAP_MAKE_LAYOUT_H

#include "Layout.h"
#include "Polygon_soup.h"
#include "Surface.h"

// The polygons of a soup, without triangles and UVs, and what their file says besides.
Layout layout_without_uvs(const Polygon_soup& soup);

// The layout as it is to be written, with the vertices and polygons of `soup`, from which `surface` was
// read. `uv_scale`: of the UVs, per unit of length. Feature points are left to the caller.
// Throws a `Failure` if the UVs are not those of a layout cut exactly at the marked edges.
Layout make_layout(const Surface& surface, Cut_map is_cut, UV_map uvs, const Polygon_soup& soup, double uv_scale);

#endif // UNWRAP_MAKE_LAYOUT_H
