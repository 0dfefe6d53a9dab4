// The seams of the texture coordinates that the input brings.

#ifndef UNWRAP_UV_SEAMS_H
#define UNWRAP_UV_SEAMS_H

#include "Polygon_soup.h"
#include "Surface.h"

#include <string>
#include <vector>

// The edges whose two faces differ in the coordinates of at least one end. `surface` is read from the
// soup. Throws a `Failure` with `Exit_code::UNSUPPORTED` that names the option if no corner has coordinates.
std::vector<Edge> uv_seams(const std::string& option, const Polygon_soup& soup, const Surface& surface);

#endif // UNWRAP_UV_SEAMS_H
