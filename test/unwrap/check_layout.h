// An independent judge of what the program is about to write.

#ifndef CHECK_LAYOUT_H
#define CHECK_LAYOUT_H

#include "Layout.h"
#include "Polygon_soup.h"

#include <string>

// What is wrong with the layout of a soup, or nothing: every triangle is there, lies counterclockwise, every
// chart is a disk and, if `is_bijective`, no two edges on the border properly cross. Exact and quadratic.
std::string find_fault(const Layout& layout, const Polygon_soup& soup, bool is_bijective);

#endif // CHECK_LAYOUT_H
