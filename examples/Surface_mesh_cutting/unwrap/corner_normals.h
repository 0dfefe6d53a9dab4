#ifndef UNWRAP_CORNER_NORMALS_H
#define UNWRAP_CORNER_NORMALS_H

#include "Layout.h"

#include <array>
#include <vector>

using Unit_normal = std::array<float, 3>;

// Per corner of all polygons, a normal of length one: that of the file, or where that has none, the mean of the
// triangles around the vertex, weighted by area. Cuts are smooth, too.
std::vector<Unit_normal> corner_normals(const Layout& layout);

#endif // UNWRAP_CORNER_NORMALS_H
