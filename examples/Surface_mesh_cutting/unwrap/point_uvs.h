// Texture coordinates given per point, as in formats where points at a seam are repeated.

#ifndef UNWRAP_POINT_UVS_H
#define UNWRAP_POINT_UVS_H

#include "Polygon_soup.h"

#include <optional>
#include <vector>

using Point_uvs = std::vector<std::optional<Polygon_soup::Texture_point> >;

// Each corner gets those of its point. Indices of points may be out of range.
void set_corner_uvs(const Point_uvs& uvs, Polygon_soup& soup);

#endif // UNWRAP_POINT_UVS_H
