#ifndef UNWRAP_READ_GLTF_H
#define UNWRAP_READ_GLTF_H

#include "mesh_file.h"

#include <string>
#include <string_view>
#include <vector>

// The triangles of all meshes of a glTF file (.gltf, .glb), transformed as its scene says. Vertices at exactly the same
// point are one within a mesh, as the format repeats vertices where attributes differ. If the source is wanted, each mesh
// is read once, at the size at which the scene shows it first. Throws a `Failure` with `Exit_code::UNREADABLE`.
Polygon_soup read_gltf(const std::string& path, Attributes attributes);

// The same, given the bytes of a file that refers to no other file.
Polygon_soup read_glb(std::string_view bytes, Attributes attributes);

// The files to which a glTF file refers, whether they exist or not; none if that cannot be found out.
std::vector<std::string> files_of_gltf(const std::string& path);

#endif // UNWRAP_READ_GLTF_H
