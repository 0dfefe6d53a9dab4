// The layout that the input brings, for --pack-only.

#ifndef UNWRAP_GIVEN_LAYOUT_H
#define UNWRAP_GIVEN_LAYOUT_H

#include "Mesh.h"
#include "Polygon_soup.h"
#include "Surface.h"
#include "outcome.h"

// Marks its seams. Throws a `Failure` if a polygon of the surface has no texture coordinates.
void read_given_layout(const Polygon_soup& soup, const Surface& surface, Cut_map is_cut, UV_map uvs);

// Its scale: that of an equal area, in UV units per unit of length.
double scale_of_layout(const Mesh& mesh, UV_map uvs);

// Whether charts overlap themselves; those that lie on other charts do not count.
bool has_overlaps(const Mesh& mesh, Cut_map is_cut, UV_map uvs);

// Tells its measures, once it is packed, and warns of what was wrong with it before. The scale is known.
void tell_given_layout(const Mesh& mesh, Cut_map is_cut, UV_map uvs, Outcome& outcome);

#endif // UNWRAP_GIVEN_LAYOUT_H
