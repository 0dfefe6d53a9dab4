// A checkerboard by which any viewer shows how the layout stretches the surface.

#ifndef UNWRAP_TEXTURE_H
#define UNWRAP_TEXTURE_H

#include "Layout.h"

#include <string>

constexpr const char* material_name = "checkerboard";

// A PNG image that can be repeated.
std::string checkerboard_png();

// The material file; `image` is the image's name as seen from there.
std::string to_mtl(const Layout& layout, const std::string& image);

#endif // UNWRAP_TEXTURE_H
