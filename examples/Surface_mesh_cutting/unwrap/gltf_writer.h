#ifndef UNWRAP_GLTF_WRITER_H
#define UNWRAP_GLTF_WRITER_H

#include "Gltf_content.h"
#include "Layout.h"

#include <array>
#include <cstddef>
#include <string>

// A file of glTF 2.0, binary if `path` ends in .glb, else text that holds all data. If the layout comes from such a file,
// that file with other texture coordinates; else the triangles of the surface. `png`, if not empty, is the image of the
// material. Vertices are repeated where texture coordinates differ. Numbers have single precision. `has_tangents`: whether
// these are computed for all triangles with normals.
std::string to_gltf(const Layout& layout, const std::string& png, bool has_tangents, const std::string& path);

// As the format holds it: images begin at the top.
std::array<float, 2> gltf_uv(const std::array<double, 2>& uv);

// The material that shows a texture, by the coordinates of a set.
gltf::Json textured_material(std::size_t texture, int uv_set);

// What that keeps of the input.
Data_kinds kinds_in_gltf(const Layout& layout, bool has_own_material, bool has_tangents);

#endif // UNWRAP_GLTF_WRITER_H
