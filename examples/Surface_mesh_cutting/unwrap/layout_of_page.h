// One page of a layout, for files that hold no others.

#ifndef UNWRAP_LAYOUT_OF_PAGE_H
#define UNWRAP_LAYOUT_OF_PAGE_H

#include "Layout.h"

// A mesh of the polygons on the page and of their points, in the unit square. Of what OBJ says besides, statements stay that
// do not refer to points. Without a cut, which leads to other pages.
Layout mesh_of_page(const Layout& layout, int page);

// The same layout, where it is, with the triangles and borders of the page only: pieces of the cut keep their numbers.
Layout picture_of_page(const Layout& layout, int page);

// The kinds that are in no mesh of a page.
Data_kinds kinds_not_on_pages();

#endif // UNWRAP_LAYOUT_OF_PAGE_H
