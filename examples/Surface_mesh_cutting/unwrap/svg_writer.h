#ifndef UNWRAP_SVG_WRITER_H
#define UNWRAP_SVG_WRITER_H

#include "Layout.h"
#include "options.h"
#include "outcome.h"

#include <optional>
#include <string>

// A picture of the layout: triangles colored by distortion, chart borders, feature points; and a plot
// of the trade-off between length and distortion.
// The triangles come as an image, so that the size of the file is bounded for any mesh. With `only_page`, the picture shows
// its square, and the layout has triangles and borders on no other page.
std::string to_svg(const Layout& layout, const Outcome& outcome, const std::string& style,
                   std::optional<int> only_page = std::nullopt);

#endif // UNWRAP_SVG_WRITER_H
