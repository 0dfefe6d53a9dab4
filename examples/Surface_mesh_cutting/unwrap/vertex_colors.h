// Colors of vertices in formats of text.

#ifndef UNWRAP_VERTEX_COLORS_H
#define UNWRAP_VERTEX_COLORS_H

#include "Polygon_soup.h"
#include "Text_scanner.h"

#include <array>
#include <optional>
#include <vector>

// Adds the color that the next words of the line are, if there are three. What is no number becomes NaN.
void read_color(Text_scanner& scanner, Polygon_soup& soup);

// Drops the colors unless all points have one. Where one is above 1, they are from 0 to 255, else from 0 to 1.
void complete_colors(Polygon_soup& soup);

// From 0 to 255 to from 0 to 1, if one is above 1.
void complete_fractions(std::vector<std::array<double, 3> >& colors);

// A vertex whose color is not from 0 to 1.
std::optional<int> find_wrong_color(const Polygon_soup& soup);

#endif // UNWRAP_VERTEX_COLORS_H
