// The triangles of a layout as an image, colored by distortion.

#ifndef UNWRAP_DISTORTION_IMAGE_H
#define UNWRAP_DISTORTION_IMAGE_H

#include "Image.h"
#include "Layout.h"

#include <array>

// Colors of equal perceived distance (after magma of matplotlib), from no distortion to much.
constexpr std::array<Image::Color, 9> distortion_colors = {{
  {{252, 253, 191}}, {{254, 196, 136}}, {{252, 137, 97}}, {{231, 82, 99}}, {{183, 55, 121}},
  {{131, 38, 129}}, {{81, 18, 124}}, {{29, 17, 71}}, {{0, 0, 4}}}};

// Where a symmetric Dirichlet energy lies on that scale, from 0 to 1: proportional to the logarithm
// of the stretch s for which a map with singular values s and 1/s has this energy; 1 is s = 4.
double position_on_scale(double energy);

// The image covers the rectangle from `low` with `width` times `height` pixels of size `pixel`;
// v goes up.
Image draw_distortion(const Layout& layout, const std::array<double, 2>& low, double pixel,
                      int width, int height);

#endif // UNWRAP_DISTORTION_IMAGE_H
