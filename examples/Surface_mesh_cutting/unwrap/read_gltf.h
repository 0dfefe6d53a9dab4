#ifndef UNWRAP_READ_GLTF_H
#define UNWRAP_READ_GLTF_H

#include "mesh_file.h"

#include <string>
#include <string_view>

// Whether the name is that of a glTF file (.gltf, .glb).
bool is_gltf(const std::string& path);

// The triangles of all meshes of the scene, transformed as it says, with vertices at exactly the same point as one:
// the format repeats vertices where attributes differ. Throws a `Failure` with `Exit_code::UNREADABLE`.
Polygon_soup read_gltf(const std::string& path, Attributes attributes);

// The same, given the bytes of a binary file, which refers to no other file.
Polygon_soup read_glb(std::string_view bytes, Attributes attributes);

#endif // UNWRAP_READ_GLTF_H
