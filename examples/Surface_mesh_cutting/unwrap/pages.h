// The pages of an atlas.

#ifndef UNWRAP_PAGES_H
#define UNWRAP_PAGES_H

#include "Layout.h"
#include "options.h"

// Finds the pages of a layout of several, which lie side by side in the plane. Unless files are to have them as tiles, it
// says what takes each UV vertex to the unit square, and adds a group for each page to the statements.
void place_pages(const Options& options, int number_of_pages, Layout& layout);

#endif // UNWRAP_PAGES_H
