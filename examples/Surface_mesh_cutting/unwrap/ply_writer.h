#ifndef UNWRAP_PLY_WRITER_H
#define UNWRAP_PLY_WRITER_H

#include "Layout.h"

#include <string>

// The mesh with its texture coordinates, as a list `texcoord` of each face: the file of the input, with nothing else
// changed, if that is PLY. `image`, if not empty, is the file of the texture.
std::string to_ply(const Layout& layout, const std::string& image);

// What that keeps of the input.
Data_kinds kinds_in_ply(const Layout& layout);

#endif // UNWRAP_PLY_WRITER_H
