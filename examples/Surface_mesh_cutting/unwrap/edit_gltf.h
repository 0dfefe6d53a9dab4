#ifndef UNWRAP_EDIT_GLTF_H
#define UNWRAP_EDIT_GLTF_H

#include "Gltf_content.h"
#include "Layout.h"

#include <filesystem>
#include <string>

// The glTF file from which the layout comes, with other texture coordinates, and vertices repeated where these differ; all
// else stays as it is. `png`, if not empty, is the image of the material that all triangles get; `has_new_tangents`, whether
// all that have normals get tangents, too. The file will be in `folder`.
gltf::Content edited_gltf(const Layout& layout, const std::string& png, bool has_new_tangents,
                          const std::filesystem::path& folder);

#endif // UNWRAP_EDIT_GLTF_H
