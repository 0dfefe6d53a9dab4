// Colors that sculpting programs hide in comments of OBJ: #MRGB and then eight hexadecimal digits for each point, a mask,
// red, green and blue.

#ifndef UNWRAP_PAINTED_COLORS_H
#define UNWRAP_PAINTED_COLORS_H

#include "Polygon_soup.h"

#include <array>
#include <string_view>
#include <vector>

using Colors = std::vector<std::array<double, 3> >;

// Adds those of a comment, if it is such a one.
void read_painted_colors(std::string_view comment, Colors& colors);

// Gives them to the points if each has one and no other one.
void add_painted_colors(const Colors& colors, Polygon_soup& soup);

#endif // UNWRAP_PAINTED_COLORS_H
