// What a polygon soup must fulfil to be a mesh of triangles as it is, and to be read as any surface.

#ifndef UNWRAP_SOUP_CHECKS_H
#define UNWRAP_SOUP_CHECKS_H

#include "Polygon_soup.h"

// Throws a `Failure` with `Exit_code::UNSUPPORTED` unless the soup is a consistently oriented
// manifold of triangles with finite coordinates. Its message names the first of the elements
// concerned, its witness up to a hundred of them. Takes O(n log n).
void check_soup(const Polygon_soup& soup);

// The same unless it has polygons, and the points that they use have finite coordinates.
void check_points(const Polygon_soup& soup);

#endif // UNWRAP_SOUP_CHECKS_H
