// The two sides of each piece of the cut in the same color and with the same number.

#ifndef UNWRAP_PARTNER_PICTURE_H
#define UNWRAP_PARTNER_PICTURE_H

#include "Layout.h"
#include "Number_writer.h"

#include <array>
#include <functional>

// `view` takes points of the layout to the picture. A piece of the cut lies between two points at which pieces meet or
// end, or feature points.
void draw_partners(const Layout& layout, const std::function<std::array<double, 2>(const std::array<double, 2>&)>& view,
                   Number_writer& out);

#endif // UNWRAP_PARTNER_PICTURE_H
