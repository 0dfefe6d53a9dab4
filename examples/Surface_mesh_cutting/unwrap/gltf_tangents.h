#ifndef UNWRAP_GLTF_TANGENTS_H
#define UNWRAP_GLTF_TANGENTS_H

#include "Layout.h"
#include "tangents.h"

#include <vector>

// Those of the layout of a glTF file, per corner of the soup; any where a primitive has no normals, as it needs none.
std::vector<Tangent> gltf_tangents(const Layout& layout);

#endif // UNWRAP_GLTF_TANGENTS_H
