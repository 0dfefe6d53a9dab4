// What a glTF file holds besides the triangles of its meshes.

#ifndef UNWRAP_GLTF_KINDS_H
#define UNWRAP_GLTF_KINDS_H

#include "Data_kinds.h"
#include "Gltf_document.h"

#include <string>

namespace gltf {

Data_kinds kinds_of(const Document& document);

// What belongs to its texture coordinates, as words; empty if nothing does.
std::string list_outdated(const Document& document);

} // namespace gltf

#endif // UNWRAP_GLTF_KINDS_H
