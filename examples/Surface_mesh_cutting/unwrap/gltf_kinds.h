// What a glTF file holds besides the triangles of its meshes.

#ifndef UNWRAP_GLTF_KINDS_H
#define UNWRAP_GLTF_KINDS_H

#include "Data_kinds.h"
#include "Gltf_document.h"

#include <string>

namespace gltf {

Data_kinds kinds_of(const Document& document);

// What belongs to its texture coordinates and stays as it is when these change, as words; empty if nothing does.
std::string list_outdated(const Document& document, bool has_new_tangents);

} // namespace gltf

#endif // UNWRAP_GLTF_KINDS_H
