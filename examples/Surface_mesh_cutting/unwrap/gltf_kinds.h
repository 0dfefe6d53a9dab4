// What a glTF file holds besides the triangles of its meshes.

#ifndef UNWRAP_GLTF_KINDS_H
#define UNWRAP_GLTF_KINDS_H

#include "Data_kinds.h"
#include "Gltf_document.h"

#include <string>

namespace gltf {

Data_kinds kinds_of(const Document& document);

// Lists, as words, the data that belong to the texture coordinates and stay as they are when these change.
std::string list_outdated(const Document& document, int uv_set, bool has_new_tangents);

} // namespace gltf

#endif // UNWRAP_GLTF_KINDS_H
