// The triangles of a layout as an image, colored by distortion.

#ifndef UNWRAP_DISTORTION_IMAGE_H
#define UNWRAP_DISTORTION_IMAGE_H

#include "Image.h"
#include "Layout.h"

#include <array>

// From no distortion to much, of the picture and of the page: from cream over yellow to blue, darker at each step, after
// cividis (Nuñez, Anderton, Renslow 2018), which is read alike with and without color vision deficiency.
constexpr std::array<Image::Color, 9> distortion_colors = {{
  {{251, 247, 233}}, {{243, 228, 176}}, {{226, 203, 106}}, {{181, 167, 112}}, {{138, 135, 120}},
  {{98, 103, 114}}, {{64, 78, 112}}, {{20, 54, 114}}, {{0, 32, 76}}}};

// Where a symmetric Dirichlet energy lies on that scale, from 0 to 1: proportional to the logarithm of the stretch; 1 is
// four times as long.
double position_on_scale(double energy);

// The image covers the rectangle from `low` with `width` times `height` pixels of size `pixel`;
// v goes up.
Image draw_distortion(const Layout& layout, const std::array<double, 2>& low, double pixel,
                      int width, int height);

#endif // UNWRAP_DISTORTION_IMAGE_H
