#ifndef UNWRAP_COMPLETE_NORMALS_H
#define UNWRAP_COMPLETE_NORMALS_H

#include "Polygon_soup.h"

// Drops what is of no use: normals that no corner has, indices of those that do not exist, and those that are not
// finite.
void complete_normals(Polygon_soup& soup);

#endif // UNWRAP_COMPLETE_NORMALS_H
