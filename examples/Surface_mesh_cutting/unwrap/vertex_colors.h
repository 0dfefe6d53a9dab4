// The red channel of the colors of points, while it is read.

#ifndef UNWRAP_VERTEX_COLORS_H
#define UNWRAP_VERTEX_COLORS_H

#include "Polygon_soup.h"
#include "Text_scanner.h"

// Adds the next number in the line, if there are at least two more: then it is the red channel of a color.
void read_red(Text_scanner& scanner, Polygon_soup& soup);

// Brings them to the scale from 0 to 1: they are at one to 255 if one of them is above 1. Drops them unless each
// point has one. Throws a `Failure` with `Exit_code::UNREADABLE` if one is below 0 or above 255.
void complete_reds(Polygon_soup& soup);

#endif // UNWRAP_VERTEX_COLORS_H
