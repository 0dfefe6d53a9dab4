#ifndef UNWRAP_PLY_WRITER_H
#define UNWRAP_PLY_WRITER_H

#include "Layout.h"

#include <string>

// The mesh with its texture coordinates, as a list `texcoord` of each face. `texture`, if not empty, is the file that
// holds the image.
std::string to_ply(const Layout& layout, const std::string& texture);

#endif // UNWRAP_PLY_WRITER_H
