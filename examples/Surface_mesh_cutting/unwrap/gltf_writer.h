#ifndef UNWRAP_GLTF_WRITER_H
#define UNWRAP_GLTF_WRITER_H

#include "Layout.h"

#include <string>

// The triangles of the surface with texture coordinates, as binary glTF 2.0. `png`, if not empty, is the image of the
// material. Vertices are repeated where texture coordinates differ. Numbers have single precision.
std::string to_glb(const Layout& layout, const std::string& png);

// What that keeps of the input.
Data_kinds kinds_in_glb(const Layout& layout, bool has_own_material);

#endif // UNWRAP_GLTF_WRITER_H
